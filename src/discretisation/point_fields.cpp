#include "breccia/discretisation/point_fields.hpp"

#include <cstddef>
#include <cstdint>

#include <fmt/format.h>

namespace breccia {

PointFields zero_fields(const Discretisation& discretisation) {
  const auto& grid = discretisation.grid();
  const auto points = discretisation.points();
  PointFields fields;
  fields.material.resize(points);
  fields.displacement.resize(points);
  fields.strain.resize(points);
  fields.stress.resize(points);
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const auto& materials = discretisation.cell(column, row);
      for (std::size_t p = 0; p < points_per_cell; ++p) {
        fields.material[grid.point_index(column, row, static_cast<int>(p))] = materials[p];
      }
    }
  }
  return fields;
}

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

void save(StateWriter& state, const std::string& group, std::span<const TimedFields> fields) {
  state.write(group + "/count", static_cast<std::int64_t>(fields.size()));
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const auto one = fmt::format("{}/{}", group, i);
    state.write(one + "/time_s", fields[i].time);
    save_tuples(state, one + "/displacement_m", fields[i].fields.displacement);
    save_tuples(state, one + "/strain", fields[i].fields.strain);
    save_tuples(state, one + "/stress_Pa", fields[i].fields.stress);
  }
}

std::vector<TimedFields> read_fields(const StateReader& state, const std::string& group,
                                     const Discretisation& discretisation) {
  std::vector<TimedFields> fields;
  const auto count = state.integer(group + "/count");
  for (std::int64_t i = 0; i < count; ++i) {
    const auto one = fmt::format("{}/{}", group, i);
    auto& timed = fields.emplace_back(TimedFields{state.number(one + "/time_s"), zero_fields(discretisation)});
    read_tuples(state, one + "/displacement_m", timed.fields.displacement);
    read_tuples(state, one + "/strain", timed.fields.strain);
    read_tuples(state, one + "/stress_Pa", timed.fields.stress);
  }
  return fields;
}

}  // namespace breccia
