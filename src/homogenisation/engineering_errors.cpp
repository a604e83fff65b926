#include "homogenisation/engineering_errors.hpp"

#include <cmath>

#include "virtual_test/bulk_test.hpp"

namespace breccia {

EngineeringErrors engineering_errors(const TestResult& shear, const TestResult& bulk, std::size_t sample,
                                     int dimensions) {
  if (sample >= shear.errors.size() || sample >= bulk.errors.size()) return {};
  constexpr double rounding = 1e-9;
  if (std::abs(shear.modulus[sample].time / bulk.modulus[sample].time - 1.0) > rounding) return {};
  const auto of_shear = shear.errors[sample].whole(), of_test = bulk.errors[sample].whole();
  const double share = shear_in_bulk_test(dimensions);
  const double g = shear.modulus[sample].modulus, tested = bulk.modulus[sample].modulus, k = tested - share * g;
  if (!of_shear || !of_test || !(k > 0.0) || !(g > 0.0)) return {};
  // Derivatives of ln K by ln G and by the logarithm of the modulus that was tested.
  const double k_by_shear = -share * g / k, k_by_test = tested / k;
  const double sum = 3.0 * k + g;
  const double young_by_bulk = g / sum;
  const double poisson_by_bulk = 9.0 * k * g / (2.0 * sum * sum);
  const auto error = [&](double by_shear, double by_test) {
    return std::abs(by_shear) * *of_shear + std::abs(by_test) * *of_test;
  };
  return {.bulk = error(k_by_shear, k_by_test),
          .young = error(1.0 - young_by_bulk + young_by_bulk * k_by_shear, young_by_bulk * k_by_test),
          .poisson = error(poisson_by_bulk * (k_by_shear - 1.0), poisson_by_bulk * k_by_test)};
}

}  // namespace breccia
