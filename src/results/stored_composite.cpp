#include "results/stored_composite.hpp"

#include <cmath>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "results/error_file.hpp"
#include "results/stored_document.hpp"
#include "tables/csv.hpp"

namespace breccia {

namespace fs = std::filesystem;

namespace {

/// Adds the largest errors of the moduli; none where the results have no such file.
void add_errors(const fs::path& file, std::vector<StageSeries>& all) {
  if (!fs::exists(file)) return;
  const auto table = read_error_table(file);
  for (auto& one : all) {
    std::map<std::string, std::vector<ModulusError>> errors;  // by methods
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const bool is_of_it = table.text("stage")[row] == one.stage && table.text("load")[row] == name_of(one.load) &&
                            table.text("boundary")[row] == name_of(one.boundary);
      if (is_of_it) errors[table.text("method")[row]].push_back(error_in(table, row));
    }
    // Where both methods ran, the series is that of the quasi-static one.
    const auto found = errors.size() > 1 ? errors.find(name_of(Method::quasistatic)) : errors.begin();
    if (found != errors.end()) one.error = largest_whole(found->second);
  }
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
    const auto load = value_named<TestLoad>(table.text("load")[row]);
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
  add_errors(directory / "errors.csv", all);
  return all;
}

StudyContent read_stored_content(const fs::path& directory) {
  return content_of(read_study_document(directory));
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
