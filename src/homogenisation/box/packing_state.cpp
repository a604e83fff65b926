#include "homogenisation/box/packing_state.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

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

constexpr std::array axes = {"x", "y", "z"};

/// Writes vectors as one list for each axis.
template <int dim>
void save_vectors(StateWriter& state, const std::string& name, const std::vector<Vector<dim>>& vectors) {
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dim); ++axis) {
    std::vector<double> along;
    along.reserve(vectors.size());
    for (const auto& vector : vectors) along.push_back(vector[axis]);
    state.write(fmt::format("{}_{}", name, axes[axis]), along);
  }
}

/// Reads vectors from one list for each axis. Throws FileError when a list is missing or the lists differ in length.
template <int dim>
std::vector<Vector<dim>> read_vectors(const StateReader& state, const std::string& name) {
  std::vector<Vector<dim>> vectors(state.numbers(fmt::format("{}_{}", name, axes[0])).size());
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dim); ++axis) {
    const auto along = state.numbers(fmt::format("{}_{}", name, axes[axis]), vectors.size());
    for (std::size_t i = 0; i < vectors.size(); ++i) vectors[i][axis] = along[i];
  }
  return vectors;
}

}  // namespace

template <int dim>
void save(StateWriter& state, const PackingState<dim>& packing) {
  state.write("/jams", static_cast<std::int64_t>(packing.jams));
  state.write("/largest_scale", packing.largest_scale);
  state.write("/scale", packing.scale);
  state.write("/events", static_cast<std::int64_t>(packing.events));
  save_vectors<dim>(state, "/position", packing.positions);
  save_vectors<dim>(state, "/velocity", packing.velocities);
  state.write("/queue", std::vector<double>(packing.queue.begin(), packing.queue.end()));
  state.write("/queue_time", packing.queue_times);
}

template <int dim>
PackingState<dim> read_packing_state(const StateReader& state) {
  PackingState<dim> packing;
  packing.jams = count(state, "/jams");
  packing.largest_scale = state.number("/largest_scale");
  packing.scale = state.number("/scale");
  packing.events = count(state, "/events");
  packing.positions = read_vectors<dim>(state, "/position");
  packing.velocities = read_vectors<dim>(state, "/velocity");
  for (const double number : state.numbers("/queue")) packing.queue.push_back(particle(number));
  packing.queue_times = state.numbers("/queue_time");
  return packing;
}

template void save(StateWriter&, const PackingState<2>&);
template void save(StateWriter&, const PackingState<3>&);
template PackingState<2> read_packing_state(const StateReader&);
template PackingState<3> read_packing_state(const StateReader&);

}  // namespace breccia
