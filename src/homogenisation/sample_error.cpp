#include "homogenisation/sample_error.hpp"

#include <algorithm>
#include <cmath>

#include "virtual_test/bulk_test.hpp"

namespace breccia {
namespace {

/// The factors of the rule: of the mean of all shears, of one shear, and of the bulk modulus.
struct Factors {
  double mean, one_shear, bulk;
};

Factors factors_of(SampleKind sample, int dimensions) {
  if (sample == SampleKind::grains) return {0.06, 0.18, 0.03};
  if (dimensions == 3) return {0.14, 0.33, 0.1};
  return {0.2, 0.33, 0.1};
}

/// The standard deviation of a modulus from box to box, times the root of their effective number of particles [-].
double deviation_of_one(const Factors& factors, TestLoad load, double stiffening) {
  const double share = std::abs(std::log(stiffening));
  if (!load.is_bulk()) return (load.is_isotropic() ? factors.mean : factors.one_shear) * share;
  // Voids leave a nearly incompressible matrix hardly any of its bulk modulus, whatever their arrangement.
  constexpr double of_soft = 0.2, most = 2.0;
  return stiffening < 1.0 ? of_soft * std::min(share, most) : factors.bulk * share;
}

}  // namespace

double modulus_under(TestLoad load, const Moduli& moduli, int dimensions) {
  return load.is_bulk() ? moduli.bulk + shear_in_bulk_test(dimensions) * moduli.shear : moduli.shear;
}

std::optional<double> sample_error(const ErrorRules& rules, int dimensions, Boundary boundary, TestLoad load,
                                   double stiffening) {
  constexpr double fewest = 12.0, most_known = 1.0;
  if (boundary != Boundary::periodic && rules.effective_particles > 0.0) return std::nullopt;
  if (rules.sample == SampleKind::whole) return 0.0;
  if (rules.sample == SampleKind::unknown || rules.effective_particles < fewest || !(stiffening > 0.0))
    return std::nullopt;
  const auto factors = factors_of(rules.sample, dimensions);
  const double error = 2.0 * deviation_of_one(factors, load, stiffening) / std::sqrt(rules.effective_particles);
  return error < most_known ? std::optional(error) : std::nullopt;
}

double narrowed_by_shears(double rule, double distance) {
  constexpr double of_error = 0.35, least = 0.5;
  return std::clamp(distance / of_error, least * rule, rule);
}

}  // namespace breccia
