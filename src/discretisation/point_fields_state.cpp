#include "discretisation/point_fields_state.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <type_traits>

#include <fmt/format.h>

namespace breccia {

namespace {

/// The order of the single numbers of tuples of a size, from the order of the tuples.
parallel::OrderedPlaces places_of_numbers(const parallel::OrderedPlaces& tuples, std::size_t size) {
  return {size * tuples.count, [tuples, size](std::size_t i) { return size * tuples.place_of(i / size) + i % size; }};
}

/// Calls action(name, tuples) for all members of the fields except the phases.
template <class Fields, class Action>
void for_each_list(const std::string& group, Fields& fields, const Action& action) {
  action(group + "/displacement_m", fields.displacement);
  action(group + "/strain", fields.strain);
  action(group + "/stress_Pa", fields.stress);
}

/// The numbers of all tuples, one tuple after the other.
template <class Tuples>
auto numbers_of(Tuples& tuples) {
  constexpr std::size_t size = std::tuple_size_v<typename Tuples::value_type>;
  static_assert(sizeof(typename Tuples::value_type) == size * sizeof(double));
  return std::span(tuples.empty() ? nullptr : tuples.front().data(), size * tuples.size());
}

}  // namespace

template <int dim>
void save(StateWriter& state, const std::string& group, const Grid<dim>& grid,
          const std::vector<TimedFields<dim>>& fields) {
  state.write(group + "/count", static_cast<std::int64_t>(fields.size()));
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const auto one = fmt::format("{}/{}", group, i);
    state.write(one + "/time_s", fields[i].time);
    const auto places = places_of_timed_fields(grid, fields[i].fields.cells);
    for_each_list(one, fields[i].fields, [&](const std::string& name, const auto& tuples) {
      constexpr std::size_t size = std::tuple_size_v<typename std::decay_t<decltype(tuples)>::value_type>;
      state.write(name, numbers_of(tuples), places_of_numbers(places, size), size * size_of_timed_fields(grid));
    });
  }
}

template <int dim>
std::vector<TimedFields<dim>> read_fields(const StateReader& state, const std::string& group,
                                          const Discretisation<dim>& discretisation, const IndexRange<dim>& cells) {
  std::vector<TimedFields<dim>> fields;
  const auto& grid = discretisation.grid();
  const auto places = places_of_timed_fields(grid, cells);
  const auto count = state.integer(group + "/count");
  for (std::int64_t i = 0; i < count; ++i) {
    const auto one = fmt::format("{}/{}", group, i);
    auto& timed =
        fields.emplace_back(TimedFields<dim>{state.number(one + "/time_s"), zero_timed_fields(discretisation, cells)});
    for_each_list(one, timed.fields, [&](const std::string& name, auto& tuples) {
      constexpr std::size_t size = std::tuple_size_v<typename std::decay_t<decltype(tuples)>::value_type>;
      state.read(name, numbers_of(tuples), places_of_numbers(places, size), size * size_of_timed_fields(grid));
    });
  }
  return fields;
}

template void save(StateWriter&, const std::string&, const Grid<2>&, const std::vector<TimedFields<2>>&);
template void save(StateWriter&, const std::string&, const Grid<3>&, const std::vector<TimedFields<3>>&);
template std::vector<TimedFields<2>> read_fields(const StateReader&, const std::string&, const Discretisation<2>&,
                                                 const IndexRange<2>&);
template std::vector<TimedFields<3>> read_fields(const StateReader&, const std::string&, const Discretisation<3>&,
                                                 const IndexRange<3>&);

}  // namespace breccia
