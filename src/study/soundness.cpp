#include "breccia/study/soundness.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

bool is_positive(double value) {
  return value > 0.0 && std::isfinite(value);
}

void check(const Material& material, const std::string& where, std::vector<std::string>& mistakes) {
  if (!is_positive(material.density)) mistakes.push_back(where + ": expected a density above zero");
  if (!is_positive(material.bulk.unrelaxed()) || !is_positive(material.shear.unrelaxed())) {
    mistakes.push_back(where + ": expected bulk and shear moduli above zero");
  }
}

/// Sizes and fraction that the packing of a filler takes.
void check(const Filler& filler, const std::string& where, std::vector<std::string>& mistakes) {
  check(filler.material, where, mistakes);
  if (!(filler.gap >= 0.0) || !std::isfinite(filler.gap))
    mistakes.push_back(where + ": expected a gap of zero or more");
  if (std::holds_alternative<ExplicitPacking>(filler.packing)) return;
  if (!filler.sizes) {
    mistakes.push_back(where + ": expected sizes; only an explicit packing has none");
  } else if (std::holds_alternative<RegularPacking>(filler.packing)) {
    if (!std::holds_alternative<SingleSize>(*filler.sizes)) {
      mistakes.push_back(where + ": expected a single size for a regular packing");
    }
  } else if (!std::holds_alternative<ListedSizes>(*filler.sizes)) {
    const double fraction = filler.fraction.value_or(0.0);
    if (!(fraction > 0.0 && fraction < 1.0)) mistakes.push_back(where + ": expected a fraction between 0 and 1");
  }
}

void check_grids(const Stage& stage, std::vector<std::string>& mistakes) {
  constexpr int fewest_cells = 2;
  const auto grids = stage.grids();
  if (!is_positive(stage.side)) mistakes.push_back(stage.name + ": expected a side of the box above zero");
  if (grids.front() < fewest_cells || !std::ranges::is_sorted(grids, std::ranges::less_equal())) {
    mistakes.push_back(
        fmt::format("{}: expected {} cells per side or more, rising from grid to grid", stage.name, fewest_cells));
  }
}

void check(const Study& study, const Stage& stage, std::vector<std::string>& mistakes) {
  const auto name_is = [&stage](const Stage& other) { return other.name == stage.name; };
  if (stage.name.empty()) mistakes.emplace_back("a stage without a name");
  if (std::ranges::count_if(study.stages, name_is) > 1) mistakes.push_back(stage.name + ": two stages have this name");
  check_grids(stage, mistakes);
  if (const auto* material = std::get_if<Material>(&stage.matrix)) {
    check(*material, stage.name + ", matrix", mistakes);
  } else {
    const auto& earlier = std::get<EarlierStage>(stage.matrix).name;
    const auto this_one = std::ranges::find_if(study.stages, name_is);
    const bool is_there =
        std::any_of(study.stages.begin(), this_one, [&earlier](const Stage& other) { return other.name == earlier; });
    if (!is_there) mistakes.push_back(fmt::format("{}: no earlier stage \"{}\" for its matrix", stage.name, earlier));
  }
  if (stage.filler) check(*stage.filler, stage.name + ", filler", mistakes);
}

void check(const Tests& tests, std::vector<std::string>& mistakes) {
  if (!is_positive(tests.first_time) || !(tests.last_time > tests.first_time) || !std::isfinite(tests.last_time)) {
    mistakes.emplace_back("tests: expected first_time < last_time, both above zero");
  }
  if (tests.loads.empty()) mistakes.emplace_back("tests: expected a load");
  if (tests.boundaries.empty()) mistakes.emplace_back("tests: expected a boundary condition");
  if (tests.methods.empty()) mistakes.emplace_back("tests: expected a method");
  if (tests.points_per_decade < 1) mistakes.emplace_back("tests: expected one point per decade or more");
}

}  // namespace

void require_sound(const Study& study) {
  std::vector<std::string> mistakes;
  if (study.stages.empty()) mistakes.emplace_back("a study without a stage");
  for (const auto& stage : study.stages) check(study, stage, mistakes);
  check(study.tests, mistakes);
  if (!mistakes.empty()) throw InputError(fmt::format("{}", fmt::join(mistakes, "\n")));
}

}  // namespace breccia
