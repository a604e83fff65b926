#include "deck/known_numbers.hpp"

#include <algorithm>
#include <cmath>

namespace breccia {

bool are_known(const std::vector<double>& numbers) {
  return std::ranges::none_of(numbers, [](double number) { return std::isnan(number); });
}

}  // namespace breccia
