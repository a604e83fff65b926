#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "dynamics/dynamic_solver.hpp"
#include "materials.hpp"

namespace breccia {
namespace {

using testing_materials::soft;

/// A bar along x whose left middle starts with a smooth pulse of velocity, free all around. Until waves from the sides
/// arrive, its middle moves as d'Alembert says: u(x, t) = int_{x - c t}^{x + c t} v / 2 c.
class PulseInABar : public testing::TestWithParam<std::tuple<Formulation, bool>> {
 protected:
  static constexpr double centre = 1.0, width = 0.25;

  static double pulse(double x) {
    const double s = (x - centre) / width;
    return std::abs(s) < 1.0 ? std::pow(1.0 - s * s, 3) : 0.0;
  }
  static double integrated_pulse(double x) {
    const double s = std::clamp((x - centre) / width, -1.0, 1.0);
    return width * (s - s * s * s + 0.6 * std::pow(s, 5) - std::pow(s, 7) / 7.0);
  }
};

TEST_P(PulseInABar, TravelsWithTheWaveSpeed) {
  const auto [formulation, transverse] = GetParam();
  const double modulus = transverse ? 1e6 : 3e6 + 4e6 / 3.0;
  const double c = std::sqrt(modulus / 1000.0);
  const double h = 1.0 / 40;
  DynamicProblem<2> problem{Discretisation<2>(Grid<2>{{80, 80}, h}), {soft}};
  problem.boundary = Boundary::traction;
  problem.time_step = 0.5 * stable_time_step(problem.discretisation, problem.materials, problem.volumetric, 1.0);
  const auto run = make_dynamic_solver(formulation, problem);
  const bool along_y = transverse;
  run->set_velocities([&](const Vector<2>& x) {
    return along_y ? Vector<2>{0.0, pulse(x[0])} : Vector<2>{pulse(x[0]), 0.0};
  });
  // The fastest wave from the free sides has not reached the middle yet.
  const double end = 0.8 * 1.0 / std::sqrt((3e6 + 4e6 / 3.0) / 1000.0);
  std::vector<Averages<2>> averages;
  while (run->time() < end) run->advance(1, averages);
  const double t = run->time();
  const auto fields = run->fields();
  double largest = 0.0, worst = 0.0;
  for (std::size_t i = 0; i < 160; ++i) {
    const double x = (static_cast<double>(i) + 0.5) * 0.5 * h;
    const double exact = (integrated_pulse(x + c * t) - integrated_pulse(x - c * t)) / (2.0 * c);
    const double found = fields.displacement[80 * 160 + i][transverse ? 1 : 0];
    largest = std::max(largest, std::abs(exact));
    worst = std::max(worst, std::abs(found - exact));
  }
  // Extrapolation to the nodes and back widens the pulse of moving points.
  EXPECT_LT(worst, (formulation == Formulation::classical ? 0.05 : 0.02) * largest);
}

INSTANTIATE_TEST_SUITE_P(All, PulseInABar,
                         testing::Combine(testing::Values(Formulation::total_lagrangian, Formulation::classical),
                                          testing::Bool()),
                         [](const auto& chosen) {
                           return std::string(std::get<0>(chosen.param) == Formulation::classical ? "Classical"
                                                                                                  : "TotalLagrangian") +
                                  (std::get<1>(chosen.param) ? "Shear" : "Dilatational");
                         });

}  // namespace
}  // namespace breccia
