#include "breccia/results/stored_composite.hpp"

#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "breccia/error.hpp"
#include "breccia/io/text_file.hpp"
#include "breccia/results/stored_materials.hpp"
#include "breccia/tables/csv.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

/// The shares of fillers or coatings, of which a stage may have none.
void add_shares(const nlohmann::json& whole, const char* key, StageContent& stage) {
  if (!whole.contains(key)) return;
  for (const auto& share : whole.at(key)) {
    stage.shares.push_back({share.at("material").get<std::string>(), share.at("fraction").get<double>(),
                            share.at("mass_fraction").get<double>()});
  }
}

StageContent stage_content_of(const nlohmann::json& json) {
  StageContent stage{json.at("name").get<std::string>(), json.at("matrix").get<std::string>(),
                     json.at("dimensions").get<int>()};
  if (json.contains("filler_of_the_whole")) {
    add_shares(json.at("filler_of_the_whole"), "materials", stage);
    add_shares(json.at("filler_of_the_whole"), "coatings", stage);
  }
  return stage;
}

}  // namespace

std::vector<StageSeries> read_stored_series(const fs::path& directory) {
  const auto table = read_csv(directory / "prony.csv", {"stage", "load", "boundary"});
  const auto& times = table.numbers("relaxation_time_s");
  const auto& moduli = table.numbers("modulus_Pa");
  std::vector<StageSeries> all;
  double equilibrium = 0.0;
  std::vector<MaxwellTerm> terms;
  const auto finish = [&] {
    if (!all.empty()) all.back().series = PronySeries(equilibrium, std::exchange(terms, {}));
    equilibrium = 0.0;
  };
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto load = value_named<Load>(table.text("load")[row]);
    const auto boundary = value_named<Boundary>(table.text("boundary")[row]);
    if (!load || !boundary) {
      throw FileError(fmt::format("{}: not a load and a boundary condition of `breccia run`", table.location(row)));
    }
    const auto& stage = table.text("stage")[row];
    const bool is_next =
        !all.empty() && all.back().stage == stage && all.back().load == *load && all.back().boundary == *boundary;
    if (!is_next) {
      finish();
      all.push_back({stage, *load, *boundary});
    }
    if (std::isinf(times[row])) {
      equilibrium = moduli[row];
    } else {
      terms.push_back({times[row], moduli[row]});
    }
  }
  finish();
  return all;
}

StudyContent read_stored_content(const fs::path& directory) {
  const auto file = directory / "study.json";
  const auto refuse = [&](const std::string& reason) {
    throw FileError(fmt::format("{}: not as `breccia run` writes it{}", file.string(), reason));
  };
  StudyContent content;
  const auto json = nlohmann::json::parse(read_text(file), nullptr, false);
  if (!json.is_object()) refuse("");
  try {
    content.title = json.at("title").get<std::string>();
    content.times = {json.at("times_s").at(0).get<double>(), json.at("times_s").at(1).get<double>()};
    for (const auto& stage : json.at("stages")) content.stages.push_back(stage_content_of(stage));
  } catch (const nlohmann::json::exception& error) {
    refuse(fmt::format(": {}", error.what()));
  }
  content.materials = read_stored_materials(directory).materials;
  return content;
}

void require_stored_study(const fs::path& directory) {
  const auto name = directory.string();
  if (!fs::is_directory(directory)) throw InputError(fmt::format("{}: no such directory", name));
  if (fs::exists(directory / "sweep.json")) {
    throw InputError(fmt::format("{}: the results of a sweep; name the directory of one of its tasks", name));
  }
  if (fs::exists(directory / "respond.json") && !fs::exists(directory / "study.json")) {
    throw AnsweredResults(
        fmt::format("{}: curves of an answered response, without what the composite is made of; name the results that "
                    "they were answered from",
                    name));
  }
  for (const auto* file : {"prony.csv", "study.json"}) {
    if (fs::exists(directory / file)) continue;
    throw InputError(fmt::format("{}: no {}, which a run writes after its first test", name, file));
  }
}

Composite read_stored_composite(const fs::path& directory, const CompositeChoice& choice) {
  require_stored_study(directory);
  return composite_of(read_stored_content(directory), read_stored_series(directory), choice, directory.string());
}

}  // namespace breccia
