#include "study/stage_rules.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include <fmt/format.h>

#include "breccia/study/phase_names.hpp"

#include "io/lower_case.hpp"
#include "io/printable.hpp"
#include "io/safe_name.hpp"
#include "io/units.hpp"
#include "study/limits.hpp"
#include "study/result_names.hpp"

namespace breccia {
namespace {

/// The diameter of the largest particle of a filler whose sizes are listed; 0 where they are drawn from a distribution.
double largest_known_diameter(const Filler& filler) {
  if (!filler.sizes) return 0.0;
  if (const auto* single = std::get_if<SingleSize>(&*filler.sizes)) return single->diameter;
  double largest = 0.0;
  if (const auto* listed = std::get_if<ListedSizes>(&*filler.sizes)) {
    for (const double diameter : listed->diameters) largest = std::max(largest, diameter);
  }
  return largest;
}

/// Distance between neighbouring particles of a regular packing [m]; nothing for any other packing.
struct SpacingIn {
  double side;

  std::optional<double> operator()(const RegularPacking& regular) const {
    return side / std::max({1, regular.columns, regular.rows});
  }
  std::optional<double> operator()(const LatticePacking& cubic) const {
    return nearest_distance(cubic.lattice) * side / std::max(1, cubic.repeats);
  }
  template <class Packing>
  std::optional<double> operator()(const Packing&) const {
    return std::nullopt;
  }
};

}  // namespace

std::vector<std::string> mistakes_of_name(const std::string& name, std::span<const Stage> earlier,
                                          const std::vector<ShiftedMaterial>& materials) {
  if (name.empty()) return {};
  std::vector<std::string> mistakes;
  if (!is_safe_name(name)) {
    mistakes.push_back(
        fmt::format(R"(expected letters, digits, "-", "_" and "." (it names a directory), got "{}")", printable(name)));
  }
  if (name.size() > longest_name) {
    mistakes.push_back(fmt::format("expected a name of at most {} letters, got {}", longest_name, name.size()));
  }
  if (name == name_of_void) mistakes.push_back(fmt::format("\"{}\" is the name of a filler without stiffness", name));
  const auto reserved = reserved_names();
  if (std::ranges::find(reserved, lower_case(name)) != reserved.end()) {
    mistakes.push_back(fmt::format("\"{}\" is the name of a file of results", name));
  }
  if (std::ranges::find(earlier, name, &Stage::name) != earlier.end()) {
    mistakes.push_back(fmt::format("another stage is called \"{}\"", name));
  }
  if (find_material(materials, name) != nullptr) {
    mistakes.push_back(fmt::format("a material is called \"{}\"", name));
  }
  return mistakes;
}

std::vector<std::string> mistakes_of_gap(const Filler& filler, double side) {
  if (!std::isfinite(filler.gap) || !(filler.gap >= side)) return {};
  return {fmt::format("a gap of {} does not fit into a box of {}", readable(filler.gap, Dimension::length),
                      readable(side, Dimension::length))};
}

std::vector<std::string> mistakes_of_diameters(const Filler& filler, const StagePacking& packing, double side) {
  std::vector<std::string> mistakes;
  const double bare = largest_known_diameter(filler);
  // A thickness that is not positive is a mistake of the coating.
  const double diameter = bare > 0.0 ? bare + 2.0 * std::max(0.0, filler.coating_thickness()) : 0.0;
  const auto* const coated = filler.coating ? " with its coating" : "";
  if (diameter >= side) {
    mistakes.push_back(fmt::format("a particle of {}{} does not fit into a box of {}",
                                   readable(diameter, Dimension::length), coated, readable(side, Dimension::length)));
  }
  const auto spacing = visit_nested(SpacingIn{side}, packing);
  if (spacing && diameter > 0.0 && diameter >= *spacing) {
    mistakes.push_back(fmt::format("particles of {}{} touch at a regular spacing of {}",
                                   readable(diameter, Dimension::length), coated,
                                   readable(*spacing, Dimension::length)));
  }
  return mistakes;
}

std::vector<std::string> mistakes_of_fractions(const Stage& stage) {
  double sum = 0.0;
  for (const auto& filler : stage.fillers) sum += filler.fraction.value_or(0.0);
  // A single fraction has been checked already.
  if (stage.fillers.size() < 2 || !(sum >= 1.0)) return {};
  return {fmt::format("the fractions of all fillers add up to {:.6g}: expected less than 1", sum)};
}

std::vector<std::string> mistakes_of_phases(const Stage& stage) {
  const auto names = phase_names(stage);
  std::vector<std::string> mistakes;
  for (auto name = names.begin(); name != names.end(); ++name) {
    if (std::find(names.begin(), name, *name) == name) continue;
    mistakes.push_back(fmt::format(
        "a filler or coating of the material \"{}\" has the name of another phase of the stage: expected another name "
        "of the material",
        *name));
  }
  return mistakes;
}

std::vector<std::string> mistakes_of_normal(const std::vector<double>& normal, int dimensions) {
  if (normal.empty()) return {};
  if (std::ssize(normal) != dimensions) {
    return {fmt::format("expected {} components, one for each dimension, got {}", dimensions, normal.size())};
  }
  const bool is_zero = std::ranges::all_of(normal, [](double component) { return component == 0.0; });
  return is_zero ? std::vector<std::string>{"expected components that are not all zero"} : std::vector<std::string>();
}

bool can_be_extrapolated(const std::vector<int>& grids) {
  return grids.size() >= 2 && grids.size() <= allowed::most_grids &&
         std::ranges::is_sorted(grids, std::ranges::less_equal());
}

}  // namespace breccia
