#pragma once

#include <cstddef>

#include "io/range.hpp"

/// The numbers that a study may have, for the deck reader and for require_sound.
namespace breccia::allowed {

/// Poisson's ratio [-]. Below -0.9 no material is known; more likely the units are wrong.
inline constexpr Range poisson = Range::between(-0.9, 0.5);

/// Linear thermal expansion [1/K]. Those of solids are between some -1e-5 and 1e-3; beyond, a unit is wrong.
inline constexpr Range thermal_expansion = Range::between(-0.01, 0.01);

inline constexpr Range side = {.lower = 1e-12, .upper = 1e6};          ///< side of a box [m]
inline constexpr Range dimensions = {.lower = 2.0, .upper = 3.0};      ///< number of dimensions of a box
inline constexpr Range cells = {.lower = 2.0, .upper = 1048576.0};     ///< number of cells per side
inline constexpr Range particles = {.lower = 1.0, .upper = 100000.0};  ///< number of particles that gives a box
inline constexpr std::size_t most_grids = 3;                           ///< number of grids of a stage
inline constexpr std::size_t most_fillers = 100;                       ///< number of fillers of a stage
inline constexpr Range fraction = Range::between(0.0, 1.0);            ///< fraction of a random packing [-]
inline constexpr Range aspect = {.lower = 0.05, .upper = 20.0};        ///< aspect of ellipses [-]
inline constexpr Range repeats = {.lower = 1.0, .upper = 100.0};       ///< cells of a cubic lattice along each axis
inline constexpr Range rows = {.lower = 1.0, .upper = 1e4};  ///< number of rows, or of columns, of a regular packing
inline constexpr Range points_per_decade = {.lower = 1.0, .upper = 1000.0};  ///< samples per decade of the curves
inline constexpr Range fit_tolerance = Range::above_and_up_to(0.0, 1.0);     ///< [-]

/// Tolerances of the quasi-static method, for the reduced basis and for the linear systems [-].
inline constexpr Range accuracy = Range::between(0.0, 0.1);
inline constexpr Range snapshots = {.lower = 2.0, .upper = 10000.0};  ///< number of snapshots of the reduced basis
inline constexpr Range steps_per_decade = {.lower = 2.0, .upper = 1000.0};

/// Length of the elements along films over the size of a grain [-].
inline constexpr Range face_share = {.lower = 0.005, .upper = 1.0};

inline constexpr Range debonded = {.lower = 0.0, .upper = 1.0};  ///< share of films [-]

/// Stiffness of springs [Pa/m]. Above, films are bonded and linear systems lose their digits.
inline constexpr Range interface_stiffness = {.lower = 1.0, .upper = 1e22};

inline constexpr Range divisions = {.lower = 1.0, .upper = 8.0};  ///< number of elements along an edge of a grain
inline constexpr Range layers = {.lower = 1.0, .upper = 16.0};    ///< number of layers of elements across a film

inline constexpr Range courant = Range::above_and_up_to(0.0, 1.0);      ///< time step over the stable limit [-]
inline constexpr Range ramp = Range::not_negative();                    ///< [s], or in transits of a wave [-]
inline constexpr Range overlap = Range::above_and_up_to(1.0, 1e6);      ///< ratio of times [-]
inline constexpr Range reduction_tolerance = Range::between(0.0, 1.0);  ///< [-]

}  // namespace breccia::allowed
