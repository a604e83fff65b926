#include "quasistatic/reduced/carson_path.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace breccia {
namespace {

constexpr double least_change = 0.05, rounding = 1e-9;

/// The Carson modulus s M~(s) = M_inf + sum_k M_k s tau_k / (1 + s tau_k).
double carson_modulus(const PronySeries& series, double s) {
  if (std::isinf(s)) return series.unrelaxed();
  double modulus = series.equilibrium();
  for (const auto& [time, strength] : series.terms()) modulus += strength * s * time / (1.0 + s * time);
  return modulus;
}

CarsonPoint point_at(std::span<const Material> materials, double s) {
  CarsonPoint point = {.laplace_variable = s, .moduli = {}};
  for (const auto& material : materials) point.moduli.push_back(carson_moduli(material, s));
  return point;
}

/// Largest relative change of a modulus from one point to the next. The bulk modulus of a stage's result may rise while
/// the shear modulus falls.
double largest_change(const CarsonPoint& from, const CarsonPoint& to) {
  double change = 0.0;
  for (std::size_t m = 0; m < to.moduli.size(); ++m) {
    const auto &before = from.moduli[m], &after = to.moduli[m];
    change = std::max({change, std::abs(after.bulk / before.bulk - 1.0), std::abs(after.shear / before.shear - 1.0)});
  }
  return change;
}

/// Adds a point to a path if one of its moduli differs from that of the last point by more than a relative change.
void append(std::vector<CarsonPoint>& path, CarsonPoint point, double least) {
  if (largest_change(path.back(), point) > least) path.push_back(std::move(point));
}

/// Continues a path from one Laplace variable, whose moduli are its last point, down to another.
void append_between(std::vector<CarsonPoint>& path, std::span<const Material> materials, double first, double last) {
  constexpr double per_decade = 8.0;
  const int count = static_cast<int>(std::ceil(per_decade * std::log10(first / last)));
  for (int i = 1; i <= count; ++i) {
    const double s = first * std::pow(last / first, static_cast<double>(i) / count);
    append(path, point_at(materials, s), i == count ? rounding : least_change);
  }
}

/// A time window [s] that is widened to include the relaxation times of materials, with a factor beyond them.
TimeWindow widened(std::span<const Material> materials, TimeWindow window, double beyond) {
  for (const auto& material : materials) {
    for (const auto* series : {&material.bulk, &material.shear}) {
      for (const auto& term : series->terms()) {
        window.begin = std::min(window.begin, term.relaxation_time / beyond);
        window.end = std::max(window.end, term.relaxation_time * beyond);
      }
    }
  }
  return window;
}

/// The moduli of the only material of a path.
std::vector<Moduli> moduli_of(const std::vector<CarsonPoint>& path) {
  std::vector<Moduli> moduli;
  moduli.reserve(path.size());
  for (const auto& point : path) moduli.push_back(point.moduli.front());
  return moduli;
}

}  // namespace

Moduli carson_moduli(const Material& material, double s) {
  return {carson_modulus(material.bulk, s), carson_modulus(material.shear, s)};
}

std::vector<CarsonPoint> carson_path(std::span<const Material> materials, const TimeWindow& window, double margin) {
  const double first = margin / window.begin, last = 1.0 / (margin * window.end);
  std::vector<CarsonPoint> path = {point_at(materials, first)};
  append_between(path, materials, first, last);
  return path;
}

std::vector<Moduli> carson_path(const Material& material, const TimeWindow& window, double margin) {
  return moduli_of(carson_path(std::span(&material, 1), window, margin));
}

bool is_like_softer(const Moduli& moduli) {
  constexpr double incompressible = 1e-7;
  return moduli.shear < incompressible * moduli.bulk;
}

std::vector<CarsonPoint> relaxation_path(std::span<const Material> materials, const TimeWindow& window) {
  constexpr double margin = 30.0, beyond = 100.0, unrelaxed = std::numeric_limits<double>::infinity();
  const auto [begin, end] = widened(materials, {window.begin / margin, window.end * margin}, beyond);
  std::vector<CarsonPoint> path = {point_at(materials, unrelaxed)};
  append_between(path, materials, 1.0 / begin, 1.0 / end);
  auto relaxed = point_at(materials, 0.0);
  // A material whose moduli all relax to zero is no void.
  bool is_solid = true;
  for (std::size_t m = 0; m < materials.size(); ++m) {
    is_solid = is_solid && (relaxed.moduli[m].shear > 0.0 || is_void(materials[m]));
  }
  if (is_solid) append(path, std::move(relaxed), rounding);
  return path;
}

std::vector<Moduli> relaxation_path(const Material& material, const TimeWindow& window) {
  return moduli_of(relaxation_path(std::span(&material, 1), window));
}

}  // namespace breccia
