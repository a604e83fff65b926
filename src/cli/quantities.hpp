#pragma once

#include <string>

namespace breccia::cli {

// Quantities as a deck may write them, in a unit that suits their size.

std::string length(double metres);
std::string time(double seconds);
std::string pressure(double pascals);

}  // namespace breccia::cli
