#include "homogenisation/grain_warnings.hpp"

#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "films/assembly/debonded_set.hpp"
#include "homogenisation/debonding_words.hpp"
#include "io/display.hpp"
#include "io/units.hpp"

namespace breccia {
namespace {

/// A warning about films in space that are resolved by too few elements, or too thick for the model of thin films.
std::optional<std::string> warning_of_films_in_space(const GrainStatistics& grains, const FilmOptions& films) {
  constexpr int least_divisions = 4;
  if (films.layers && films.divisions < least_divisions) {
    return fmt::format(
        "resolved films with {} element{} along an edge are too soft, by up to 30, 8, 4 % with 1, 2, 3 of them where "
        "the binder is soft: tests.films.divisions = {} and more serve as a check; without layers fewer are enough",
        films.divisions, films.divisions == 1 ? "" : "s", least_divisions);
  }
  constexpr double thick = 0.05;
  const double share = grains.film / grains.cells.of_half;
  if (films.layers || !(share > thick)) return std::nullopt;
  return fmt::format(
      "films of {} are {:.2g} of the size of the grains; the model of thin films was held against resolved ones up to "
      "0.03, and errs by more in thicker films; tests.films.layers = 2 resolves them, with divisions = {}",
      readable(grains.film, Dimension::length), share, least_divisions);
}

/// A warning about films that are not long compared with their thickness, as the model of films assumes.
std::optional<std::string> warning_of_short_films(const GrainStatistics& grains, const FilmOptions& films) {
  constexpr double few = 0.15;
  if (films.layers || grains.short_films < few) return std::nullopt;
  return fmt::format(
      "{:.0f} % of the length of the films is in films shorter than five times their thickness, {}, for which the "
      "model of films errs by some per cent (1.5 % with 15 % in such films, 3 % with all of them, more where they are "
      "shorter than twice their thickness); tests.films.layers = 4 resolves them",
      100.0 * grains.short_films, readable(grains.film, Dimension::length));
}

}  // namespace

std::optional<std::string> warning_of_films(const StageMicrostructure& packed, const FilmOptions& films) {
  const auto* const grains = packed.grains();
  if (grains == nullptr) return std::nullopt;
  const bool is_in_space = packed.content<Grains<3>>() != nullptr;
  return is_in_space ? warning_of_films_in_space(*grains, films) : warning_of_short_films(*grains, films);
}

namespace {

/// Springs that are far softer across than the films that they hold.
std::optional<std::string> warning_of_soft_springs(const Stage& stage, const GrainStatistics& grains) {
  const auto* const matrix = std::get_if<Material>(&stage.matrix);
  if (stage.bonds->kind != Debonding::spring || matrix == nullptr) return std::nullopt;
  constexpr double soft = 0.01;
  const double of_springs = stage.bonds->springs.normal * grains.film, of_film = matrix->bulk.unrelaxed();
  if (of_springs > soft * of_film) return std::nullopt;
  return fmt::format(
      "the springs are as soft across as films of a bulk modulus of {}, where that of the matrix is {}: almost gaps, "
      "which in reality carry pressure where they close, and the bonded corners of the grains carry the load",
      readable(of_springs, Dimension::pressure), readable(of_film, Dimension::pressure));
}

}  // namespace

std::vector<std::string> warnings_of_debonding(const Stage& stage, const StageMicrostructure& packed,
                                               const FilmOptions& films) {
  const auto* const grains = packed.grains();
  if (grains == nullptr || !stage.bonds) return {};
  const auto& bonds = *stage.bonds;
  const double share = grains->debonded;
  std::vector<std::string> warnings;
  constexpr double many = 0.25, most = 0.45, off = 0.05;
  const bool are_thin_gaps = !films.layers && films::is_gap(bonds.kind);
  if (are_thin_gaps && share > most) {
    warnings.push_back(fmt::format(
        "{:.0f} % of the films are gaps: the model was not held against resolved films with more than 40 %, and the "
        "corners of the grains, which the binder between them holds together, carry the load",
        100.0 * share));
  } else if (are_thin_gaps && share > many) {
    warnings.push_back(fmt::format(
        "{:.0f} % of the films are gaps; up to 20 % of open ones the model was within 3 % of resolved films in "
        "shear and 8 % in bulk, with 40 % it was up to 22 % too stiff in shear where the binder is stiff, since "
        "the corners of the grains carry the load then; sealed ones cannot be resolved",
        100.0 * share));
  }
  if (const auto soft = warning_of_soft_springs(stage, *grains)) warnings.push_back(*soft);
  if (bonds.films.empty() && std::abs(share - bonds.debonded) > off * bonds.debonded) {
    warnings.push_back(fmt::format(
        "{:.3g} % of the films are {} where {:.3g} % were asked for, since whole films are; a box of more grains "
        "comes closer",
        100.0 * share, state_of(bonds.kind), 100.0 * bonds.debonded));
  }
  if (!bonds.normal.empty()) {
    warnings.push_back(fmt::format(
        "films are {} across one direction, so that the composite is not isotropic: the mean of the shears, "
        "Young's modulus, Poisson's ratio and exported cards hold for no direction of it; tests.loads = "
        "\"stiffness\" has the whole stiffness",
        state_of(bonds.kind)));
  }
  return warnings;
}

std::optional<std::string> warning_of_lost_grains(const Stage& stage, const StageMicrostructure& packed) {
  const auto* const placed = packed.grains();
  if (placed == nullptr) return std::nullopt;
  const auto& film = placed->film;
  const auto &count = placed->count, &all = placed->cell_count;
  const auto &cells = placed->cells, &grains = placed->sizes;
  constexpr double few_per_cent = 0.05;
  const auto is_off = [](double size, double asked) { return std::abs(size / asked - 1.0) > few_per_cent; };
  const bool has_sizes = stage.fillers.front().sizes.has_value();
  const bool are_off =
      has_sizes && (is_off(grains.of_a_tenth, cells.of_a_tenth) || is_off(grains.of_half, cells.of_half));
  if (count == all && !are_off) return std::nullopt;
  std::vector<std::string> losses;
  if (count < all) losses.push_back(fmt::format("nothing of {} of {} grains", all - count, all));
  if (are_off) {
    losses.push_back(fmt::format(
        "little of small ones: a tenth of the {} of the grains is below {} where {} was asked for, half of it below "
        "{} where {} was",
        stage.dimensions() == 3 ? "volume" : "area", display(grains.of_a_tenth, "m"), display(cells.of_a_tenth, "m"),
        display(grains.of_half, "m"), display(cells.of_half, "m")));
  }
  return fmt::format(
      "films of {} leave {}; thinner films leave more, and the smallest grains may be in the matrix, as the particles "
      "of an earlier stage",
      display(film, "m"), fmt::join(losses, ", and "));
}

}  // namespace breccia
