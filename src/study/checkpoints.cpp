#include "checkpoints.hpp"

#include <cstdint>
#include <system_error>

#include <fmt/format.h>

#include "breccia/io/text_file.hpp"

namespace breccia {

Checkpoints::Checkpoints(const Study& study, const std::filesystem::path& directory, const RunOptions& options,
                         const StudyObserver& observer)
    : study_(&study), directory_(&directory), options_(&options), observer_(&observer) {}

Checkpoint Checkpoints::of_packing(const Stage& stage) const {
  return open(stage, "packing");
}

Checkpoint Checkpoints::of_quasistatic(const Stage& stage, Boundary boundary, int cells) const {
  return open(stage, fmt::format("{}-{}-{}", name_of(boundary), name_of(Method::quasistatic), cells));
}

Checkpoint Checkpoints::of_dynamic(const Stage& stage, Load load, Boundary boundary, int cells) const {
  return open(stage, fmt::format("{}-{}-{}-{}", name_of(load), name_of(boundary), name_of(Method::dynamic), cells));
}

Checkpoint Checkpoints::open(const Stage& stage, const std::string& name) const {
  Checkpoint checkpoint(*directory_ / stage.name / (name + ".checkpoint.h5"), {study_->hash, BRECCIA_VERSION},
                        options_->checkpoints);
  if (!options_->resume) return checkpoint;
  for (const auto& problem : checkpoint.look_for_earlier()) {
    if (observer_->noted) observer_->noted(problem);
  }
  return checkpoint;
}

bool is_checkpoint(std::string_view name) {
  if (name.ends_with(".damaged")) name.remove_suffix(std::string_view(".damaged").size());
  return name.ends_with(".checkpoint.h5") || name.ends_with(".checkpoint.older.h5");
}

bool remove_checkpoints(const Study& study, const std::filesystem::path& directory) {
  bool were_any = false;
  for (const auto& stage : study.stages) {
    std::error_code is_missing;
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(directory / stage.name, is_missing)) {
      auto name = entry.path().filename().string();
      if (is_checkpoint(name)) names.push_back(std::move(name));
    }
    remove_files(directory / stage.name, names);
    were_any = were_any || !names.empty();
  }
  return were_any;
}

void remove_partial_files(const Study& study, const std::filesystem::path& directory) {
  remove_partial_files(directory);
  for (const auto& stage : study.stages) remove_partial_files(directory / stage.name);
}

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
