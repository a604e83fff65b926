#include "homogenisation/debonding_words.hpp"

#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace breccia {
namespace {

constexpr double per_cent = 100.0;

std::string_view name_of_films(Debonding kind) {
  switch (kind) {
    case Debonding::open:
      return "open gaps";
    case Debonding::sealed:
      return "sealed gaps";
    case Debonding::slip:
      return "films that slip";
  }
  return {};
}

std::string_view meaning_of(Debonding kind) {
  switch (kind) {
    case Debonding::open:
      return "open gaps, which carry nothing and take the pressure from the binder around them";
    case Debonding::sealed:
      return "sealed gaps, which carry nothing while the binder around them keeps its pressure";
    case Debonding::slip:
      return "free to slide along one of their grains, without friction and without coming off it";
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
  return fmt::format("{}, {}, are {}", how_many, choice_of(stage), name_of_films(bonds.kind));
}

std::string words_on_debonding(const Stage& stage, const GrainStatistics& grains) {
  if (!stage.bonds) return {};
  const bool are_gaps = stage.bonds->kind != Debonding::slip;
  constexpr double few = 0.25;
  auto text = fmt::format("{} film{}, {:.3g} % of the {} of all, {}, {} {}", grains.debonded_films,
                          grains.debonded_films == 1 ? "" : "s", per_cent * grains.debonded,
                          stage.dimensions() == 3 ? "area" : "length", choice_of(stage),
                          grains.debonded_films == 1 ? "is" : "are", meaning_of(stage.bonds->kind));
  if (are_gaps) text += "; a gap that closes carries nothing here, in reality it would";
  if (stage.bonds->kind == Debonding::open && grains.debonded < few) {
    text += "; against resolved gaps the mean shear modulus was within 3 %, the bulk modulus up to 8 % too low";
  }
  return text;
}

}  // namespace breccia
