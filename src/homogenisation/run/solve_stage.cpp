#include "homogenisation/run/solve_stage.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/homogenisation/stage_discretisation.hpp"

#include "checkpoint/checkpoint.hpp"
#include "homogenisation/complex_moduli.hpp"
#include "homogenisation/modulus_errors.hpp"
#include "homogenisation/narrow_gaps.hpp"
#include "homogenisation/quality.hpp"
#include "homogenisation/run/comparison.hpp"
#include "homogenisation/run/isotropic_mean.hpp"
#include "homogenisation/run/packed_stage.hpp"
#include "homogenisation/run/stage_expansions.hpp"
#include "homogenisation/run/stage_extrapolation.hpp"
#include "homogenisation/run/stage_tests.hpp"
#include "homogenisation/stage_materials.hpp"
#include "homogenisation/varying_moduli.hpp"
#include "homogenisation/whole_stiffness.hpp"
#include "parallel/common_failure.hpp"
#include "study/chain.hpp"
#include "study/test_rules.hpp"

namespace breccia {
namespace {

/// Runs the tests of the last stage of a result and adds each to the result when it is finished.
class StageSolution {
 public:
  StageSolution(const Study& study, const Stage& stage, StudySink& sink, StudyResult& result)
      : study_(study), stage_(stage), sink_(sink), result_(result), done_(result.stages.back()) {
    for (const auto load : loads_of(study, stage)) {
      if (load != Load::bulk) last_shear_ = load;
    }
  }

  void run(int threads) {
    if (model_of(study_.tests, stage_) == Model::films) {
      const StageFilms films{&study_, &stage_, &done_.microstructure, threads};
      for (const auto boundary : study_.tests.boundaries) run(films, boundary);
    } else {
      run_on_grids(threads);
    }
    const auto mixing = mixing_of(study_, stage_, done_.microstructure);
    for (auto& test : extrapolate_tests(stage_.name, stage_.side, stage_.dimensions(), done_.tests, mixing)) {
      add(std::move(test));
    }
    auto pairs = extrapolate_tests(stage_.name, stage_.side, stage_.dimensions(), of_pairs_, mixing);
    std::ranges::move(pairs, std::back_inserter(of_pairs_));
    add_errors(done_, error_rules_of(study_, stage_, done_.microstructure), stage_.matrix, result_.stages);
    done_.stiffness = whole_stiffness(stage_.dimensions(), done_.tests, of_pairs_);
    const auto quality = quality_of(study_, stage_, done_);
    done_.accuracy = accuracy_of(quality);
    for (const auto& warning : warnings_on_bounds(quality)) {
      done_.warnings.push_back(fmt::format("{}: {}", stage_.name, warning));
    }
    if (serves_as_matrix(study_.stages, stage_.name))
      done_.materials = materials_from(study_, stage_, result_.stages, done_);
    if (study_.tests.by_frequency) add_complex_moduli(done_.tests, study_.tests.points_per_decade);
    done_.comparisons = compare(study_.measurements, done_, shear_of_material(study_.tests));
    add_expansions(study_, stage_, result_.stages, done_);
    sink_.happened(StageFinished{stage_, result_});
  }

 private:
  void run_on_grids(int threads) {
    for (const int cells : stage_.grids()) {
      const auto& packed = done_.microstructure;
      const auto discretisation = discretise_together(stage_, packed, cells, study_.tests.mixing);
      const StageGrid grid{&study_, &stage_,
                           parallel::made_by_all([&] { return cells_of(stage_, packed, discretisation); }), threads};
      for (const auto boundary : study_.tests.boundaries) {
        for (const auto method : study_.tests.methods) run(grid, boundary, method);
      }
    }
  }

  void run(const StageGrid& grid, Boundary boundary, Method method) {
    const auto& matrix = matrix_of(stage_.name, stage_.matrix, result_.stages, boundary, method);
    if (method == Method::quasistatic) {
      auto moduli = varying_moduli(study_, stage_, result_.stages, boundary);
      add_all_loads(run_quasistatic(grid, matrix, std::move(moduli), boundary, sink_));
      return;
    }
    for (const auto load : loads_of(study_, stage_)) {
      add_of_load(run_dynamic(grid, matrix, boundary, load, sink_));
    }
  }

  void run(const StageFilms& films, Boundary boundary) {
    const auto& matrix = matrix_of(stage_.name, stage_.matrix, result_.stages, boundary, Method::quasistatic);
    auto moduli = varying_moduli(study_, stage_, result_.stages, boundary);
    add_all_loads(run_films(films, matrix, std::move(moduli), boundary, sink_));
  }

  void add_all_loads(std::vector<TestResult> tests) {
    if (auto warning = warning_of_basis(study_.tests, stage_, tests)) done_.warnings.push_back(*std::move(warning));
    for (auto& test : tests) {
      if (pair_of(*test.id.load.of_test())) {
        of_pairs_.push_back(std::move(test));
      } else {
        add_of_load(std::move(test));
      }
    }
    sink_.happened(AllLoadsFinished{stage_, result_});
  }

  /// Adds a test and, after the last shear, the mean of all shears if the study asks for it.
  void add_of_load(TestResult test) {
    const auto id = test.id;
    add(std::move(test));
    if (asks_for_isotropic(study_.tests) && id.load == last_shear_) {
      add(isotropic_mean(stage_.dimensions(), id, done_.tests));
    }
  }

  void add(TestResult test) {
    done_.tests.push_back(std::move(test));
    std::ranges::copy(warnings_of(study_.tests, stage_, done_.tests.back()), std::back_inserter(done_.warnings));
    sink_.happened(TestFinished{stage_, result_});
  }

  const Study& study_;
  const Stage& stage_;
  StudySink& sink_;
  StudyResult& result_;
  StageResult& done_;
  std::vector<TestResult> of_pairs_ = {};  ///< tests under two loads at once, from which the whole stiffness follows
  std::optional<Load> last_shear_ = {};
};

}  // namespace

void pack_stage(const Study& study, const Stage& stage, StudySink& sink, StudyResult& result) {
  const auto checkpoint = sink.packing_checkpoint(stage);
  const auto follow = [&](const Progress& progress) { sink.progress(progress); };
  auto microstructure = make_microstructure(stage, follow, checkpoint.get());
  result.stages.push_back(packed_stage_together(study, stage, std::move(microstructure)));
  sink.happened(StagePacked{stage, result});
}

void test_stage(const Study& study, const Stage& stage, int threads, StudySink& sink, StudyResult& result) {
  if (result.stages.empty() || result.stages.back().name != stage.name) {
    throw InputError(
        fmt::format("stage {} is not the last one of the result, so that it cannot be tested", stage.name));
  }
  StageSolution(study, stage, sink, result).run(threads);
}

}  // namespace breccia
