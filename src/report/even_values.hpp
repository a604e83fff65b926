#pragma once

#include <string>
#include <vector>

namespace breccia {

/// A round value with its text.
struct EvenValue {
  double value;
  std::string label;
};

/// Some five values between two, rising in steps of 1, 2 or 5 times a power of ten.
std::vector<EvenValue> even_values(double from, double to);

}  // namespace breccia
