#include "space_views.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/report/volume_colours.hpp"
#include "breccia/results/field_files.hpp"

#include "field_view.hpp"
#include "microstructure_view.hpp"
#include "report_data.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// A file of fields, and the test that has left it.
struct FieldsOfTest {
  fs::path file;
  Load load;
  Boundary boundary;
};

template <class Word>
Word word_in(const Json& test, const char* key) {
  const auto name = test.at(key).get<std::string>();
  const auto value = value_named<Word>(name);
  if (!value) throw FileError(fmt::format("study.json: \"{}\" is no {} that `breccia run` gives", name, key));
  return *value;
}

/// The files of fields of a stage that are there.
std::vector<FieldsOfTest> fields_of(const fs::path& directory, const Json& stage) {
  std::vector<FieldsOfTest> files;
  for (const auto& test : stage.at("tests")) {
    if (!test.contains("fields")) continue;
    for (const auto& field : test.at("fields")) {
      const auto name = field.at("file").get<std::string>();
      if (!is_of_fields(name)) {
        throw FileError(fmt::format("study.json: \"{}\" is not a name that `breccia run` gives", name));
      }
      if (!is_there(directory / name)) continue;
      files.push_back({directory / name, word_in<Load>(test, "load"), word_in<Boundary>(test, "boundary")});
    }
  }
  return files;
}

/// So many cells along an axis of each of these files that all of them take a few megabytes of a page.
std::size_t most_cells_along(std::size_t files) {
  constexpr double bytes_of_cell = 3.0, most_bytes = 6e6;
  constexpr std::size_t most = 64, fewest = 16;
  const double cells = most_bytes / (bytes_of_cell * static_cast<double>(files));
  return std::clamp(static_cast<std::size_t>(std::cbrt(cells)), fewest, most);
}

}  // namespace

Json space_views(const fs::path& directory, const Json& study) {
  const auto& stages = study.at("stages");
  const auto is_in_space = [](const Json& stage) { return stage.value("dimensions", 2) == 3; };
  if (!std::ranges::any_of(stages, is_in_space)) return {};
  std::size_t files = 0;
  for (const auto& stage : stages) files += fields_of(directory / stage.at("name").get<std::string>(), stage).size();
  Json by_stage = Json::object();
  for (const auto& stage : stages) {
    if (!is_in_space(stage)) continue;
    const auto name = stage.at("name").get<std::string>();
    Json fields = Json::object();
    for (const auto& [file, load, boundary] : fields_of(directory / name, stage)) {
      fields[file.filename().string()] = field_view(file, load, boundary, most_cells_along(files));
    }
    by_stage[name] = {{"microstructure", microstructure_view(directory / name)}, {"fields", std::move(fields)}};
  }
  return {{"colours", colours_of_fields()}, {"stages", std::move(by_stage)}};
}

}  // namespace breccia
