#include "homogenisation/plan/expected_moduli.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "study/chain.hpp"

namespace breccia {
namespace {

/// Moduli of a box of two or three dimensions, of which the first is that under equal strains along all axes.
struct BoxModuli {
  double dilatational;  ///< K + G/3 in plane strain, K in space [Pa]
  double shear;         ///< [Pa]
};

BoxModuli in_box(const Moduli& moduli, int dimensions) {
  return {dimensions == 3 ? dilatational_modulus<3>(moduli) : dilatational_modulus<2>(moduli), moduli.shear};
}

/// The slopes of ln moduli of a dilute composite over the fraction of its particles [-]: the excess of the particle's
/// moduli times its concentration of strain, that of Eshelby (1957) for a disc or a sphere.
BoxModuli dilute_slopes(const BoxModuli& matrix, const BoxModuli& particle, int dimensions) {
  const auto [k, g] = matrix;
  const double of_dilatation = dimensions == 3 ? 3.0 * k / (3.0 * k + 4.0 * g) : k / (k + g);
  const double of_shear =
      dimensions == 3 ? 6.0 * (k + 2.0 * g) / (5.0 * (3.0 * k + 4.0 * g)) : (k + 2.0 * g) / (2.0 * (k + g));
  const auto slope = [](double ratio, double share) { return (ratio - 1.0) / (1.0 + share * (ratio - 1.0)); };
  return {slope(particle.dilatational / k, of_dilatation), slope(particle.shear / g, of_shear)};
}

/// The fraction at which particles jam [-]: of equal ones, and above it for those that are packed more closely.
double jamming_fraction(double fraction, int dimensions) {
  return std::max(dimensions == 3 ? 0.70 : 0.84, 0.5 * (1.0 + fraction));
}

}  // namespace

Moduli expected_moduli(const Moduli& matrix, const std::vector<ParticleShare>& particles, int dimensions) {
  double fraction = 0.0;
  for (const auto& one : particles) fraction += one.fraction;
  if (!(fraction > 0.0)) return matrix;
  const double jammed = jamming_fraction(fraction, dimensions);
  const auto slopes = [&](const BoxModuli& composite) {
    BoxModuli sum = {0.0, 0.0};
    for (const auto& one : particles) {
      const auto of_one = dilute_slopes(composite, in_box(one.moduli, dimensions), dimensions);
      sum.dilatational += one.fraction / fraction * of_one.dilatational;
      sum.shear += one.fraction / fraction * of_one.shear;
    }
    return sum;
  };
  // d phi / (1 - phi / phi_jammed) = d x; the midpoint rule in steps that change no modulus by more than a few per
  // cent.
  constexpr double longest_step = 0.01, largest_change = 0.05;
  auto composite = in_box(matrix, dimensions);
  for (double left = -jammed * std::log1p(-fraction / jammed); left > 0.0;) {
    const auto begin = slopes(composite);
    const double fastest = std::max(std::abs(begin.dilatational), std::abs(begin.shear));
    const double step = std::min({left, longest_step, largest_change / std::max(fastest, largest_change)});
    const auto middle = slopes({composite.dilatational * std::exp(0.5 * step * begin.dilatational),
                                composite.shear * std::exp(0.5 * step * begin.shear)});
    composite.dilatational *= std::exp(step * middle.dilatational);
    composite.shear *= std::exp(step * middle.shear);
    left -= step;
  }
  const double of_plane = dimensions == 3 ? 0.0 : composite.shear / 3.0;
  return {.bulk = composite.dilatational - of_plane, .shear = composite.shear};
}

Moduli expected_moduli(const Study& study, const Stage& stage, double time) {
  const auto at = [time](const Material& material) {
    return Moduli{.bulk = material.bulk.at(time), .shear = material.shear.at(time)};
  };
  std::vector<ParticleShare> particles;
  for (const auto& filler : stage.fillers) particles.push_back({at(filler.material), filler.fraction.value_or(0.0)});
  return expected_moduli(expected_moduli_of_matrix(study, stage, time), particles, stage.dimensions());
}

Moduli expected_moduli_of_matrix(const Study& study, const Stage& stage, double time) {
  if (const auto* const earlier = stage_of_matrix(study, stage)) return expected_moduli(study, *earlier, time);
  const auto& material = std::get<Material>(stage.matrix);
  return {.bulk = material.bulk.at(time), .shear = material.shear.at(time)};
}

}  // namespace breccia
