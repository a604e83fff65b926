#include "page/space_views.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "page/field_view.hpp"
#include "page/microstructure_view.hpp"
#include "page/report_data.hpp"
#include "report/volume_colours.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// A file of fields, and the test that wrote it.
struct FieldsOfTest {
  fs::path file;
  Load load;
  Boundary boundary;
  std::size_t most_along;  ///< number of cells along an axis that are drawn at most
};

/// The existing files of fields of a stage.
std::vector<FieldsOfTest> fields_of(const fs::path& directory, const StageEntry& stage) {
  // Films are thin: they need more cells, and these have the few values of the pieces, which take little of a page.
  constexpr std::size_t of_cells = 64, of_films = 128;
  std::vector<FieldsOfTest> files;
  for (const auto& test : stage.tests) {
    for (const auto& field : test.fields) {
      if (!is_there(directory / field.file)) continue;
      files.push_back({directory / field.file, test.id.load.of_test().value(), test.id.boundary,
                       test.id.grid.is_films() ? of_films : of_cells});
    }
  }
  return files;
}

/// Number of cells along an axis of each file, up to a number, with which all files together take a few megabytes of a
/// page.
std::size_t most_cells_along(std::size_t files, std::size_t most) {
  constexpr double bytes_of_cell = 3.0, most_bytes = 6e6;
  constexpr std::size_t fewest = 16;
  const double cells = most_bytes / (bytes_of_cell * static_cast<double>(files));
  return std::clamp(static_cast<std::size_t>(std::cbrt(cells)), fewest, most);
}

}  // namespace

Json space_views(const fs::path& directory, const StudyDocument& study) {
  const auto& stages = study.stages;
  const auto is_in_space = [](const StageEntry& stage) { return stage.dimensions == 3; };
  if (!std::ranges::any_of(stages, is_in_space)) return {};
  std::size_t files = 0;
  for (const auto& stage : stages) files += fields_of(directory / stage.name, stage).size();
  Json by_stage = Json::object();
  for (const auto& stage : stages) {
    if (!is_in_space(stage)) continue;
    Json fields = Json::object();
    for (const auto& [file, load, boundary, most_along] : fields_of(directory / stage.name, stage)) {
      fields[file.filename().string()] =
          field_view(file, stage.side, load, boundary, most_cells_along(files, most_along));
    }
    by_stage[stage.name] = {{"microstructure", microstructure_view(directory / stage.name)},
                            {"fields", std::move(fields)}};
  }
  return {{"colours", colours_of_fields()}, {"stages", std::move(by_stage)}};
}

}  // namespace breccia
