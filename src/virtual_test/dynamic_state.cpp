#include "virtual_test/dynamic_state.hpp"

#include <cstdint>

#include <fmt/format.h>

#include "checkpoint/pairs.hpp"

namespace breccia {

void save_domain(StateWriter& state, const std::string& group, const TimeDomain& domain) {
  state.write(group + "/density_factor", domain.mass_scaling);
  state.write(group + "/time_step_s", domain.time_step);
  state.write(group + "/ramp_s", domain.ramp);
  state.write(group + "/window_begin_s", domain.window.begin);
  state.write(group + "/window_end_s", domain.window.end);
  state.write(group + "/steps", domain.steps);
  state.write(group + "/terms", static_cast<std::int64_t>(domain.terms));
  state.write(group + "/reduction_error", domain.reduction_error);
  state.write(group + "/seconds", domain.seconds);
  save_pairs(state, group + "/times_s", group + "/moduli_Pa", domain.history);
}

TimeDomain read_domain(const StateReader& state, const std::string& group) {
  TimeDomain domain;
  domain.mass_scaling = state.number(group + "/density_factor");
  domain.time_step = state.number(group + "/time_step_s");
  domain.ramp = state.number(group + "/ramp_s");
  domain.window = {state.number(group + "/window_begin_s"), state.number(group + "/window_end_s")};
  domain.steps = state.integer(group + "/steps");
  domain.terms = static_cast<std::size_t>(state.integer(group + "/terms"));
  domain.reduction_error = state.number(group + "/reduction_error");
  domain.seconds = state.number(group + "/seconds");
  domain.history = read_pairs<Sample>(state, group + "/times_s", group + "/moduli_Pa");
  return domain;
}

void save_domains(StateWriter& state, const std::vector<TimeDomain>& domains) {
  state.write("/domains_done", static_cast<std::int64_t>(domains.size()));
  for (std::size_t i = 0; i < domains.size(); ++i) save_domain(state, fmt::format("/domains/{}", i), domains[i]);
}

std::vector<TimeDomain> read_domains(const StateReader& state) {
  std::vector<TimeDomain> domains;
  const auto count = state.integer("/domains_done");
  for (std::int64_t i = 0; i < count; ++i) domains.push_back(read_domain(state, fmt::format("/domains/{}", i)));
  return domains;
}

}  // namespace breccia
