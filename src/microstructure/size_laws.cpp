#include "breccia/microstructure/size_laws.hpp"

#include <cmath>
#include <numbers>

namespace breccia {

double share_up_to(double diameter, const FullerSizes& law) {
  if (diameter <= 0.0) return 0.0;
  return diameter < law.largest ? std::pow(diameter / law.largest, law.exponent) : 1.0;
}

double share_up_to(double diameter, const RosinRammlerSizes& law) {
  if (diameter <= 0.0) return 0.0;
  return -std::expm1(-std::pow(diameter / law.size, law.exponent));
}

double share_up_to(double diameter, const QuantileSizes& law) {
  if (diameter <= 0.0) return 0.0;
  constexpr double score_of_d90 = 1.2815515655446004;  // of which the normal distribution has 90 % below
  const double width = diameter < law.d50 ? std::log(law.d50 / law.d10) : std::log(law.d90 / law.d50);
  const double score = score_of_d90 * std::log(diameter / law.d50) / width;
  return 0.5 * std::erfc(-score / std::numbers::sqrt2);
}

}  // namespace breccia
