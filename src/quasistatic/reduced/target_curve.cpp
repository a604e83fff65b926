#include "quasistatic/reduced/target_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "breccia/error.hpp"
#include "breccia/quasistatic/reduced_response.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

namespace breccia {
namespace {

/// The response of the basis without its last vector. The vectors of a basis are orthonormalised one after the other.
ReducedResponse without_last_vector(ReducedResponse response) {
  const auto size = response.load_forces.size() - 1;
  response.constant = response.constant.topLeftCorner(size, size).eval();
  for (auto& part : response.parts) part.stiffness = part.stiffness.topLeftCorner(size, size).eval();
  response.load_forces = response.load_forces.head(size).eval();
  return response;
}

/// The relaxation modulus; nothing where the basis has too few vectors to compute it.
std::optional<PronySeries> modulus_of(const ReducedResponse& response, const TargetCurve& target) {
  try {
    return relaxation_modulus(creep_compliance(response, target.materials));
  } catch (const NumericalError&) {
    return std::nullopt;
  }
}

struct TwoCurves {
  std::optional<PronySeries> now, before;
};

TwoCurves curves_of(const ReducedResponse& response, const TargetCurve& target) {
  return {modulus_of(response, target), modulus_of(without_last_vector(response), target)};
}

}  // namespace

double change_by_last_vector(const ReducedResponse& response, const TargetCurve& target) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if (response.load_forces.size() < 2) return infinite;
  const auto [now, before] = curves_of(response, target);
  if (!now || !before) return infinite;
  constexpr double least_share = 1e-8, per_decade = 5.0;
  const double least = least_share * now->unrelaxed();
  const double decades = std::log10(target.times.end / target.times.begin);
  const int steps = std::max(1, static_cast<int>(std::ceil(per_decade * decades)));
  double largest = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const double time = target.times.begin * std::pow(10.0, decades * i / steps);
    const double modulus = now->at(time);
    const double change = std::abs(modulus - before->at(time)) / std::max(modulus, least);
    if (!std::isfinite(change)) return infinite;
    largest = std::max(largest, change);
  }
  return largest;
}

}  // namespace breccia
