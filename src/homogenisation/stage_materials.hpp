#pragma once

#include <string>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// The settings by which a material is fitted to the curves of a stage.
struct StageFit {
  std::string stage;   ///< name of the stage, and so of the material
  double side = 0.0;   ///< side of the box [m]
  int dimensions = 2;  ///< dimensions of the box
  Mixing mixing = Mixing::series;
  TestLoad shear = Load::shear;  ///< load whose modulus is G
  TimeWindow times;              ///< first and last time of the curves [s]
  int points_per_decade = 20;    ///< samples per decade of the curves
  double tolerance = 0.0;        ///< largest relative deviation of the fit from the curves [-]
};

/// The result of a stage under a boundary and by a method as a material of this density [kg/m^3]; later stages use it
/// as their matrix. `tests` are all tests of the stage. Throws NumericalError if the error of the fit exceeds its
/// tolerance.
StageMaterial fitted_material(const StageFit& fit, const std::vector<TestResult>& tests, Boundary boundary,
                              Method method, double density);

/// The result of a stage as a material, for every boundary and method of the study. `earlier` are the results of the
/// stages before it. Throws as fitted_material(), and InputError if an earlier stage has no result for a boundary or a
/// method.
std::vector<StageMaterial> materials_from(const Study& study, const Stage& stage,
                                          const std::vector<StageResult>& earlier, const StageResult& result);

/// The matrix of a stage under a boundary and by a method: a material, or the result of an earlier stage under the same
/// boundary and by the same method. Throws InputError, with the name of the stage, if there is no such result.
const Material& matrix_of(const std::string& stage, const StageMatrix& matrix, const std::vector<StageResult>& earlier,
                          Boundary boundary, Method method);

}  // namespace breccia
