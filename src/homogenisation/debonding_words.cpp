#include "homogenisation/debonding_words.hpp"

#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace breccia {
namespace {

constexpr double per_cent = 100.0;

/// What debonded films of a kind are, and what follows from it.
struct KindInWords {
  std::string_view name, consequence;
};

KindInWords words_on(Debonding kind) {
  switch (kind) {
    case Debonding::open:
      return {"open gaps", ", which carry nothing and take the pressure from the binder around them"};
    case Debonding::sealed:
      return {"sealed gaps", ", which carry nothing while the binder around them keeps its pressure"};
    case Debonding::slip:
      return {"slip", " along one of their grains, without friction and without coming off it"};
  }
  return {};
}

/// Which films are debonded: "at random (seed 3)".
std::string choice_of(const Stage& stage) {
  const auto& bonds = *stage.bonds;
  if (!bonds.films.empty()) return "as listed";
  if (!bonds.normal.empty()) return fmt::format("those across the direction ({:.4g})", fmt::join(bonds.normal, ", "));
  return fmt::format("at random (seed {})", bonds.seed.value_or(stage.seed().value_or(1)));
}

}  // namespace

std::string words_on_bonds(const Stage& stage) {
  if (!stage.bonds) return {};
  const auto& bonds = *stage.bonds;
  const auto how_many =
      bonds.films.empty() ? fmt::format("{:.4g} % of the films", per_cent * bonds.debonded) : std::string("films");
  return fmt::format("{} debonded, {}: {}", how_many, choice_of(stage), words_on(bonds.kind).name);
}

std::string words_on_debonding(const Stage& stage, const GrainStatistics& grains) {
  if (!stage.bonds) return {};
  const auto& [name, consequence] = words_on(stage.bonds->kind);
  const auto* const closing =
      stage.bonds->kind == Debonding::slip ? "" : "; a gap that closes carries nothing here, in reality it would";
  return fmt::format("{} film{} debonded, {:.3g} % of the {} of all, {}: {}{}{}", grains.debonded_films,
                     grains.debonded_films == 1 ? "" : "s", per_cent * grains.debonded,
                     stage.dimensions() == 3 ? "area" : "length", choice_of(stage), name, consequence, closing);
}

}  // namespace breccia
