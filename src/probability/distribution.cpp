#include "breccia/probability/distribution.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

namespace breccia {
namespace {

/// The density of a standard normal variable.
double normal_density(double score) {
  return std::exp(-0.5 * score * score) / std::sqrt(2.0 * std::numbers::pi);
}

struct ValueAtScore {
  double score;

  double operator()(const Normal& normal) const { return normal.mean + normal.deviation * score; }
  double operator()(const LogNormal& normal) const { return normal.median * std::pow(normal.factor, score); }
  double operator()(const Uniform& uniform) const { return std::lerp(uniform.from, uniform.to, normal_share(score)); }
  double operator()(const LogUniform& uniform) const {
    return uniform.from * std::pow(uniform.to / uniform.from, normal_share(score));
  }
};

struct ScoreOf {
  double value;

  double operator()(const Normal& normal) const { return (value - normal.mean) / normal.deviation; }
  double operator()(const LogNormal& normal) const { return std::log(value / normal.median) / std::log(normal.factor); }
  double operator()(const Uniform& uniform) const {
    return normal_score((value - uniform.from) / (uniform.to - uniform.from));
  }
  double operator()(const LogUniform& uniform) const {
    return normal_score(std::log(value / uniform.from) / std::log(uniform.to / uniform.from));
  }
};

struct MistakeIn {
  std::string operator()(const Normal& normal) const {
    if (!std::isfinite(normal.mean)) return fmt::format("expected a finite value, got {}", normal.mean);
    if (normal.deviation > 0.0 && std::isfinite(normal.deviation)) return "";
    return fmt::format("expected a positive standard deviation, got {:.6g}", normal.deviation);
  }
  std::string operator()(const LogNormal& normal) const {
    if (!(normal.median > 0.0 && std::isfinite(normal.median))) {
      return fmt::format("expected a positive value with a factor, got {:.6g}", normal.median);
    }
    if (normal.factor > 1.0 && std::isfinite(normal.factor)) return "";
    return fmt::format("expected a factor above 1, got {:.6g}", normal.factor);
  }
  std::string operator()(const Uniform& uniform) const { return mistake_in_range(uniform.from, uniform.to); }
  std::string operator()(const LogUniform& uniform) const {
    if (!(uniform.from > 0.0)) {
      return fmt::format("expected positive values of a logarithmic range, got {:.6g}", uniform.from);
    }
    return mistake_in_range(uniform.from, uniform.to);
  }

  static std::string mistake_in_range(double from, double to) {
    if (std::isfinite(from) && std::isfinite(to) && from < to) return "";
    return fmt::format("expected two rising values, got {:.6g} and {:.6g}", from, to);
  }
};

}  // namespace

double normal_share(double score) {
  return 0.5 * std::erfc(-score / std::numbers::sqrt2);
}

double normal_score(double share) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!(share > 0.0)) return -infinity;
  if (!(share < 1.0)) return infinity;
  // The tail is accurate below one half alone.
  if (share > 0.5) return -normal_score(1.0 - share);
  // Newton's method for log Phi, which is concave: from the left of the solution it rises to it without overshooting.
  double score = -std::sqrt(-2.0 * std::log(share));
  for (int i = 0; i < 60; ++i) {
    const double below = normal_share(score);
    const double step = std::log(share / below) * below / normal_density(score);
    score += step;
    if (std::abs(step) < 1e-15 * (1.0 + std::abs(score))) break;
  }
  return score;
}

double student_score(double share, double degrees) {
  const double z = normal_score(share), z2 = z * z;
  const double first = z * (z2 + 1.0) / 4.0;
  const double second = z * ((5.0 * z2 + 16.0) * z2 + 3.0) / 96.0;
  const double third = z * (((3.0 * z2 + 19.0) * z2 + 17.0) * z2 - 15.0) / 384.0;
  return z + (first + (second + third / degrees) / degrees) / degrees;
}

double value_at_score(const Distribution& distribution, double score) {
  return std::visit(ValueAtScore{score}, distribution);
}

double score_of(const Distribution& distribution, double value) {
  return std::visit(ScoreOf{value}, distribution);
}

double median(const Distribution& distribution) {
  return value_at_score(distribution, 0.0);
}

std::string mistake_in(const Distribution& distribution) {
  return std::visit(MistakeIn{}, distribution);
}

}  // namespace breccia
