#include "breccia/results/curves.hpp"

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "homogenisation/quality.hpp"
#include "results/best_tests.hpp"
#include "results/dynamic_curves.hpp"
#include "results/engineering_tables.hpp"
#include "results/error_file.hpp"
#include "results/test_columns.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

/// Writes a table of the samples of all tests, one row per time; no file if there are no rows.
template <class Samples, class Value>
void write_samples(const std::filesystem::path& file, const StudyResult& result, const Samples& samples_of,
                   const std::string& column, const Value& value_of) {
  TestColumns tests;
  std::vector<double> times, values;
  for (const auto& stage : result.stages) {
    for (const auto& test : stage.tests) {
      for (const auto& sample : samples_of(test)) {
        tests.add(stage.name, test.id);
        times.push_back(sample.time);
        values.push_back(value_of(sample));
      }
    }
  }
  if (times.empty()) return;
  std::vector<CsvColumn> table;
  tests.append_to(table);
  table.insert(table.end(), {{"time_s", times}, {column, values}});
  write_csv(file, table);
}

void write_extrapolations(const std::filesystem::path& file, const StudyResult& result) {
  TestColumns tests;
  std::vector<double> times, moduli, half_bands;
  for (const auto& stage : result.stages) {
    for (const auto& test : stage.tests) {
      if (test.half_bands.empty()) continue;
      for (std::size_t i = 0; i < test.modulus.size(); ++i) {
        tests.add(stage.name, test.id);
        times.push_back(test.modulus[i].time);
        moduli.push_back(test.modulus[i].modulus);
        half_bands.push_back(test.half_bands[i]);
      }
    }
  }
  if (times.empty()) return;
  write_csv(file, {{"stage", tests.stages},
                   {"load", tests.loads},
                   {"boundary", tests.boundaries},
                   {"method", tests.methods},
                   {"time_s", times},
                   {"modulus_Pa", moduli},
                   {"half_band_Pa", half_bands}});
}

void write_series(const std::filesystem::path& file, const StudyResult& result) {
  TestColumns tests;
  std::vector<double> times, moduli;
  for (const auto& stage : result.stages) {
    for (const auto* test : best_tests(stage)) {
      const auto add = [&](double time, double modulus) {
        tests.add(stage.name, test->id);
        times.push_back(time);
        moduli.push_back(modulus);
      };
      add(std::numeric_limits<double>::infinity(), test->series.equilibrium());
      for (const auto& [time, modulus] : test->series.terms()) add(time, modulus);
    }
  }
  write_csv(file, {{"stage", tests.stages},
                   {"load", tests.loads},
                   {"boundary", tests.boundaries},
                   {"relaxation_time_s", times},
                   {"modulus_Pa", moduli}});
}

void write_quality(const std::filesystem::path& file, const StudyResult& result) {
  std::vector<std::string> stages, loads, methods, upper, lower, distances, half_bands;
  std::vector<double> times;
  for (const auto& stage : result.stages) {
    for (const auto& [load, method, bounds] : bounds_of_tests(stage)) {
      for (const auto& at : bounds) {
        stages.push_back(stage.name);
        loads.push_back(name_of(load));
        methods.push_back(name_of(method));
        times.push_back(at.time);
        upper.push_back(text_if_known(at.upper));
        lower.push_back(text_if_known(at.lower));
        distances.push_back(text_if_known(at.distance()));
        half_bands.push_back(text_if_known(at.grid_half_band));
      }
    }
  }
  if (times.empty()) return;
  write_csv(file, {{"stage", stages},
                   {"load", loads},
                   {"method", methods},
                   {"time_s", times},
                   {"upper_Pa", upper},
                   {"lower_Pa", lower},
                   {"relative_distance", distances},
                   {"grid_half_band_Pa", half_bands}});
}

}  // namespace

void write_curves(const std::filesystem::path& directory, const StudyResult& result, const FrequencyRows& rows) {
  write_samples(
      directory / "curves.csv", result, [](const TestResult& test) { return test.modulus; }, "modulus_Pa",
      [](const Sample& sample) { return sample.modulus; });
  write_samples(
      directory / "compliance.csv", result, [](const TestResult& test) { return test.compliance; },
      "compliance_1_per_Pa", [](const CreepSample& sample) { return sample.compliance; });
  write_extrapolations(directory / "extrapolation.csv", result);
  write_series(directory / "prony.csv", result);
  write_dynamic_curves(directory / "dynamic.csv", result, rows);
  write_engineering_tables(directory, result, rows);
  write_quality(directory / "quality.csv", result);
  write_errors(directory / "errors.csv", result);
}

}  // namespace breccia
