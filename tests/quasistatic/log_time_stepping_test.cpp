#include "breccia/quasistatic/log_time_stepping.hpp"

#include <chrono>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace breccia {
namespace {

TEST(LogTimeStepping, Scratch) {
  for (auto v : {Volumetric::standard, Volumetric::averaged})
    for (int n : {24, 48, 96}) {
      Microstructure box;
      box.side = 6e-3;
      for (double x : {1.5e-3, 4.5e-3})
        for (double y : {1.5e-3, 4.5e-3}) box.discs.push_back({{x, y}, 2e-3});
      QuasistaticProblem problem{.discretisation = discretise(box, n),
                                 .materials = {{"binder", 1000.0, PronySeries(1e6), PronySeries(0, {{0.01, 0.5e6}})},
                                               {"filler", 1500.0, PronySeries(50e6), PronySeries(18.8e6)}},
                                 .volumetric = v};
      std::vector<double> times;
      for (int k = -320; k <= -80; ++k) times.push_back(std::pow(10.0, k / 80.0));
      const std::vector<Load> loads{Load::shear};
      auto t0 = std::chrono::steady_clock::now();
      const auto r = run_log_time_stepping(problem, loads, times);
      fmt::print("n {} unrelaxed {} time {} its {} fact {}\n", n, r.responses[0].unrelaxed,
                 std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count(), r.effort.iterations,
                 r.effort.factorisations);
      for (double t : {1e-3, 1e-2, 1e-1})
        for (size_t i = 0; i < times.size(); ++i)
          if (std::abs(times[i] / t - 1) < 1e-9)
            fmt::print("  {} {} {}\n", t, r.responses[0].values[i], r.responses[0].error_estimates[i]);
    }
}

}  // namespace
}  // namespace breccia
