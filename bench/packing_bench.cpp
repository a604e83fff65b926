// Times the packings that Breccia is used for, and the limits of the method; some minutes.

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
};

SizeDistribution hmx() {
  return SizeDistribution::lognormal_mixture({{0.75, 154e-6, 0.76}, {0.25, 12.7e-6, 1.09}});
}

SizeDistribution lognormal(double from, double to) {
  return SizeDistribution::lognormal_mixture({{1.0, 10e-6, 0.7}}).truncated(from, to);
}

Case sized(std::string name, const SizeDistribution& sizes, double fraction, double side, double gap,
           Walls walls = Walls::hard) {
  return {std::move(name), {side, walls, draw_diameters<2>(sizes, fraction, side), gap}};
}

/// A box for about `count` discs of these sizes, without a gap.
Case counted(std::string name, const SizeDistribution& sizes, double fraction, std::size_t count, Walls walls) {
  constexpr double trial_side = 1e-3;
  const double trial_count = static_cast<double>(draw_diameters<2>(sizes, fraction, trial_side).size());
  const double side = trial_side * std::sqrt(static_cast<double>(count) / trial_count);
  return sized(std::move(name), sizes, fraction, side, 0.0, walls);
}

std::vector<Case> cases() {
  const auto equal = SizeDistribution::monodisperse(10e-6);
  return {
      sized("HB-1, gap 0.5 um", hmx().truncated(2e-6, 14e-6), 0.65, 48e-6, 0.5e-6),
      sized("HB-1, gap 0.48 um", hmx().truncated(2e-6, 14e-6), 0.65, 48e-6, 0.48e-6),
      sized("HB-2, gap 4.2 um", hmx().truncated(14e-6, 100e-6), 0.63, 420e-6, 4.2e-6),
      sized("HB-3, gap 27.5 um", hmx().truncated(100e-6, 600e-6), 0.52, 2.75e-3, 27.5e-6),
      counted("equal, walls", equal, 0.78, 1000, Walls::hard),
      counted("equal, walls", equal, 0.82, 1000, Walls::hard),
      counted("equal, periodic", equal, 0.82, 1000, Walls::periodic),
      counted("equal, periodic", equal, 0.80, 10000, Walls::periodic),
      counted("lognormal 10:1, walls", lognormal(3e-6, 30e-6), 0.80, 10000, Walls::hard),
      counted("lognormal 10:1, periodic", lognormal(3e-6, 30e-6), 0.85, 10000, Walls::periodic),
      counted("lognormal 100:1, walls", lognormal(1e-6, 100e-6), 0.85, 10000, Walls::hard),
      counted("lognormal 10:1, walls", lognormal(3e-6, 30e-6), 0.80, 100000, Walls::hard),
      counted("lognormal 100:1, walls", lognormal(1e-6, 100e-6), 0.85, 100000, Walls::hard),
      sized("PBX-9501, gap 0.3 um", hmx().truncated(2e-6, 1e-3), 0.90, 2.75e-3, 0.3e-6),
      counted("equal, walls, impossible", equal, 0.90, 1000, Walls::hard),
  };
}

void run(const Case& entry) {
  const auto& [name, request] = entry;
  double fraction = 0.0;
  double events = 0.0;
  std::string outcome;
  const auto start = std::chrono::steady_clock::now();
  try {
    breccia::PackingRun<2> run(request);
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
  fmt::print("{:<28} {:>7} {:>9.4f} {:>10.3g} {:>10.3g} {:>9.3f}  {}\n", name, request.diameters.size(), fraction,
             events, events / seconds, seconds, outcome);
}

}  // namespace

int main() {
  fmt::print("{:<28} {:>7} {:>9} {:>10} {:>10} {:>9}  {}\n", "packing", "discs", "fraction", "events", "events/s",
             "seconds", "gap [m]");
  for (const Case& entry : cases()) run(entry);
}
