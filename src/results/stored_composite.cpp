#include "breccia/results/stored_composite.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "breccia/error.hpp"
#include "breccia/io/csv.hpp"
#include "breccia/io/nearest_name.hpp"
#include "breccia/io/text_file.hpp"
#include "breccia/results/stored_materials.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

/// A series of prony.csv.
struct StoredSeries {
  std::string stage;
  Load load = Load::shear;
  Boundary boundary = Boundary::displacement;
  double equilibrium = 0.0;
  std::vector<MaxwellTerm> terms = {};
};

/// Adds a value to a list that has each value once.
template <class Value>
void add_once(std::vector<Value>& list, const Value& value) {
  if (std::ranges::find(list, value) == list.end()) list.push_back(value);
}

std::vector<StoredSeries> read_series_of_tests(const fs::path& file) {
  const auto table = read_csv(file, {"stage", "load", "boundary"});
  const auto& times = table.numbers("relaxation_time_s");
  const auto& moduli = table.numbers("modulus_Pa");
  std::vector<StoredSeries> all;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto load = value_named<Load>(table.text("load")[row]);
    const auto boundary = value_named<Boundary>(table.text("boundary")[row]);
    if (!load || !boundary) {
      throw FileError(fmt::format("{}: not a load and a boundary condition of `breccia run`", table.place(row)));
    }
    const auto& stage = table.text("stage")[row];
    const bool is_next =
        !all.empty() && all.back().stage == stage && all.back().load == *load && all.back().boundary == *boundary;
    if (!is_next) all.push_back({stage, *load, *boundary});
    if (std::isinf(times[row])) {
      all.back().equilibrium = moduli[row];
    } else {
      all.back().terms.push_back({times[row], moduli[row]});
    }
  }
  return all;
}

/// What study.json tells of a stage.
struct StageOfStudy {
  std::string matrix;
  int dimensions = 2;
  std::vector<std::string> materials;                                ///< of the fillers and coatings
  std::optional<std::pair<std::string, double>> density_ratio = {};  ///< of a material to the density of the whole [-]
};

struct StudyOnDisk {
  std::string title;
  TimeWindow times;
  std::map<std::string, StageOfStudy> stages;
};

/// The share by mass over that by volume of a material is its density over that of the composite.
void read_density_ratio(const nlohmann::json& whole, StageOfStudy& stage) {
  for (const auto& share : whole.at("materials")) {
    const auto name = share.at("material").get<std::string>();
    add_once(stage.materials, name);
    const double fraction = share.at("fraction").get<double>();
    if (fraction > 0.0) stage.density_ratio = {name, share.at("mass_fraction").get<double>() / fraction};
  }
  if (!whole.contains("coatings")) return;
  for (const auto& share : whole.at("coatings")) add_once(stage.materials, share.at("material").get<std::string>());
}

StudyOnDisk read_study_on_disk(const fs::path& file) {
  const auto refuse = [&](const std::string& reason) {
    throw FileError(fmt::format("{}: not as `breccia run` writes it{}", file.string(), reason));
  };
  StudyOnDisk study;
  const auto json = nlohmann::json::parse(read_text(file), nullptr, false);
  if (!json.is_object()) refuse("");
  try {
    study.title = json.at("title").get<std::string>();
    study.times = {json.at("times_s").at(0).get<double>(), json.at("times_s").at(1).get<double>()};
    for (const auto& one : json.at("stages")) {
      StageOfStudy stage;
      stage.matrix = one.at("matrix").get<std::string>();
      stage.dimensions = one.at("dimensions").get<int>();
      if (one.contains("filler_of_the_whole")) read_density_ratio(one.at("filler_of_the_whole"), stage);
      study.stages.emplace(one.at("name").get<std::string>(), std::move(stage));
    }
  } catch (const nlohmann::json::exception& error) {
    refuse(fmt::format(": {}", error.what()));
  }
  return study;
}

/// The binder at the end of a chain of matrices.
std::string binder_of_chain(const StudyOnDisk& study, const std::string& stage) {
  auto name = stage;
  for (std::size_t links = 0; links <= study.stages.size(); ++links) {
    const auto found = study.stages.find(name);
    if (found == study.stages.end()) return name;
    name = found->second.matrix;
  }
  return name;
}

bool is_elastic(const Material& material) {
  return material.bulk.is_elastic() && material.shear.is_elastic();
}

/// Density and temperature shift of the composite.
void add_materials(const fs::path& directory, const StudyOnDisk& study, StoredComposite& composite) {
  const auto stored = read_stored_materials(directory).materials;
  const auto find = [&](const std::string& name) {
    const auto found = std::ranges::find(
        stored, name, [](const StoredMaterial& one) -> const std::string& { return one.material.name; });
    if (found == stored.end()) {
      throw FileError(fmt::format("{}: no material \"{}\"", (directory / "study.json").string(), name));
    }
    return *found;
  };
  const auto& stage = study.stages.at(composite.stage);
  const auto binder = find(binder_of_chain(study, composite.stage));
  composite.density = stage.density_ratio
                          ? find(stage.density_ratio->first).material.density / stage.density_ratio->second
                          : binder.material.density;
  const bool relaxes_by_binder_alone =
      std::ranges::all_of(stage.materials, [&](const std::string& name) { return is_elastic(find(name).material); });
  if (relaxes_by_binder_alone) composite.shift = binder.shift;
}

void refuse_other_directories(const fs::path& directory) {
  const auto name = directory.string();
  if (!fs::is_directory(directory)) throw InputError(fmt::format("{}: no such directory", name));
  if (fs::exists(directory / "sweep.json")) {
    throw InputError(fmt::format("{}: the results of a sweep; name the directory of one of its tasks", name));
  }
  for (const auto* file : {"prony.csv", "study.json"}) {
    if (fs::exists(directory / file)) continue;
    throw InputError(fmt::format("{}: no {}, which `breccia run` writes after the first test", name, file));
  }
}

template <class Enum>
std::vector<std::string> words_of(const std::vector<Enum>& values) {
  std::vector<std::string> words(values.size());
  std::ranges::transform(values, words.begin(), [](Enum value) { return name_of(value); });
  return words;
}

/// Resolves the choice among the series of one study and collects its mistakes.
class Chooser {
 public:
  Chooser(const fs::path& directory, const std::vector<StoredSeries>& series, CompositeChoice choice)
      : place_(directory.string()), series_(series), choice_(std::move(choice)) {}

  /// The choice with nothing left open.
  CompositeChoice resolved() {
    choose_stage();
    if (!mistakes_.empty()) refuse();
    choose_boundary();
    choose_load();
    refuse();
    return choice_;
  }

 private:
  void choose_stage() {
    std::vector<std::string> stages;
    for (const auto& one : series_) add_once(stages, one.stage);
    if (stages.empty()) {
      mistakes_.push_back(fmt::format("{}: prony.csv has no series; no test is finished", place_));
    } else if (choice_.stage.empty()) {
      choice_.stage = stages.back();
    } else if (std::ranges::find(stages, choice_.stage) == stages.end()) {
      mistakes_.push_back(
          fmt::format("{}: no results of a stage \"{}\"{}", place_, choice_.stage, suggestion(choice_.stage, stages)));
    }
  }

  void choose_boundary() {
    std::vector<Boundary> boundaries;
    for (const auto& one : series_) {
      if (one.stage == choice_.stage) add_once(boundaries, one.boundary);
    }
    choose(boundaries, choice_.boundary, "boundary condition");
  }

  void choose_load() {
    std::vector<Load> loads;
    for (const auto& one : series_) {
      const bool is_here = one.stage == choice_.stage && (!choice_.boundary || one.boundary == *choice_.boundary);
      if (is_here && one.load != Load::bulk) add_once(loads, one.load);
    }
    if (choice_.shear_load == Load::bulk) {
      mistakes_.push_back("load: expected a load of shear, got bulk; the bulk modulus is taken from its test anyway");
      return;
    }
    if (loads.empty()) {
      if (!mistakes_.empty()) return;  // of the boundary condition
      mistakes_.push_back(fmt::format("{}: stage {} was not tested in shear", place_, choice_.stage));
      return;
    }
    const bool has_plain = std::ranges::find(loads, Load::shear) != loads.end();
    if (!choice_.shear_load && has_plain) choice_.shear_load = Load::shear;
    choose(loads, choice_.shear_load, "shear load");
  }

  template <class Enum>
  void choose(const std::vector<Enum>& known, std::optional<Enum>& chosen, const char* what) {
    const auto names = words_of(known);
    if (chosen && std::ranges::find(known, *chosen) == known.end()) {
      mistakes_.push_back(fmt::format("{}: stage {} was not tested under the {} {}; it has {}", place_, choice_.stage,
                                      what, name_of(*chosen), fmt::join(names, ", ")));
    } else if (!chosen && known.size() == 1) {
      chosen = known.front();
    } else if (!chosen) {
      mistakes_.push_back(fmt::format("{}: stage {} has results of several {}s; choose one: {}", place_, choice_.stage,
                                      what, fmt::join(names, ", ")));
    }
  }

  void refuse() const {
    if (!mistakes_.empty()) throw InputError(fmt::format("{}", fmt::join(mistakes_, "\n")));
  }

  std::string place_;
  const std::vector<StoredSeries>& series_;
  CompositeChoice choice_;
  std::vector<std::string> mistakes_;
};

}  // namespace

std::optional<PronySeries> StoredComposite::bulk() const {
  if (!dilatational || dimensions == 3) return dilatational;
  return PronySeries::difference(*dilatational, shear.scaled(1.0 / 3.0));
}

StoredComposite read_stored_composite(const std::filesystem::path& directory, const CompositeChoice& choice) {
  refuse_other_directories(directory);
  const auto all = read_series_of_tests(directory / "prony.csv");
  const auto resolved = Chooser(directory, all, choice).resolved();
  const auto find = [&](Load load) -> std::optional<PronySeries> {
    const auto found = std::ranges::find_if(all, [&](const StoredSeries& one) {
      return one.stage == resolved.stage && one.boundary == *resolved.boundary && one.load == load;
    });
    if (found == all.end()) return std::nullopt;
    return PronySeries(found->equilibrium, found->terms);
  };
  const auto study = read_study_on_disk(directory / "study.json");
  const auto stage = study.stages.find(resolved.stage);
  if (stage == study.stages.end()) {
    throw FileError(fmt::format("{}: study.json has no stage {}", directory.string(), resolved.stage));
  }
  StoredComposite composite;
  composite.title = study.title;
  composite.stage = resolved.stage;
  composite.boundary = *resolved.boundary;
  composite.shear_load = *resolved.shear_load;
  composite.dimensions = stage->second.dimensions;
  composite.shear = find(*resolved.shear_load).value();
  composite.dilatational = find(Load::bulk);
  composite.times = study.times;
  add_materials(directory, study, composite);
  return composite;
}

}  // namespace breccia
