#include "engineering_curves.hpp"

#include <algorithm>
#include <complex>
#include <string>
#include <utility>
#include <vector>

#include "breccia/io/csv.hpp"
#include "breccia/viscoelasticity/engineering_moduli.hpp"

#include "best_tests.hpp"
#include "test_columns.hpp"

namespace breccia {
namespace {

/// The tests in shear and in bulk of a stage under one boundary condition.
struct TestPair {
  const TestResult* shear;
  const TestResult* bulk;

  [[nodiscard]] PronySeries bulk_modulus(int dimensions) const {
    if (dimensions == 3) return bulk->series;
    return PronySeries::difference(bulk->series, shear->series.scaled(1.0 / 3.0));
  }
};

/// Of each boundary condition the pair with the load `shear`, or else with the first load of shear.
std::vector<TestPair> pairs_of(const StageResult& stage) {
  const auto best = best_tests(stage);
  std::vector<TestPair> pairs;
  for (const auto* bulk : best) {
    if (bulk->id.load != Load::bulk || !(bulk->series.unrelaxed() > 0.0)) continue;
    const auto is_shear = [bulk](const TestResult* test) {
      return test->id.load != Load::bulk && test->id.boundary == bulk->id.boundary &&
             test->id.method == bulk->id.method && test->id.grid == bulk->id.grid && test->series.unrelaxed() > 0.0;
    };
    auto shear = std::ranges::find_if(
        best, [&](const TestResult* test) { return is_shear(test) && test->id.load == Load::shear; });
    if (shear == best.end()) shear = std::ranges::find_if(best, is_shear);
    if (shear != best.end()) pairs.push_back({*shear, bulk});
  }
  return pairs;
}

/// A table whose columns of numbers are filled by name.
class EngineeringTable {
 public:
  void begin_row(const std::string& stage, const TestId& test) { tests_.add(stage, test); }
  void add(const std::string& column, double value) {
    const auto known = std::ranges::find(columns_, column, &std::pair<std::string, std::vector<double>>::first);
    if (known == columns_.end()) {
      columns_.emplace_back(column, std::vector<double>{value});
    } else {
      known->second.push_back(value);
    }
  }
  void write(const std::filesystem::path& file) const {
    if (columns_.empty()) return;
    std::vector<CsvColumn> table = {
        {"stage", tests_.stages}, {"boundary", tests_.boundaries}, {"method", tests_.methods}, {"cells", tests_.cells}};
    for (const auto& [name, values] : columns_) table.push_back({name, values});
    write_csv(file, table);
  }

 private:
  TestColumns tests_;
  std::vector<std::pair<std::string, std::vector<double>>> columns_;
};

void add_complex(EngineeringTable& table, const std::string& kind, std::complex<double> modulus) {
  table.add(kind + "_storage_modulus_Pa", modulus.real());
  table.add(kind + "_loss_modulus_Pa", modulus.imag());
}

}  // namespace

void write_engineering_curves(const std::filesystem::path& directory, const StudyResult& result,
                              const FrequencyRows& rows) {
  EngineeringTable in_time, in_frequency;
  for (const auto& stage : result.stages) {
    for (const auto& pair : pairs_of(stage)) {
      const auto bulk = pair.bulk_modulus(stage.dimensions);
      const auto& shear = pair.shear->series;
      const EngineeringModuli moduli(shear, bulk);
      for (const auto& sample : pair.shear->modulus) {
        in_time.begin_row(stage.name, pair.shear->id);
        in_time.add("time_s", sample.time);
        in_time.add("shear_modulus_Pa", shear.at(sample.time));
        in_time.add("bulk_modulus_Pa", bulk.at(sample.time));
        in_time.add("youngs_modulus_Pa", moduli.youngs_modulus(sample.time));
        in_time.add("poisson_ratio", moduli.poisson_ratio(sample.time));
      }
      for (const double frequency : rows.of(pair.shear->modulus)) {
        const auto young = moduli.complex_youngs_modulus(frequency);
        const auto poisson = moduli.complex_poisson_ratio(frequency);
        in_frequency.begin_row(stage.name, pair.shear->id);
        in_frequency.add("angular_frequency_rad_per_s", frequency);
        add_complex(in_frequency, "shear", shear.complex_modulus(frequency));
        add_complex(in_frequency, "bulk", bulk.complex_modulus(frequency));
        add_complex(in_frequency, "youngs", young);
        in_frequency.add("youngs_loss_tangent", young.imag() / young.real());
        in_frequency.add("poisson_ratio_real", poisson.real());
        in_frequency.add("poisson_ratio_imaginary", poisson.imag());
      }
    }
  }
  in_time.write(directory / "engineering.csv");
  in_frequency.write(directory / "engineering_dynamic.csv");
}

}  // namespace breccia
