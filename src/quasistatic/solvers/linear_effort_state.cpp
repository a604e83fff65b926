#include "quasistatic/solvers/linear_effort_state.hpp"

#include <cstdint>

namespace breccia {

void save(StateWriter& state, const std::string& group, const LinearEffort& effort) {
  state.write(group + "/is_direct", std::int64_t{effort.is_direct});
  state.write(group + "/unknowns", effort.unknowns);
  state.write(group + "/factorisations", std::int64_t{effort.factorisations});
  state.write(group + "/solves", std::int64_t{effort.solves});
  state.write(group + "/iterations", std::int64_t{effort.iterations});
  state.write(group + "/most_iterations", std::int64_t{effort.most_iterations});
  state.write(group + "/largest_residual", effort.largest_residual);
}

LinearEffort read_effort(const StateReader& state, const std::string& group) {
  const auto count = [&](const char* name) { return static_cast<int>(state.integer(group + name)); };
  return {.is_direct = count("/is_direct") != 0,
          .unknowns = state.integer(group + "/unknowns"),
          .factorisations = count("/factorisations"),
          .solves = count("/solves"),
          .iterations = count("/iterations"),
          .most_iterations = count("/most_iterations"),
          .largest_residual = state.number(group + "/largest_residual")};
}

}  // namespace breccia
