#include "packing_state.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "breccia/checkpoint/pairs.hpp"
#include "breccia/error.hpp"

namespace breccia {
namespace {

/// Throws FileError if a number is not the index of a particle.
std::uint32_t particle(double number) {
  constexpr double most = std::numeric_limits<std::uint32_t>::max();
  const bool is_one = number >= 0.0 && number <= most && std::floor(number) == number;
  if (!is_one) throw FileError("a checkpoint of a packing: expected the numbers of its particles");
  return static_cast<std::uint32_t>(number);
}

/// Throws FileError if a number is negative.
std::uint64_t count(const StateReader& state, const std::string& name) {
  const auto counted = state.integer(name);
  if (counted < 0) throw FileError(fmt::format("a checkpoint of a packing: {}: expected a count", name));
  return static_cast<std::uint64_t>(counted);
}

}  // namespace

void save(StateWriter& state, const PackingState<2>& packing) {
  state.write("/jams", static_cast<std::int64_t>(packing.jams));
  state.write("/largest_scale", packing.largest_scale);
  state.write("/scale", packing.scale);
  state.write("/events", static_cast<std::int64_t>(packing.events));
  save_pairs(state, "/position_x", "/position_y", packing.positions);
  save_pairs(state, "/velocity_x", "/velocity_y", packing.velocities);
  state.write("/queue", std::vector<double>(packing.queue.begin(), packing.queue.end()));
  state.write("/queue_time", packing.queue_times);
}

PackingState<2> read_packing_state(const StateReader& state) {
  PackingState<2> packing;
  packing.jams = count(state, "/jams");
  packing.largest_scale = state.number("/largest_scale");
  packing.scale = state.number("/scale");
  packing.events = count(state, "/events");
  packing.positions = read_pairs<Vector<2>>(state, "/position_x", "/position_y");
  packing.velocities = read_pairs<Vector<2>>(state, "/velocity_x", "/velocity_y");
  for (const double number : state.numbers("/queue")) packing.queue.push_back(particle(number));
  packing.queue_times = state.numbers("/queue_time");
  return packing;
}

}  // namespace breccia
