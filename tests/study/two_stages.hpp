#pragma once

#include "breccia/study/study.hpp"

namespace breccia::test {

inline const Material binder = {"binder", 1000.0, PronySeries(1e9), PronySeries(1e4, {{0.01, 0.5e6}})};
inline const Material glass = {"glass", 2000.0, PronySeries(10e9), PronySeries(5e9)};

/// A box with four discs.
inline Stage four_discs(const std::string& name, StageMatrix matrix, double side, int cells) {
  Filler filler;
  filler.material = glass;
  filler.sizes = SingleSize{side / 3.0};
  return {.name = name,
          .matrix = std::move(matrix),
          .side = side,
          .cells = cells,
          .fillers = {filler},
          .packing = RegularPacking{2, 2}};
}

/// The stage "fine" between the particles of the stage "coarse".
inline Study two_stages() {
  Study study;
  study.materials = {{binder}, {glass}};
  study.stages = {four_discs("fine", binder, 6e-3, 12), four_discs("coarse", EarlierStage{"fine"}, 60e-3, 12)};
  study.tests.first_time = 1e-3;
  study.tests.last_time = 50e-3;
  return study;
}

}  // namespace breccia::test
