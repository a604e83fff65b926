#include "cli/quantities.hpp"

#include "io/units.hpp"

namespace breccia::cli {

std::string length(double metres) {
  return readable(metres, Dimension::length);
}

std::string time(double seconds) {
  return readable(seconds, Dimension::time);
}

std::string pressure(double pascals) {
  return readable(pascals, Dimension::pressure);
}

}  // namespace breccia::cli
