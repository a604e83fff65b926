#include "results/expansion_file.hpp"

#include <algorithm>
#include <utility>

#include "results/test_columns.hpp"
#include "tables/csv.hpp"

namespace breccia {
void write_expansions(const std::filesystem::path& file, const StudyResult& result) {
  TestColumns tests;
  std::vector<double> times, expansions;
  std::vector<std::string> errors;
  for (const auto& stage : result.stages) {
    for (const auto& [test, samples] : stage.expansions) {
      for (const auto& [time, expansion, error] : samples) {
        tests.add(stage.name, test);
        times.push_back(time);
        expansions.push_back(expansion);
        errors.push_back(text_if_known(error));
      }
    }
  }
  if (times.empty()) return;
  std::vector<CsvColumn> table;
  tests.append_to(table);
  table.insert(table.end(), {{"time_s", times}, {"thermal_expansion_1_per_K", expansions}, {"error_1_per_K", errors}});
  write_csv(file, table);
}

std::map<std::string, std::vector<StageExpansion>> read_expansions(const std::filesystem::path& file) {
  std::map<std::string, std::vector<StageExpansion>> expansions;
  if (!std::filesystem::exists(file)) return expansions;
  const auto table = read_csv(file, {"stage", "load", "boundary", "method", "cells", "error_1_per_K"});
  for (std::size_t row = 0; row < table.rows(); ++row) {
    auto& of_stage = expansions[table.text("stage")[row]];
    const auto id = id_of_row(table, row);
    auto known = std::ranges::find(of_stage, id, &StageExpansion::test);
    if (known == of_stage.end()) known = of_stage.insert(known, StageExpansion{id, {}});
    known->samples.push_back({table.numbers("time_s")[row], table.numbers("thermal_expansion_1_per_K")[row],
                              number_if_known(table, "error_1_per_K", row)});
  }
  return expansions;
}

}  // namespace breccia
