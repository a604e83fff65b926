#include "homogenisation/debonding_words.hpp"

#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace breccia {
namespace {

constexpr double per_cent = 100.0;

std::string_view words_on(Debonding kind) {
  switch (kind) {
    case Debonding::open:
      return "open gaps";
    case Debonding::sealed:
      return "sealed gaps";
    case Debonding::slip:
      return "films that slide along one of their grains";
  }
  return {};
}

std::string_view meaning_of(Debonding kind) {
  switch (kind) {
    case Debonding::open:
      return "gaps, which carry nothing and take the pressure from the binder around them; one that closes carries "
             "nothing here, in reality it would";
    case Debonding::sealed:
      return "gaps, which carry nothing while the binder around them keeps its pressure; one that closes carries "
             "nothing here, in reality it would";
    case Debonding::slip:
      return "free to slide along one of their grains, without friction and without coming off it";
  }
  return {};
}

}  // namespace

std::string words_on_bonds(const Stage& stage) {
  if (!stage.bonds) return {};
  const auto& [debonded, kind, seed, normal, films] = *stage.bonds;
  if (!films.empty()) {
    return fmt::format("the films between {} pair{} of grains are {}", films.size(), films.size() == 1 ? "" : "s",
                       words_on(kind));
  }
  const auto which = normal.empty()
                         ? fmt::format("at random (seed {})", seed.value_or(stage.seed().value_or(1)))
                         : fmt::format("those whose normals are closest to ({:.4g})", fmt::join(normal, ", "));
  return fmt::format("{:.4g} % of the films, {}, are {}", per_cent * debonded, which, words_on(kind));
}

std::string words_on_debonding(const Stage& stage, const GrainStatistics& grains) {
  if (!stage.bonds) return {};
  return fmt::format("{} film{}, {:.3g} % of the {} of all, {} {}", grains.debonded_films,
                     grains.debonded_films == 1 ? "" : "s", per_cent * grains.debonded,
                     stage.dimensions() == 3 ? "area" : "length", grains.debonded_films == 1 ? "is" : "are",
                     meaning_of(stage.bonds->kind));
}

}  // namespace breccia
