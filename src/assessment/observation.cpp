#include "breccia/assessment/observation.hpp"

namespace breccia {

bool is_over_frequency(ObservedCurve curve) {
  return curve == ObservedCurve::storage || curve == ObservedCurve::loss || curve == ObservedCurve::absolute ||
         curve == ObservedCurve::phase;
}

}  // namespace breccia
