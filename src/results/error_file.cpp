#include "results/error_file.hpp"

#include <array>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "results/test_columns.hpp"

namespace breccia {
namespace {

using Cause = std::pair<const char*, std::optional<double> ModulusError::*>;
constexpr std::array<Cause, 4> causes = {{{"grid_error", &ModulusError::grid},
                                          {"sample_error", &ModulusError::sample},
                                          {"solver_error", &ModulusError::solver},
                                          {"matrix_error", &ModulusError::matrix}}};

}  // namespace

void write_errors(const std::filesystem::path& file, const StudyResult& result) {
  TestColumns tests;
  std::vector<double> times, moduli;
  std::vector<std::string> whole;
  std::array<std::vector<std::string>, causes.size()> shares;
  for (const auto& stage : result.stages) {
    for (const auto& test : stage.tests) {
      for (std::size_t i = 0; i < test.errors.size(); ++i) {
        tests.add(stage.name, test.id);
        times.push_back(test.modulus[i].time);
        moduli.push_back(test.modulus[i].modulus);
        whole.push_back(text_if_known(test.errors[i].whole()));
        for (std::size_t k = 0; k < causes.size(); ++k)
          shares[k].push_back(text_if_known(test.errors[i].*causes[k].second));
      }
    }
  }
  if (times.empty()) return;
  std::vector<CsvColumn> table;
  tests.append_to(table);
  table.insert(table.end(), {{"time_s", times}, {"modulus_Pa", moduli}, {"error", whole}});
  for (std::size_t k = 0; k < causes.size(); ++k) table.push_back({causes[k].first, shares[k]});
  write_csv(file, table);
}

CsvTable read_error_table(const std::filesystem::path& file) {
  std::vector<std::string> text = {"stage", "load", "boundary", "method", "cells", "error"};
  for (const auto& [column, cause] : causes) text.emplace_back(column);
  return read_csv(file, text);
}

ModulusError error_in(const CsvTable& table, std::size_t row) {
  ModulusError error;
  for (const auto& [column, cause] : causes) error.*cause = number_if_known(table, column, row);
  return error;
}

}  // namespace breccia
