#include "results/stiffness_file.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "results/test_columns.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

/// The columns of the constants C_ij with i <= j, row by row, by Voigt's numbers: C11, C12, C16, C22, C26, C66 in the
/// plane.
std::vector<std::string> columns_of_constants(int dimensions) {
  const auto numbers = dimensions == 3 ? std::vector{1, 2, 3, 4, 5, 6} : std::vector{1, 2, 6};
  std::vector<std::string> columns;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    for (std::size_t j = i; j < numbers.size(); ++j) {
      columns.push_back(fmt::format("C{}{}_Pa", numbers[i], numbers[j]));
    }
  }
  return columns;
}

}  // namespace

void write_stiffness(const std::filesystem::path& file, const StudyResult& result) {
  TestColumns tests;
  std::vector<double> times, bulk, shear;
  std::vector<std::string> anisotropy, errors;
  const auto names =
      result.stages.empty() ? std::vector<std::string>() : columns_of_constants(result.stages.front().dimensions);
  std::vector<std::vector<double>> constants(names.size());
  for (const auto& stage : result.stages) {
    for (const auto& stiffness : stage.stiffness) {
      for (const auto& sample : stiffness.samples) {
        const auto part = isotropic_part(sample.constants);
        tests.add(stage.name, stiffness.test);
        times.push_back(sample.time);
        bulk.push_back(part.bulk);
        shear.push_back(part.shear);
        anisotropy.push_back(text_if_known(part.anisotropy));
        errors.push_back(text_if_known(sample.error));
        for (std::size_t i = 0; i < names.size(); ++i) constants[i].push_back(sample.constants.at(i));
      }
    }
  }
  if (times.empty()) return;
  std::vector<CsvColumn> table;
  tests.append_to(table);
  table.push_back({"time_s", times});
  for (std::size_t i = 0; i < names.size(); ++i) table.push_back({names[i], constants[i]});
  table.insert(table.end(),
               {{"bulk_modulus_Pa", bulk}, {"shear_modulus_Pa", shear}, {"anisotropy", anisotropy}, {"error", errors}});
  write_csv(file, table);
}

std::map<std::string, std::vector<StageStiffness>> read_stiffness(const std::filesystem::path& file) {
  std::map<std::string, std::vector<StageStiffness>> stiffness;
  if (!std::filesystem::exists(file)) return stiffness;
  const auto table = read_csv(file, {"stage", "load", "boundary", "method", "cells", "anisotropy", "error"});
  const auto columns = columns_of_constants(table.has("C44_Pa") ? 3 : 2);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    auto& of_stage = stiffness[table.text("stage")[row]];
    const auto id = id_of_row(table, row);
    auto known = std::ranges::find(of_stage, id, &StageStiffness::test);
    if (known == of_stage.end()) known = of_stage.insert(known, StageStiffness{id, {}});
    StiffnessSample sample = {table.numbers("time_s")[row], {}, number_if_known(table, "error", row)};
    for (const auto& column : columns) sample.constants.push_back(table.numbers(column)[row]);
    known->samples.push_back(std::move(sample));
  }
  return stiffness;
}

}  // namespace breccia
