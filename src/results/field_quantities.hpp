#pragma once

#include <string>

#include "breccia/study/stage.hpp"
#include "breccia/study/test_id.hpp"

#include "report/field_picture.hpp"

namespace breccia {

/// The quantity that a map of a field shows, in words, and the unit of its labels in the unit of the values.
struct FieldQuantity {
  std::string words;
  double unit_size = 1.0;
};

/// In a square: the stress component of a load, relative to the applied strain or stress, whose mean over the box is
/// given.
FieldQuantity stress_quantity(Boundary boundary, Load load, double mean);

/// In a square: the largest shear strain over the mean shear strain or dilatation of the load, which is given.
FieldQuantity strain_quantity(Load load, double mean);

/// In a cube: the stress component of a load, relative to the applied strain or stress, whose mean over the box is
/// given.
FieldQuantity stress_in_space(Boundary boundary, Load load, double mean);
/// In a cube: the equivalent shear strain over the mean shear strain or dilatation of the load, which is given.
FieldQuantity strain_in_space(Load load, double mean);

/// The picture of a load below a map of a square.
DrawnLoad drawn_load(Load load);

/// The title of a map of a test at a time [s].
std::string field_title(const Stage& stage, const TestId& test, double time);

}  // namespace breccia
