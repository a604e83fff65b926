#include "page/study_report.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <variant>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "breccia/error.hpp"

#include "io/text_file.hpp"
#include "page/page.hpp"
#include "page/report_data.hpp"
#include "page/report_tables.hpp"
#include "page/space_views.hpp"
#include "results/history_file.hpp"
#include "results/response_file.hpp"
#include "results/stiffness_file.hpp"
#include "results/study_document.hpp"
#include "study/result_names.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json json_of(const Eigen::MatrixXd& matrix) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    Json& row = rows.emplace_back(Json::array());
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) row.push_back(matrix(i, j));
  }
  return rows;
}

/// Moduli of a phase in the snapshots.
Json json_of_snapshots(const ReducedResponse& response, std::size_t phase) {
  Json snapshots = Json::array();
  for (const auto& snapshot : response.snapshots) {
    const auto& [bulk, shear] = snapshot.moduli[phase];
    snapshots.push_back({{"shear_Pa", shear}, {"bulk_Pa", bulk}});
  }
  return snapshots;
}

/// The rows of a symmetric matrix from the diagonal on.
Json upper_triangle_of(const Eigen::MatrixXd& matrix) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    Json& row = rows.emplace_back(Json::array());
    for (Eigen::Index j = i; j < matrix.cols(); ++j) row.push_back(matrix(i, j));
  }
  return rows;
}

/// Adds the parts of the phases other than the matrix, and the data for the error estimate: with several phases, moduli
/// that are covered one by one may not be covered together.
void add_phases(const ReducedResponse& response, const std::map<std::string, Material>& other_phases, Json& json) {
  const auto names = response.phases();
  json["phases"] = Json::array();
  for (std::size_t phase = 1; phase < names.size(); ++phase) {
    json["phases"].push_back({{"material", other_phases.at(names[phase]).name},
                              {"shear", json_of(response.part({names[phase], ElasticModulus::shear}))},
                              {"bulk", json_of(response.part({names[phase], ElasticModulus::bulk}))},
                              {"snapshots", json_of_snapshots(response, phase)}});
  }
  json["residual_products"] = upper_triangle_of(response.residual_products);
  json["residual_scale"] = response.residual_scale;
}

/// A number of cells, or "films".
Json json_of(TestGrid grid) {
  const auto cells = grid.cells();
  return cells ? Json(*cells) : Json(name_of(grid));
}

Json json_of(const StageResponses::Entry& entry, const std::map<std::string, Material>& other_phases) {
  const auto& response = entry.response;
  Json json = {{"load", name_of(response.load)},
               {"boundary", name_of(response.boundary)},
               {"cells", json_of(entry.grid)},
               {"filler_Pa", json_of(response.constant)},
               {"matrix_shear", json_of(response.part(ElasticModulus::shear))},
               {"matrix_bulk", json_of(response.part(ElasticModulus::bulk))},
               {"load_forces", std::vector<double>(response.load_forces.begin(), response.load_forces.end())},
               {"snapshots", json_of_snapshots(response, 0)}};
  if (!other_phases.empty()) add_phases(response, other_phases, json);
  return json;
}

void refuse_foreign(const fs::path& file, const std::string& its_hash, const std::string& hash) {
  if (its_hash == hash) return;
  throw FileError(
      fmt::format("{}: of another study (hash {}) than study.json (hash {})", file.string(), its_hash, hash));
}

Json responses_of(const fs::path& file, const std::string& hash) {
  const auto stored = read_responses(file);
  refuse_foreign(file, stored.deck_hash, hash);
  // With mixed cells the finest grid gives the results, with points all grids do.
  Json responses = Json::array();
  if (stored.entries.empty()) return responses;
  const auto finest = std::ranges::max(stored.entries, {}, &StageResponses::Entry::grid).grid;
  for (const auto& entry : stored.entries) {
    if (stored.mixing == Mixing::points || entry.grid == finest) {
      responses.push_back(json_of(entry, stored.other_phases));
    }
  }
  return responses;
}

/// The history of each time domain of a stage, as an outline.
Json histories_of(const fs::path& directory, const StageEntry& stage, const std::string& hash) {
  Json histories = Json::array();
  for (const auto& [id, record, fields] : stage.tests) {
    const auto* const dynamic = std::get_if<DynamicEntry>(&record);
    const auto domains = dynamic == nullptr ? 0 : dynamic->domains.size();
    for (std::size_t number = 1; number <= domains; ++number) {
      const auto cells = id.grid.cells().value_or(0);
      const auto file = directory / history_file(name_of(id.load), name_of(id.boundary), cells, number);
      if (!is_there(file)) continue;
      const auto history = outline_of(read_history(file));
      refuse_foreign(file, history.deck_hash, hash);
      histories.push_back({{"load", name_of(id.load)},
                           {"boundary", name_of(id.boundary)},
                           {"cells", json_of(id.grid)},
                           {"domain", number - 1},
                           {"time_s", rounded(history.times)},
                           {"value", rounded(history.values)}});
    }
  }
  return histories;
}

/// The pictures of the fields of a stage, by their names.
Json field_pictures_of(const fs::path& directory, const StageEntry& stage) {
  Json pictures = Json::object();
  for (const auto& test : stage.tests) {
    for (const auto& files : test.fields) {
      for (const auto& name : {files.stress_picture, files.strain_picture, files.work_picture}) {
        if (!name.empty() && is_there(directory / name)) pictures[name] = read_text(directory / name);
      }
    }
  }
  return pictures;
}

/// All data that the page shows, from the files.
Json data_of(const fs::path& directory, const StudyDocument& study) {
  Json tables = Json::object(), pictures = Json::object(), fields = Json::object(), responses = Json::object(),
       histories = Json::object();
  auto names = curve_files();
  std::ranges::copy(comparison_files(), std::back_inserter(names));
  names.emplace_back("thermal_expansion.csv");
  names.emplace_back(stiffness_file);
  std::erase(names, "dynamic.csv");  // the page computes dynamic moduli from the series
  for (const auto& name : names) {
    auto table = table_for_page(directory / name, text_columns_of_tests());
    if (!table.empty()) tables[name] = std::move(table);
  }
  for (const auto& stage : study.stages) {
    const auto& name = stage.name;
    const auto picture = directory / name / "microstructure.svg", response = directory / name / "response.h5";
    if (is_there(picture)) pictures[name] = read_text(picture);
    fields[name] = field_pictures_of(directory / name, stage);
    if (is_there(response)) responses[name] = responses_of(response, study.hash);
    histories[name] = histories_of(directory / name, stage, study.hash);
  }
  auto views = space_views(directory, study);
  Json data = {{"study", json_from(study)},   {"tables", std::move(tables)},       {"pictures", std::move(pictures)},
               {"fields", std::move(fields)}, {"responses", std::move(responses)}, {"histories", std::move(histories)}};
  if (!views.is_null()) data["views"] = std::move(views);
  return data;
}

PageData page_data_of(const fs::path& directory, const StudyDocument& study) {
  return page_data(directory / "study.json", [&]() -> TitledData { return {study.title, data_of(directory, study)}; });
}

}  // namespace

PageData study_page_data(const fs::path& directory) {
  return page_data_of(directory, read_study_document(directory));
}

void write_study_report(const fs::path& directory) {
  write_study_report(directory, read_study_document(directory));
}

void write_study_report(const fs::path& directory, const StudyDocument& study) {
  const auto page = page_data_of(directory, study);
  const auto put_together = page.has_views ? study_page_with_views : study_page;
  write_text(directory / "report.html", put_together(page.title, page.json));
}

}  // namespace breccia
