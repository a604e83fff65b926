#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "breccia/checkpoint/state.hpp"
#include "breccia/discretisation/discretisation.hpp"

namespace breccia {

/// Fields at the material points, per unit of the load. Points come in rows of the lattice with spacing h/2, from the
/// lower left corner: a cell's points lie in two neighbouring rows.
struct PointFields {
  std::vector<MaterialIndex> material;
  std::vector<std::array<double, 2>> displacement;  ///< [m]
  std::vector<std::array<double, 3>> strain;        ///< xx, yy, xy (tensor shear), as the stress sees it [-]
  std::vector<std::array<double, 4>> stress;        ///< xx, yy, zz, xy [Pa]
};

/// Fields at a time after the load was applied.
struct TimedFields {
  double time = 0.0;  ///< [s]
  PointFields fields;
};

/// Leaves fields at some times in a group of a state, without the materials, which the discretisation tells, and takes
/// them up. The latter throws FileError where they are of another discretisation.
void save(StateWriter& state, const std::string& group, std::span<const TimedFields> fields);
std::vector<TimedFields> read_fields(const StateReader& state, const std::string& group,
                                     const Discretisation& discretisation);

/// Fields of the points of a discretisation: their materials, and all else zero.
PointFields zero_fields(const Discretisation& discretisation);

}  // namespace breccia
