#include "breccia/study/report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "breccia/error.hpp"
#include "breccia/io/text_file.hpp"
#include "breccia/report/page.hpp"
#include "breccia/study/respond.hpp"

#include "results.hpp"

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

Json json_of(const StoredResponses::Entry& entry) {
  const auto& response = entry.response;
  Json snapshots = Json::array();
  for (const auto& [matrix, error] : response.snapshots) {
    snapshots.push_back({{"shear_Pa", matrix.shear}, {"bulk_Pa", matrix.bulk}});
  }
  return {{"load", name_of(response.load)},
          {"boundary", name_of(response.boundary)},
          {"cells", entry.cells},
          {"filler_Pa", json_of(response.filler)},
          {"matrix_shear", json_of(response.matrix_shear)},
          {"matrix_bulk", json_of(response.matrix_bulk)},
          {"load_forces", std::vector<double>(response.load_forces.begin(), response.load_forces.end())},
          {"snapshots", std::move(snapshots)}};
}

Json responses_of(const fs::path& file, const std::string& hash) {
  const auto stored = read_responses(file);
  if (stored.deck_hash != hash) {
    throw FileError(
        fmt::format("{}: of another study (hash {}) than study.json (hash {})", file.string(), stored.deck_hash, hash));
  }
  Json responses = Json::array();
  for (const auto& entry : stored.entries) responses.push_back(json_of(entry));
  return responses;
}

Json read_study_record(const fs::path& directory) {
  const auto file = directory / "study.json";
  if (fs::is_regular_file(file)) {
    auto study = Json::parse(read_text(file), nullptr, false);
    if (study.is_object()) return study;
    throw FileError(fmt::format("{}: not as `breccia run` writes it", file.string()));
  }
  const bool is_sweep = fs::is_regular_file(directory / "sweep.json");
  throw InputError(fmt::format("{}: {}", directory.string(),
                               is_sweep
                                   ? "the results of a sweep: each of its tasks has a directory and a report of its own"
                                   : "no study.json, which `breccia run` leaves with its results"));
}

/// Everything that the page shows, as it is on the disk.
Json data_of(const fs::path& directory, Json study) {
  Json tables = Json::object(), pictures = Json::object(), responses = Json::object();
  auto names = curve_files();
  names.emplace_back("comparison.csv");
  for (const auto& name : names) {
    if (fs::exists(directory / name)) tables[name] = read_text(directory / name);
  }
  const auto hash = study.at("hash").get<std::string>();
  for (const auto& stage : study.at("stages")) {
    const auto name = stage.at("name").get<std::string>();
    const auto picture = directory / name / "microstructure.svg", response = directory / name / "response.h5";
    if (fs::exists(picture)) pictures[name] = read_text(picture);
    if (fs::exists(response)) responses[name] = responses_of(response, hash);
  }
  return {{"study", std::move(study)},
          {"tables", std::move(tables)},
          {"pictures", std::move(pictures)},
          {"responses", std::move(responses)}};
}

}  // namespace

void write_report(const std::filesystem::path& directory) {
  auto study = read_study_record(directory);
  std::string title;
  Json data;
  try {
    title = study.at("title").get<std::string>();
    data = data_of(directory, std::move(study));
  } catch (const Json::exception& error) {
    throw FileError(
        fmt::format("{}: not as `breccia run` writes it: {}", (directory / "study.json").string(), error.what()));
  }
  write_text(directory / "report.html", report_page(title, data.dump(-1, ' ', false, Json::error_handler_t::replace)));
}

}  // namespace breccia
