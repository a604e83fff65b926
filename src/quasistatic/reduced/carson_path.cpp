#include "breccia/quasistatic/carson_path.hpp"

#include <algorithm>
#include <cmath>

namespace breccia {
namespace {

constexpr double least_change = 0.05, rounding = 1e-9;

/// s M~(s) = M_inf + sum_k M_k s tau_k / (1 + s tau_k)
double carson_modulus(const PronySeries& series, double s) {
  double modulus = series.equilibrium();
  for (const auto& [time, strength] : series.terms()) modulus += strength * s * time / (1.0 + s * time);
  return modulus;
}

/// Adds moduli to a path where one of the two has changed by more than a share of it.
void append(std::vector<Moduli>& path, const Moduli& moduli, double share) {
  // The bulk modulus of a stage's result may rise while the shear modulus falls.
  const double change =
      std::max(std::abs(moduli.bulk / path.back().bulk - 1.0), std::abs(moduli.shear / path.back().shear - 1.0));
  if (change > share) path.push_back(moduli);
}

/// Goes on with a path from one Laplace variable, which is on it, down to another.
void append_between(std::vector<Moduli>& path, const Material& material, double first, double last) {
  constexpr double per_decade = 8.0;
  const int count = static_cast<int>(std::ceil(per_decade * std::log10(first / last)));
  for (int i = 1; i <= count; ++i) {
    const double s = first * std::pow(last / first, static_cast<double>(i) / count);
    append(path, carson_moduli(material, s), i == count ? rounding : least_change);
  }
}

/// Relaxation times [s] of a material and a window: all that lies between is of interest.
TimeWindow widened(const Material& material, TimeWindow window, double beyond) {
  for (const auto* series : {&material.bulk, &material.shear}) {
    for (const auto& term : series->terms()) {
      window.begin = std::min(window.begin, term.relaxation_time / beyond);
      window.end = std::max(window.end, term.relaxation_time * beyond);
    }
  }
  return window;
}

}  // namespace

Moduli carson_moduli(const Material& material, double s) {
  return {carson_modulus(material.bulk, s), carson_modulus(material.shear, s)};
}

std::vector<Moduli> carson_path(const Material& material, const TimeWindow& window, double margin) {
  const double first = margin / window.begin, last = 1.0 / (margin * window.end);
  std::vector<Moduli> path = {carson_moduli(material, first)};
  append_between(path, material, first, last);
  return path;
}

bool is_like_softer(const Moduli& moduli) {
  constexpr double incompressible = 1e-7;
  return moduli.shear < incompressible * moduli.bulk;
}

std::vector<Moduli> relaxation_path(const Material& material, const TimeWindow& window) {
  constexpr double margin = 30.0, beyond = 100.0;
  const auto [begin, end] = widened(material, {window.begin / margin, window.end * margin}, beyond);
  std::vector<Moduli> path = {{material.bulk.unrelaxed(), material.shear.unrelaxed()}};
  append_between(path, material, 1.0 / begin, 1.0 / end);
  const Moduli relaxed = {material.bulk.equilibrium(), material.shear.equilibrium()};
  if (relaxed.shear > 0.0) append(path, relaxed, rounding);
  return path;
}

}  // namespace breccia
