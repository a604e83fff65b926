#pragma once

#include "breccia/discretisation/discretisation.hpp"
#include "breccia/microstructure/packing.hpp"
#include "breccia/viscoelasticity/material.hpp"

namespace breccia::testing_composites {

/// The phases of the composites.
inline constexpr PhaseIndex matrix = 0, filler = 1;

// The binder of Table 1 of the paper.
inline const Material binder = {"binder", 1000.0, PronySeries(1e6), PronySeries(0.0, {{0.01, 0.5e6}})};
inline const Material particle = {"particle", 1500.0, PronySeries(50e6), PronySeries(18.8e6)};

/// The composite of Fig. 2 of the paper: a box of 6 mm with four discs of 2 mm.
inline Discretisation<2> model_composite(int cells) {
  Microstructure<2> four_discs = {6e-3, Walls::hard, {}};
  for (const double x : {1.5e-3, 4.5e-3}) {
    for (const double y : {1.5e-3, 4.5e-3}) four_discs.particles.push_back({{x, y}, 2e-3});
  }
  return discretise(four_discs, cells, matrix, filler);
}

// An elastomer that is nearly incompressible once relaxed, and an explosive crystal.
inline const Material elastomer = {
    "elastomer", 1480.0, PronySeries(3.6e9),
    PronySeries(0.2e6, {{1e-7, 300e6}, {1e-6, 80e6}, {1e-5, 20e6}, {1e-4, 4e6}, {1e-3, 1e6}})};
inline const Material crystal = {"crystal", 1850.0, PronySeries(13.4e9), PronySeries(5.84e9)};

/// Twelve discs of 11 um, packed at random in a box of 50 um.
inline Discretisation<2> packed_discs(int cells) {
  PackingRequest request;
  request.side = 50e-6;
  request.diameters.assign(12, 11e-6);
  request.minimum_gap = 1e-6;
  request.seed = 3;
  return discretise<2>({request.side, Walls::hard, pack<2>(request).balls}, cells, matrix, filler);
}

}  // namespace breccia::testing_composites
