#include "homogenisation/tests_of_solid.hpp"

namespace breccia {

bool are_of_one_solid(const TestResult& shear, const TestResult& bulk) {
  const bool are_alike =
      shear.id.boundary == bulk.id.boundary && shear.id.method == bulk.id.method && shear.id.grid == bulk.id.grid;
  return are_alike && shear.series.unrelaxed() > 0.0 && bulk.series.unrelaxed() > 0.0;
}

}  // namespace breccia
