#include "homogenisation/debonding_words.hpp"

#include <string>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "films/assembly/debonded_set.hpp"
#include "io/units.hpp"

namespace breccia {
namespace {

constexpr double per_cent = 100.0;

/// What debonded films of a kind are, and what follows from it.
struct KindInWords {
  std::string name, consequence;
};

/// The stiffness of springs: "1 GPa/um across and 500 MPa/um along the films".
std::string words_on(const InterfaceStiffness& springs) {
  return fmt::format("{} across and {} along the films", readable(springs.normal, Dimension::interface_stiffness),
                     readable(springs.tangential, Dimension::interface_stiffness));
}

KindInWords words_on(const FilmBonds& bonds) {
  switch (bonds.kind) {
    case Debonding::open:
      return {"open gaps", ", which carry nothing and take the pressure from the binder around them"};
    case Debonding::sealed:
      return {"sealed gaps", ", which carry nothing while the binder around them keeps its pressure"};
    case Debonding::slip:
      return {"slip", " along one of their grains, without friction and without coming off it"};
    case Debonding::spring:
      return {words_on(bonds.springs), ", by which one of their grains holds them"};
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

std::string_view state_of(Debonding kind) {
  return kind == Debonding::spring ? "on springs" : "debonded";
}

std::string words_on_bonds(const Stage& stage) {
  if (!stage.bonds) return {};
  const auto& bonds = *stage.bonds;
  const auto how_many =
      bonds.films.empty() ? fmt::format("{:.4g} % of the films", per_cent * bonds.debonded) : std::string("films");
  return fmt::format("{} {}, {}: {}", how_many, state_of(bonds.kind), choice_of(stage), words_on(bonds).name);
}

std::string words_on_debonding(const Stage& stage, const GrainStatistics& grains) {
  if (!stage.bonds) return {};
  const auto kind = stage.bonds->kind;
  const auto [name, consequence] = words_on(*stage.bonds);
  const auto* const closing =
      films::is_gap(kind) ? "; a gap that closes carries nothing here, in reality it would" : "";
  return fmt::format("{} film{} {}, {:.3g} % of the {} of all, {}: {}{}{}", grains.debonded_films,
                     grains.debonded_films == 1 ? "" : "s", state_of(kind), per_cent * grains.debonded,
                     stage.dimensions() == 3 ? "area" : "length", choice_of(stage), name, consequence, closing);
}

}  // namespace breccia
