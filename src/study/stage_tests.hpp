#pragma once

#include <filesystem>
#include <vector>

#include "breccia/study/run.hpp"

#include "checkpoints.hpp"

namespace breccia {

/// What the tests of a stage are made on.
struct StageGrid {
  const Study* study;
  const Stage* stage;
  Discretisation<2> discretisation;
  std::filesystem::path directory;  ///< of the stage's results
  int threads;
  const Checkpoints* checkpoints;
};

/// All loads under one boundary by the quasi-static method, with a matrix and the moduli [Pa] that it shows over the
/// whole of its relaxation.
std::vector<TestResult> run_quasistatic(const StageGrid& grid, const Material& matrix,
                                        std::vector<Moduli> matrix_moduli, Boundary boundary,
                                        const StudyObserver& observer);

/// One load under one boundary by the dynamic method. Both write fields, this one also histories.
TestResult run_dynamic(const StageGrid& grid, const Material& matrix, Boundary boundary, Load load,
                       const StudyObserver& observer);

/// The series of a curve that a method gives as numbers.
PronySeries fitted(const Curve& curve);

/// What makes a test doubtful.
std::vector<std::string> warnings_of(const Stage& stage, const TestResult& test);

}  // namespace breccia
