#include "contradictions.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "breccia/virtual_test/curve.hpp"

namespace breccia {
namespace {

bool is_elastic(const Material& material) {
  return material.bulk.is_elastic() && material.shear.is_elastic();
}

bool uses(const Tests& tests, Method method) {
  return std::ranges::find(tests.methods, method) != tests.methods.end();
}

/// Reports a filler that relaxes with the reduced solver, which needs elastic fillers.
void refuse_relaxing_fillers(const Section& deck, const Study& study) {
  if (!uses(study.tests, Method::quasistatic) || study.tests.quasistatic.solver != Solver::reduced) return;
  for (const auto& stage : study.stages) {
    if (!stage.filler || is_elastic(stage.filler->material)) continue;
    deck.report("tests", fmt::format("the filler of stage {}, {}, relaxes: expected solver = \"stepping\" or method = "
                                     "\"dynamic\"",
                                     stage.name, stage.filler->material.name));
  }
}

/// Reports too few times for fitted series. All series are fits, except those of the reduced solver on a single grid.
void refuse_too_few_times(const Section& deck, const Study& study) {
  const auto& tests = study.tests;
  constexpr std::size_t fewest = 3;
  if (!(tests.first_time > 0.0) || !(tests.last_time > tests.first_time)) return;
  const auto times = logarithmic_times({tests.first_time, tests.last_time}, tests.points_per_decade).size();
  if (times >= fewest) return;
  const bool has_fits = uses(tests, Method::dynamic) || tests.quasistatic.solver == Solver::stepping ||
                        std::ranges::any_of(study.stages, [](const Stage& stage) {
                          return !stage.coarser_cells.empty() || std::holds_alternative<EarlierStage>(stage.matrix);
                        });
  if (!has_fits) return;
  deck.report("tests", fmt::format("times and points_per_decade give {} times, of which no series can be fitted; "
                                   "expected at least {}",
                                   times, fewest));
}

}  // namespace

void refuse_contradictions(const Section& deck, const Study& study) {
  refuse_relaxing_fillers(deck, study);
  refuse_too_few_times(deck, study);
}

}  // namespace breccia
