#pragma once

#include "breccia/discretisation/discretisation.hpp"
#include "breccia/homogenisation/stage_discretisation.hpp"
#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/study.hpp"

#include "homogenisation/box/stage_cells.hpp"
#include "virtual_test/dynamic_test.hpp"
#include "virtual_test/quasistatic_test.hpp"

namespace breccia {

/// The dynamic test of a stage on a grid, under one boundary and load, with its matrix as a material. Instantiated for
/// 2 and 3 dimensions.
template <int dim>
DynamicTest<dim> make_dynamic_test(const Study& study, const Stage& stage, const Material& matrix,
                                   const Discretisation<dim>& discretisation, Boundary boundary, Load load,
                                   int threads);
/// The quasi-static test of a stage on a grid, under one boundary and all loads of the stage.
QuasistaticTest make_quasistatic_test(const Study& study, const Stage& stage, const Material& matrix,
                                      const StageCells& cells, Boundary boundary, int threads);
/// The quasi-static test of the grains of a stage and the films between them, under one boundary and all loads of the
/// stage.
QuasistaticTest make_film_test(const Study& study, const Stage& stage, const Material& matrix,
                               const StageMicrostructure& grains, Boundary boundary, int threads);

/// The criteria by which the sampling of the reduced bases of a study ends.
SamplingOptions sampling_of(const Tests& tests);

/// An estimate of the matrix of a stage before anything is computed; exact if the matrix is a material. It serves to
/// plan runs; no result depends on it.
Material expected_matrix(const Study& study, const Stage& stage);

}  // namespace breccia
