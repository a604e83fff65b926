#include "breccia/homogenisation/stage_microstructure_state.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "breccia/error.hpp"

#include "microstructure_measures.hpp"

namespace breccia {

void save(StateWriter& state, const StageMicrostructure& microstructure) {
  const auto& [side, walls, discs] = microstructure.microstructure;
  std::vector<double> x, y, diameters;
  for (const auto& disc : discs) {
    x.push_back(disc.centre[0]);
    y.push_back(disc.centre[1]);
    diameters.push_back(disc.diameter);
  }
  state.write("/side_m", side);
  state.write("/walls", static_cast<std::int64_t>(walls));
  state.write("/x_m", x);
  state.write("/y_m", y);
  state.write("/diameter_m", diameters);
  if (microstructure.size_deviation) state.write("/size_deviation", *microstructure.size_deviation);
  state.write("/events", static_cast<std::int64_t>(microstructure.events));
  state.write(packing_seconds_name, microstructure.seconds);
}

StageMicrostructure read_stage_microstructure(const StateReader& state) {
  StageMicrostructure result;
  auto& [side, walls, discs] = result.microstructure;
  side = state.number("/side_m");
  walls = static_cast<Walls>(state.integer("/walls"));
  const auto x = state.numbers("/x_m");
  const auto y = state.numbers("/y_m", x.size());
  const auto diameters = state.numbers("/diameter_m", x.size());
  for (std::size_t i = 0; i < x.size(); ++i) discs.push_back({{x[i], y[i]}, diameters[i]});
  const auto is_in_box = [side = side](const Disc& disc) {
    const auto is_within = [side](double value) { return value >= 0.0 && value <= side; };
    return is_within(disc.centre[0]) && is_within(disc.centre[1]) && is_within(disc.diameter) && disc.diameter > 0.0;
  };
  const bool has_walls = walls == Walls::hard || walls == Walls::periodic;
  if (!has_walls || !(side > 0.0 && std::isfinite(side)) || !std::ranges::all_of(discs, is_in_box)) {
    throw FileError("a checkpoint of a packing: expected discs in a box");
  }
  if (state.has("/size_deviation")) result.size_deviation = state.number("/size_deviation");
  result.events = static_cast<std::uint64_t>(state.integer("/events"));
  result.seconds = state.number(packing_seconds_name);
  measure(result);
  return result;
}

}  // namespace breccia
