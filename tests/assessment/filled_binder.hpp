#pragma once

#include "breccia/assessment/observation.hpp"
#include "breccia/homogenisation/solve.hpp"

#include "study/two_stages.hpp"

namespace breccia::test {

/// A binder of four terms, 10 us to 10 ms, at 20 degC.
inline ShiftedMaterial four_terms() {
  const WilliamsLandelFerry law = {.c1 = 6.5, .c2 = 120.0, .reference_temperature = 293.15};
  return {.material = {"binder", 1000.0, PronySeries(2e9),
                       PronySeries(1e5, {{1e-2, 0.3e6}, {1e-3, 1e6}, {1e-4, 4e6}, {1e-5, 10e6}})},
          .shift = TemperatureShift{law, 293.15}};
}

/// Four discs of glass in a coarse periodic box of that binder, for any moduli of the glass within a decade.
inline ObservedComposite solve_filled_binder() {
  auto study = two_stages();
  study.materials = {four_terms(), {glass}};
  study.stages = {four_discs("box", four_terms().material, 6e-3, 8)};
  study.tests.boundaries = {Boundary::periodic};
  study.tests.loads = {TestLoad::isotropic(), Load::bulk};
  study.tests.first_time = 1e-6;
  study.tests.last_time = 1.0;
  study.tests.varied = {{.name = "glass", .shear = ModulusInterval{1e9, 20e9}, .bulk = ModulusInterval{3e9, 30e9}}};
  return {.name = "filled binder",
          .responder = responder_of(study, solve(study)),
          .stage = "box",
          .boundary = Boundary::periodic};
}

/// That composite, which is solved once.
inline const ObservedComposite& filled_binder() {
  static const auto solved = solve_filled_binder();
  return solved;
}

}  // namespace breccia::test
