// Times the packings that Breccia is used for, of discs and of spheres, and the limits of the method; some minutes.

#include <chrono>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/draw_diameters.hpp"
#include "breccia/microstructure/packing.hpp"

namespace {

using breccia::SizeDistribution;
using breccia::Walls;

struct Case {
  std::string name;
  breccia::PackingRequest request;
  void (*run)(const Case&);
};

template <int dim>
void run(const Case& entry);

SizeDistribution hmx() {
  return SizeDistribution::lognormal_mixture({{0.75, 154e-6, 0.76}, {0.25, 12.7e-6, 1.09}});
}

SizeDistribution lognormal(double from, double to) {
  return SizeDistribution::lognormal_mixture({{1.0, 10e-6, 0.7}}).truncated(from, to);
}

template <int dim>
Case sized(std::string name, const SizeDistribution& sizes, double fraction, double side, double gap,
           Walls walls = Walls::hard) {
  return {std::move(name), {side, walls, draw_diameters<dim>(sizes, fraction, side), gap}, run<dim>};
}

/// A box for about `count` balls of these sizes, without a gap.
template <int dim>
Case counted(std::string name, const SizeDistribution& sizes, double fraction, std::size_t count, Walls walls) {
  constexpr double trial_side = dim == 2 ? 1e-3 : 3e-4;
  const auto trial_count = static_cast<double>(draw_diameters<dim>(sizes, fraction, trial_side).size());
  const double side = trial_side * std::pow(static_cast<double>(count) / trial_count, 1.0 / dim);
  return sized<dim>(std::move(name), sizes, fraction, side, 0.0, walls);
}

std::vector<Case> discs() {
  const auto equal = SizeDistribution::monodisperse(10e-6);
  return {
      sized<2>("HB-1, gap 0.5 um", hmx().truncated(2e-6, 14e-6), 0.65, 48e-6, 0.5e-6),
      sized<2>("HB-1, gap 0.48 um", hmx().truncated(2e-6, 14e-6), 0.65, 48e-6, 0.48e-6),
      sized<2>("HB-2, gap 4.2 um", hmx().truncated(14e-6, 100e-6), 0.63, 420e-6, 4.2e-6),
      sized<2>("HB-3, gap 27.5 um", hmx().truncated(100e-6, 600e-6), 0.52, 2.75e-3, 27.5e-6),
      counted<2>("equal, walls", equal, 0.78, 1000, Walls::hard),
      counted<2>("equal, walls", equal, 0.82, 1000, Walls::hard),
      counted<2>("equal, periodic", equal, 0.82, 1000, Walls::periodic),
      counted<2>("equal, periodic", equal, 0.80, 10000, Walls::periodic),
      counted<2>("lognormal 10:1, walls", lognormal(3e-6, 30e-6), 0.80, 10000, Walls::hard),
      counted<2>("lognormal 10:1, periodic", lognormal(3e-6, 30e-6), 0.85, 10000, Walls::periodic),
      counted<2>("lognormal 100:1, walls", lognormal(1e-6, 100e-6), 0.85, 10000, Walls::hard),
      counted<2>("lognormal 10:1, walls", lognormal(3e-6, 30e-6), 0.80, 100000, Walls::hard),
      counted<2>("lognormal 100:1, walls", lognormal(1e-6, 100e-6), 0.85, 100000, Walls::hard),
      sized<2>("PBX-9501, gap 0.3 um", hmx().truncated(2e-6, 1e-3), 0.90, 2.75e-3, 0.3e-6),
      counted<2>("equal, walls, impossible", equal, 0.90, 1000, Walls::hard),
  };
}

std::vector<Case> spheres() {
  const auto equal = SizeDistribution::monodisperse(10e-6);
  return {
      counted<3>("equal, periodic", equal, 0.62, 1000, Walls::periodic),
      counted<3>("equal, walls", equal, 0.55, 1000, Walls::hard),
      counted<3>("equal, periodic", equal, 0.62, 10000, Walls::periodic),
      counted<3>("lognormal 10:1, periodic", lognormal(3e-6, 30e-6), 0.70, 10000, Walls::periodic),
      counted<3>("lognormal 100:1, periodic", lognormal(1e-6, 100e-6), 0.70, 100000, Walls::periodic),
  };
}

template <int dim>
void run(const Case& entry) {
  const auto& request = entry.request;
  double fraction = 0.0;
  double events = 0.0;
  std::string outcome;
  const auto start = std::chrono::steady_clock::now();
  try {
    breccia::PackingRun<dim> run(request);
    while (!run.is_done()) {
      run.advance();
      fraction = run.progress().fraction;
      events = static_cast<double>(run.progress().events);
    }
    outcome = fmt::format("{:.4g}", run.packing().gap);
  } catch (const breccia::NumericalError&) {
    outcome = "jammed";
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  fmt::print("{:<28} {:>7} {:>9.4f} {:>10.3g} {:>10.3g} {:>9.3f}  {}\n", entry.name, request.diameters.size(), fraction,
             events, events / seconds, seconds, outcome);
}

void print(const std::string& balls, const std::vector<Case>& cases) {
  fmt::print("{:<28} {:>7} {:>9} {:>10} {:>10} {:>9}  {}\n", "packing", balls, "fraction", "events", "events/s",
             "seconds", "gap [m]");
  for (const Case& entry : cases) entry.run(entry);
}

}  // namespace

int main() {
  print("discs", discs());
  print("spheres", spheres());
}
