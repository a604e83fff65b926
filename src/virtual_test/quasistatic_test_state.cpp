#include "virtual_test/quasistatic_test_state.hpp"

#include <cstddef>
#include <cstdint>

#include <fmt/format.h>

#include "checkpoint/pairs.hpp"
#include "quasistatic/reduced/reduced_response_state.hpp"
#include "quasistatic/solvers/linear_effort_state.hpp"

namespace breccia {
namespace {

/// Writes pairs of numbers, such as times and moduli, to a group.
template <class Pairs>
void save_group(StateWriter& state, const std::string& group, const Pairs& pairs) {
  save_pairs(state, group + "/first", group + "/second", pairs);
}

template <class Pair>
std::vector<Pair> read_group(const StateReader& state, const std::string& group) {
  return read_pairs<Pair>(state, group + "/first", group + "/second");
}

void save_response(StateWriter& state, const std::string& group, const QuasistaticResponse& response) {
  state.write(group + "/load", static_cast<std::int64_t>(response.load));
  save_group(state, group + "/modulus", response.modulus);
  save_group(state, group + "/compliance", response.compliance);
  state.write(group + "/equilibrium_Pa", response.series.equilibrium());
  save_group(state, group + "/terms", response.series.terms());
  state.write(group + "/error_estimate", response.error_estimate);
  if (response.fit_error) state.write(group + "/fit_error", *response.fit_error);
  if (response.reduced) save(state, group + "/reduced", *response.reduced);
}

QuasistaticResponse read_response_to_load(const StateReader& state, const std::string& group) {
  QuasistaticResponse response;
  response.load = read_load(state, group + "/load");
  response.modulus = read_group<Sample>(state, group + "/modulus");
  response.compliance = read_group<CreepSample>(state, group + "/compliance");
  response.series =
      PronySeries(state.number(group + "/equilibrium_Pa"), read_group<MaxwellTerm>(state, group + "/terms"));
  response.error_estimate = state.number(group + "/error_estimate");
  if (state.has(group + "/fit_error")) response.fit_error = state.number(group + "/fit_error");
  if (state.has(group + "/reduced")) response.reduced = read_response(state, group + "/reduced");
  return response;
}

}  // namespace

void save_result(StateWriter& state, const QuasistaticTestResult& result) {
  state.write("/responses", static_cast<std::int64_t>(result.responses.size()));
  for (std::size_t i = 0; i < result.responses.size(); ++i) {
    save_response(state, fmt::format("/response/{}", i), result.responses[i]);
  }
  save(state, "/effort", result.effort);
  state.write("/seconds", result.seconds);
}

QuasistaticTestResult read_quasistatic_result(const StateReader& state) {
  QuasistaticTestResult result;
  const auto count = state.integer("/responses");
  for (std::int64_t i = 0; i < count; ++i) {
    result.responses.push_back(read_response_to_load(state, fmt::format("/response/{}", i)));
  }
  result.effort = read_effort(state, "/effort");
  result.seconds = state.number("/seconds");
  return result;
}

}  // namespace breccia
