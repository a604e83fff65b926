#include "homogenisation/run/field_times_state.hpp"

#include <cstdint>

namespace breccia {
namespace {

constexpr auto number_of_fields = "/number_of_fields";
constexpr auto field_times = "/field_times_s";

}  // namespace

void save_field_times(StateWriter& state, const std::vector<double>& times) {
  state.write(number_of_fields, static_cast<std::int64_t>(times.size()));
  if (!times.empty()) state.write(field_times, times);
}

std::vector<double> read_field_times(const StateReader& state) {
  const auto count = state.integer(number_of_fields);
  if (count == 0) return {};
  return state.numbers(field_times, static_cast<std::size_t>(count));
}

}  // namespace breccia
