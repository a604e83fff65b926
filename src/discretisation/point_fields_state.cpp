#include "breccia/discretisation/point_fields_state.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <fmt/format.h>

namespace breccia {

namespace {

template <std::size_t size>
void save_tuples(StateWriter& state, const std::string& name, const std::vector<std::array<double, size>>& tuples) {
  static_assert(sizeof(std::array<double, size>) == size * sizeof(double));
  state.write(name, std::span(tuples.empty() ? nullptr : tuples.front().data(), size * tuples.size()));
}

template <std::size_t size>
void read_tuples(const StateReader& state, const std::string& name, std::vector<std::array<double, size>>& tuples) {
  const auto values = state.numbers(name, size * tuples.size());
  auto value = values.begin();
  for (auto& tuple : tuples) {
    for (auto& component : tuple) component = *value++;
  }
}

}  // namespace

template <int dim>
void save(StateWriter& state, const std::string& group, const std::vector<TimedFields<dim>>& fields) {
  state.write(group + "/count", static_cast<std::int64_t>(fields.size()));
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const auto one = fmt::format("{}/{}", group, i);
    state.write(one + "/time_s", fields[i].time);
    save_tuples(state, one + "/displacement_m", fields[i].fields.displacement);
    save_tuples(state, one + "/strain", fields[i].fields.strain);
    save_tuples(state, one + "/stress_Pa", fields[i].fields.stress);
  }
}

template <int dim>
std::vector<TimedFields<dim>> read_fields(const StateReader& state, const std::string& group,
                                          const Discretisation<dim>& discretisation) {
  std::vector<TimedFields<dim>> fields;
  const auto count = state.integer(group + "/count");
  for (std::int64_t i = 0; i < count; ++i) {
    const auto one = fmt::format("{}/{}", group, i);
    auto& timed =
        fields.emplace_back(TimedFields<dim>{state.number(one + "/time_s"), zero_timed_fields(discretisation)});
    read_tuples(state, one + "/displacement_m", timed.fields.displacement);
    read_tuples(state, one + "/strain", timed.fields.strain);
    read_tuples(state, one + "/stress_Pa", timed.fields.stress);
  }
  return fields;
}

template void save(StateWriter&, const std::string&, const std::vector<TimedFields<2>>&);
template void save(StateWriter&, const std::string&, const std::vector<TimedFields<3>>&);
template std::vector<TimedFields<2>> read_fields(const StateReader&, const std::string&, const Discretisation<2>&);
template std::vector<TimedFields<3>> read_fields(const StateReader&, const std::string&, const Discretisation<3>&);

}  // namespace breccia
