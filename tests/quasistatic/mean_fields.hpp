#pragma once

#include "breccia/discretisation/point_fields.hpp"
#include "breccia/discretisation/tensor.hpp"

namespace breccia::test {

/// Mean stress of the points of a square.
inline Stress<2> mean_stress(const PointFields<2>& fields) {
  Stress<2> mean;
  const auto count = static_cast<double>(fields.stress.size());
  for (const auto& [xx, yy, zz, xy] : fields.stress) {
    mean = {mean.xx + xx / count, mean.yy + yy / count, mean.xy + xy / count};
  }
  return mean;
}

/// Mean strain of the points of a square.
inline Strain<2> mean_strain(const PointFields<2>& fields) {
  Strain<2> mean;
  const auto count = static_cast<double>(fields.strain.size());
  for (const auto& [xx, yy, xy] : fields.strain) {
    mean = {mean.xx + xx / count, mean.yy + yy / count, mean.xy + xy / count};
  }
  return mean;
}

}  // namespace breccia::test
