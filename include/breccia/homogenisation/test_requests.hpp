#pragma once

#include "breccia/discretisation/discretisation.hpp"
#include "breccia/study/study.hpp"
#include "breccia/virtual_test/dynamic_test.hpp"
#include "breccia/virtual_test/quasistatic_test.hpp"

namespace breccia {

/// A virtual test of a stage on a grid, with the material that is its matrix, ready to be run.
DynamicTest make_dynamic_test(const Study& study, const Stage& stage, const Material& matrix,
                              const Discretisation<2>& discretisation, Boundary boundary, Load load, int threads);
/// The same by the quasi-static method, under all loads of the stage.
QuasistaticTest make_quasistatic_test(const Study& study, const Stage& stage, const Material& matrix,
                                      const Discretisation<2>& discretisation, Boundary boundary, int threads);

/// The matrix of a stage as it can be guessed before anything has been computed: exact where it is a material. It plans
/// runs; no result depends on it.
Material expected_matrix(const Study& study, const Stage& stage);

}  // namespace breccia
