#include "breccia/viscoelasticity/relaxation_law.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

void require_parameter(bool is_valid, const char* name, const char* expected, double got) {
  if (!is_valid) throw InputError(fmt::format("{}: expected {}, got {:.6g}", name, expected, got));
}

void require_moduli(double relaxed, double unrelaxed, const char* name_of_relaxed, const char* name_of_unrelaxed) {
  require_parameter(relaxed >= 0.0 && std::isfinite(relaxed), name_of_relaxed, "a modulus that is not negative [Pa]",
                    relaxed);
  require_parameter(std::isfinite(unrelaxed) && unrelaxed > relaxed, name_of_unrelaxed,
                    fmt::format("more than {} [Pa]", name_of_relaxed).c_str(), unrelaxed);
}

void require_positive_time(double time) {
  require_parameter(time > 0.0 && std::isfinite(time), "time", "a positive time [s]", time);
}

struct RequireValidRelaxation {
  void operator()(const TwoSpringsTwoParabolasDashpot& law) const {
    require_moduli(law.static_modulus, law.glassy_modulus, "static", "glassy");
    require_positive_time(law.time);
    require_parameter(law.delta > 0.0 && std::isfinite(law.delta), "delta", "a positive number", law.delta);
    require_parameter(law.h > 0.0 && law.h < 1.0, "h", "a number between 0 and 1", law.h);
    require_parameter(law.k > 0.0 && law.k <= law.h, "k",
                      fmt::format("a number above 0 and up to h, {:g}", law.h).c_str(), law.k);
    require_parameter(law.beta > 0.0, "beta", "a positive number", law.beta);
  }
  void operator()(const FractionalZener& law) const {
    require_moduli(law.equilibrium, law.unrelaxed, "equilibrium", "unrelaxed");
    require_positive_time(law.time);
    require_parameter(law.exponent > 0.0 && law.exponent < 1.0, "exponent", "a number between 0 and 1", law.exponent);
  }
};

struct Unrelaxed {
  double operator()(const TwoSpringsTwoParabolasDashpot& law) const { return law.glassy_modulus; }
  double operator()(const FractionalZener& law) const { return law.unrelaxed; }
};

struct Equilibrium {
  double operator()(const TwoSpringsTwoParabolasDashpot& law) const { return law.static_modulus; }
  double operator()(const FractionalZener& law) const { return law.equilibrium; }
};

struct CarsonModulus {
  std::complex<double> s;

  std::complex<double> operator()(const TwoSpringsTwoParabolasDashpot& law) const {
    const auto x = s * law.time;
    const auto sum = 1.0 + law.delta * std::pow(x, -law.k) + std::pow(x, -law.h) + (1.0 / law.beta) / x;
    return law.static_modulus + (law.glassy_modulus - law.static_modulus) / sum;
  }
  std::complex<double> operator()(const FractionalZener& law) const {
    // 1 / (1 + x^-alpha) keeps its digits where x^alpha / (1 + x^alpha) would overflow.
    return law.equilibrium + (law.unrelaxed - law.equilibrium) / (1.0 + std::pow(s * law.time, -law.exponent));
  }
};

}  // namespace

void require_valid(const RelaxationLaw& law) {
  std::visit(RequireValidRelaxation{}, law);
}

double unrelaxed_modulus(const RelaxationLaw& law) {
  return std::visit(Unrelaxed{}, law);
}

double equilibrium_modulus(const RelaxationLaw& law) {
  return std::visit(Equilibrium{}, law);
}

double characteristic_time(const RelaxationLaw& law) {
  return std::visit([](const auto& any) { return any.time; }, law);
}

std::complex<double> carson_modulus(const RelaxationLaw& law, std::complex<double> s) {
  return std::visit(CarsonModulus{s}, law);
}

double relaxation_spectrum(const RelaxationLaw& law, double relaxation_time) {
  const auto above_the_cut = std::polar(1.0 / relaxation_time, std::numbers::pi);
  // Where nothing relaxes rounding may leave a negative number.
  return std::max(0.0, carson_modulus(law, above_the_cut).imag() / std::numbers::pi);
}

}  // namespace breccia
