#include "breccia/virtual_test/homogenised_material.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/fit.hpp"

#include "virtual_test/bulk_test.hpp"

namespace breccia {
namespace {

/// The two moduli of a composite at the times that both of its curves have.
struct CommonModuli {
  std::vector<double> times;  ///< [s]
  std::vector<double> shear;  ///< G [Pa]
  std::vector<double> bulk;   ///< K, in plane strain K + G/3 [Pa]
};

/// Prony series fitted to both moduli, from the same candidate relaxation times.
struct CommonFit {
  RelaxationFit shear;
  RelaxationFit bulk;
};

CommonModuli common_samples(const std::string& name, const Curve& shear, const Curve& bulk) {
  CommonModuli moduli;
  auto in_bulk = bulk.begin();
  for (const auto& [time, modulus] : shear) {
    while (in_bulk != bulk.end() && in_bulk->time < time) ++in_bulk;
    if (in_bulk == bulk.end()) break;
    if (in_bulk->time > time) continue;
    moduli.times.push_back(time);
    moduli.shear.push_back(modulus);
    moduli.bulk.push_back(in_bulk->modulus);
  }
  constexpr std::size_t fewest = 3;
  if (moduli.times.size() < fewest) {
    throw NumericalError(fmt::format("{}: the curves of shear and bulk have {} times in common; a fit takes {}", name,
                                     moduli.times.size(), fewest));
  }
  return moduli;
}

CommonFit fit(const CommonModuli& moduli, const FitOptions& options = {}) {
  return {fit_relaxation(moduli.times, moduli.shear, options), fit_relaxation(moduli.times, moduli.bulk, options)};
}

/// The fit with the widest spacing of relaxation times that the tolerance allows (theory, Eq. 33a).
CommonFit fit_with_few_terms(const CommonModuli& moduli, double tolerance) {
  constexpr double share_of_tolerance = 1.0 / 30.0;
  constexpr std::array times_per_decade = {1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 5.0, 6.0, 8.0};
  auto finest = fit(moduli);
  const auto is_as_good = [&](const RelaxationFit& few, const RelaxationFit& many) {
    const double allowed = std::min(many.quality.worst_error + share_of_tolerance * tolerance, tolerance);
    return few.quality.worst_error <= allowed;
  };
  for (const double density : times_per_decade) {
    auto sparse = fit(moduli, {.times_per_decade = density});
    if (is_as_good(sparse.shear, finest.shear) && is_as_good(sparse.bulk, finest.bulk)) return sparse;
  }
  return finest;
}

}  // namespace

HomogenisedMaterial homogenised_material(const std::string& name, double density, const Curve& shear,
                                         const Curve& bulk_curve, double tolerance, int dimensions) {
  const auto moduli = common_samples(name, shear, bulk_curve);
  const auto fits = fit_with_few_terms(moduli, tolerance);
  // With the same candidate times the terms of the two moduli can be merged.
  const auto bulk = bulk_modulus_of(fits.bulk.series, fits.shear.series, dimensions);
  return {.material = {.name = name, .density = density, .bulk = bulk, .shear = fits.shear.series},
          .fitted = {moduli.times.front(), moduli.times.back()},
          .shear_error = fits.shear.quality.worst_error,
          .bulk_error = fits.bulk.quality.worst_error};
}

}  // namespace breccia
