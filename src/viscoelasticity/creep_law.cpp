#include "breccia/viscoelasticity/creep_law.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

void require_positive_parameter(double value, const char* name, const char* unit) {
  if (value > 0.0 && std::isfinite(value)) return;
  throw InputError(fmt::format("{}: expected a positive number [{}], got {:.6g}", name, unit, value));
}

struct RequireValidCreep {
  void operator()(const PowerLawCreep& law) const {
    require_common(law);
    if (!(law.exponent > 0.0 && law.exponent < 1.0)) refuse_exponent("a number between 0 and 1", law.exponent);
  }
  void operator()(const LogarithmicCreep& law) const {
    require_common(law);
    if (!(law.exponent > 0.0 && law.exponent <= 1.0)) refuse_exponent("a number above 0 and up to 1", law.exponent);
  }

 private:
  template <class Law>
  static void require_common(const Law& law) {
    require_positive_parameter(law.instantaneous, "instantaneous", "1/Pa");
    require_positive_parameter(law.creep, "creep", "1/Pa");
    require_positive_parameter(law.time, "time", "s");
  }
  static void refuse_exponent(const char* expected, double got) {
    throw InputError(fmt::format("exponent: expected {}, got {:.6g}", expected, got));
  }
};

struct ComplianceAt {
  double t;

  double operator()(const PowerLawCreep& law) const {
    return law.instantaneous + law.creep * std::pow(t / law.time, law.exponent);
  }
  double operator()(const LogarithmicCreep& law) const {
    return law.instantaneous + law.creep * std::log1p(std::pow(t / law.time, law.exponent));
  }
};

struct RetardationSpectrum {
  double time;

  double operator()(const PowerLawCreep& law) const {
    const double n = law.exponent;
    return law.creep * n / std::tgamma(1.0 - n) * std::pow(time / law.time, n);
  }
  double operator()(const LogarithmicCreep& law) const {
    const double n = law.exponent, x = time / law.time, angle = std::numbers::pi * n;
    if (n == 1.0) return law.creep * std::exp(-1.0 / x);
    // The integral over phi from 0 to pi n by the tanh-sinh rule, which resolves the integrand near both ends.
    constexpr double step = 0.02;
    constexpr int steps = 220;
    double sum = 0.0;
    for (int i = -steps; i <= steps; ++i) {
      const double t = step * i;
      const double s = 0.5 * std::numbers::pi * std::sinh(t), c = std::cosh(s);
      const double phi = angle / (1.0 + std::exp(-2.0 * s)), to_the_end = angle / (1.0 + std::exp(2.0 * s));
      const double weight = angle * 0.25 * std::numbers::pi * std::cosh(t) / (c * c);
      sum += weight * std::exp(-std::pow(std::sin(to_the_end) / std::sin(phi), 1.0 / n) / x);
    }
    return law.creep * step * sum / std::numbers::pi;
  }
};

}  // namespace

void require_valid(const CreepLaw& law) {
  std::visit(RequireValidCreep{}, law);
}

double instantaneous_compliance(const CreepLaw& law) {
  return std::visit([](const auto& any) { return any.instantaneous; }, law);
}

double characteristic_time(const CreepLaw& law) {
  return std::visit([](const auto& any) { return any.time; }, law);
}

double compliance_at(const CreepLaw& law, double t) {
  return std::visit(ComplianceAt{t}, law);
}

double retardation_spectrum(const CreepLaw& law, double retardation_time) {
  return std::visit(RetardationSpectrum{retardation_time}, law);
}

}  // namespace breccia
