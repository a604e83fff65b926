#include "homogenisation/box/effective_number.hpp"

namespace breccia {

double effective_number(std::span<const double> volumes) {
  double sum = 0.0, squares = 0.0;
  for (const double volume : volumes) {
    sum += volume;
    squares += volume * volume;
  }
  return squares > 0.0 ? sum * sum / squares : 0.0;
}

}  // namespace breccia
