#pragma once

#include <optional>
#include <string>
#include <vector>

#include "breccia/homogenisation/stage_discretisation.hpp"
#include "breccia/homogenisation/study_result.hpp"
#include "breccia/homogenisation/study_sink.hpp"
#include "breccia/study/study.hpp"

#include "discretisation/cell_shape.hpp"
#include "homogenisation/box/stage_cells.hpp"

namespace breccia {

/// A microstructure on a grid, ready to be tested.
struct StageGrid {
  const Study* study = nullptr;
  const Stage* stage = nullptr;
  StageCells cells;
  int threads = 0;  ///< 0: all cores
};

/// Grains and films, ready to be tested.
struct StageFilms {
  const Study* study = nullptr;
  const Stage* stage = nullptr;
  const StageMicrostructure* grains = nullptr;
  int threads = 0;  ///< 0: all cores
};

/// Runs all loads under one boundary by the quasi-static method, with a matrix and its moduli [Pa] over its whole
/// relaxation.
std::vector<TestResult> run_quasistatic(const StageGrid& grid, const Material& matrix,
                                        std::vector<std::vector<Moduli>> relaxation, Boundary boundary,
                                        StudySink& sink);

/// Runs all loads under one boundary by the model of grains and films, with a matrix and its moduli [Pa] over its whole
/// relaxation.
std::vector<TestResult> run_films(const StageFilms& films, const Material& matrix,
                                  std::vector<std::vector<Moduli>> relaxation, Boundary boundary, StudySink& sink);

/// Runs one load under one boundary by the dynamic method.
TestResult run_dynamic(const StageGrid& grid, const Material& matrix, Boundary boundary, Load load, StudySink& sink);

/// A Prony series fitted to a curve.
PronySeries fitted(const Curve& curve);

/// Reasons to doubt the result of a test.
std::vector<std::string> warnings_of(const Tests& tests, const Stage& stage, const TestResult& test);

/// A warning where the reduced bases of the tests of all loads have as many snapshots as are allowed and are less
/// accurate than they should be.
std::optional<std::string> warning_of_basis(const Tests& tests, const Stage& stage,
                                            const std::vector<TestResult>& of_loads);

}  // namespace breccia
