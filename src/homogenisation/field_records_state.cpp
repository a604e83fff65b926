#include "field_records_state.hpp"

#include <cstdint>

#include <fmt/format.h>

namespace breccia {

void save(StateWriter& state, const std::vector<FieldRecord>& fields) {
  state.write("/field_files", static_cast<std::int64_t>(fields.size()));
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const auto group = fmt::format("/field_file/{}", i);
    state.write(group + "/time_s", fields[i].time);
    state.write(group + "/file", fields[i].file);
    state.write(group + "/stress_picture", fields[i].stress_picture);
    state.write(group + "/strain_picture", fields[i].strain_picture);
  }
}

std::vector<FieldRecord> read_field_records(const StateReader& state) {
  std::vector<FieldRecord> fields;
  const auto count = state.integer("/field_files");
  for (std::int64_t i = 0; i < count; ++i) {
    const auto group = fmt::format("/field_file/{}", i);
    fields.push_back({state.number(group + "/time_s"), state.text(group + "/file"),
                      state.text(group + "/stress_picture"), state.text(group + "/strain_picture")});
  }
  return fields;
}

}  // namespace breccia
