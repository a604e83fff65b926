#include "results/result_files.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "checkpoint/checkpoint.hpp"
#include "io/replacement.hpp"
#include "io/safe_name.hpp"
#include "io/text_file.hpp"
#include "results/field_files.hpp"
#include "results/history_file.hpp"
#include "study/result_names.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

constexpr std::array stage_files = {"microstructure.csv", "grains.csv",         "films.csv",   "polygons.csv",
                                    "crystals.csv",       "microstructure.svg", "cut-x.svg",   "cut-y.svg",
                                    "labels.npy",         "labels.vti",         "modulus.svg", "bulk_modulus.svg",
                                    "response.h5"};

bool is_among(const std::vector<std::string>& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

}  // namespace

bool is_file_of_a_stage(std::string_view name) {
  return std::ranges::find(stage_files, name) != stage_files.end() || is_history(name) || is_of_fields(name) ||
         is_checkpoint_file(name);
}

bool is_file_of_a_study(std::string_view name) {
  const auto slash = name.find('/');
  if (slash == std::string_view::npos) return is_among(files_of_a_study(), name);
  const auto stage = name.substr(0, slash), file = name.substr(slash + 1);
  return is_safe_name(stage) && stage != unfinished_directory && stays_in_directory(file) && is_file_of_a_stage(file);
}

void remove_partial_study_files(const fs::path& directory) {
  remove_partial_files(
      directory, [](std::string_view name) { return is_among(files_of_a_study(), name) || is_replacement_list(name); });
}

void remove_partial_stage_files(const fs::path& directory) {
  remove_partial_files(directory, is_file_of_a_stage);
}

void remove_partial_sweep_files(const fs::path& directory) {
  remove_partial_files(directory, [](std::string_view name) { return is_among(files_of_a_sweep(), name); });
}

std::vector<std::string> study_files_in(const fs::path& directory, const std::vector<std::string>& stages) {
  auto names = files_of_a_study();
  std::erase_if(names, [&](const std::string& name) { return !fs::exists(directory / name); });
  for (const auto& stage : stages) {
    std::error_code is_missing;
    for (const auto& entry : fs::directory_iterator(directory / stage, is_missing)) {
      const auto name = entry.path().filename().string();
      if (entry.is_regular_file() && is_file_of_a_stage(name)) names.push_back(fmt::format("{}/{}", stage, name));
    }
  }
  return names;
}

std::vector<std::string> sweep_files_in(const fs::path& directory) {
  auto names = files_of_a_sweep();
  std::erase_if(names, [&](const std::string& name) { return !fs::exists(directory / name); });
  return names;
}

}  // namespace breccia
