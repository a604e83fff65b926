#include "breccia/experiment/homogenised_material.hpp"

#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/fit.hpp"

namespace breccia {

HomogenisedMaterial homogenised_material(const std::string& name, double density, const Curve& shear,
                                         const Curve& plane_strain_bulk) {
  std::vector<double> times, shear_moduli, bulk_moduli;
  auto in_bulk = plane_strain_bulk.begin();
  for (const auto& [time, modulus] : shear) {
    while (in_bulk != plane_strain_bulk.end() && in_bulk->time < time) ++in_bulk;
    if (in_bulk == plane_strain_bulk.end()) break;
    if (in_bulk->time > time) continue;
    times.push_back(time);
    shear_moduli.push_back(modulus);
    bulk_moduli.push_back(in_bulk->modulus);
  }
  constexpr std::size_t fewest = 3;
  if (times.size() < fewest) {
    throw NumericalError(fmt::format("{}: the curves of shear and bulk have {} times in common; a fit takes {}", name,
                                     times.size(), fewest));
  }
  const auto shear_fit = fit_relaxation(times, shear_moduli);
  const auto bulk_fit = fit_relaxation(times, bulk_moduli);
  // The same times to choose from: terms of the two moduli fall together.
  const auto bulk = PronySeries::difference(bulk_fit.series, shear_fit.series.scaled(1.0 / 3.0));
  return {.material = {.name = name, .density = density, .bulk = bulk, .shear = shear_fit.series},
          .fitted = {times.front(), times.back()},
          .shear_error = shear_fit.quality.worst_error,
          .bulk_error = bulk_fit.quality.worst_error};
}

}  // namespace breccia
