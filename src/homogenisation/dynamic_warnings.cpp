#include "homogenisation/dynamic_warnings.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "virtual_test/ringing.hpp"
#include "virtual_test/time_domains.hpp"

namespace breccia {
namespace {

std::optional<std::string> warning_after(double transits, const char* remedy) {
  constexpr double matters = 0.05;
  const double ringing = ringing_after_ramp(transits);
  if (ringing <= matters) return std::nullopt;
  return fmt::format(
      "under tractions a ramp of {:.2g} transits of the shear wave leaves a box ringing by up to {:.0f} % of its "
      "compliance: the dynamic modulus may be that of its inertia; {}",
      transits, 100.0 * ringing, remedy);
}

}  // namespace

std::optional<std::string> warning_of_ringing(const Tests& tests) {
  const bool creeps = std::ranges::count(tests.methods, Method::dynamic) > 0 &&
                      std::ranges::count(tests.boundaries, Boundary::traction) > 0;
  if (!creeps || tests.dynamic.ramp_time) return std::nullopt;
  return warning_after(tests.dynamic.creep_ramp_transits, "creep_ramp_transits = 5 leaves 1 %");
}

std::vector<std::string> warnings_on_domains(const Tests& tests, Boundary boundary,
                                             const std::vector<TimeDomain>& domains) {
  std::vector<std::string> warnings;
  if (domains.empty()) return warnings;
  if (boundary == Boundary::traction && tests.dynamic.ramp_time) {
    // The window of the first domain begins after this number of transits.
    const auto& first = domains.front();
    const double transits = 2.0 * there_and_back_transits * first.ramp / first.window.begin;
    if (auto warning = warning_after(transits, "a longer ramp rings less")) warnings.push_back(*std::move(warning));
  }
  constexpr double matters = 0.005;
  const double error = std::ranges::max(domains, {}, &TimeDomain::reduction_error).reduction_error;
  if (error > matters) {
    warnings.push_back(
        fmt::format("Prony terms that are left out may change the dynamic modulus by up to {:.2g} %; a smaller "
                    "tests.dynamic.reduction_tolerance keeps more of them",
                    100.0 * error));
  }
  return warnings;
}

}  // namespace breccia
