#include "results/engineering_tables.hpp"

#include <algorithm>
#include <complex>
#include <string>
#include <utility>
#include <vector>

#include "results/engineering_curves.hpp"
#include "results/test_columns.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

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

void write_engineering_tables(const std::filesystem::path& directory, const StudyResult& result,
                              const FrequencyRows& rows) {
  EngineeringTable in_time, in_frequency;
  for (const auto& stage : result.stages) {
    for (const auto& curves : engineering_curves(stage, rows)) {
      for (const auto& [time, shear, bulk, young, poisson, tensile_compliance] : curves.in_time) {
        in_time.begin_row(stage.name, curves.test);
        in_time.add("time_s", time);
        in_time.add("shear_modulus_Pa", shear);
        in_time.add("bulk_modulus_Pa", bulk);
        in_time.add("youngs_modulus_Pa", young);
        in_time.add("poisson_ratio", poisson);
        in_time.add("tensile_compliance_1_per_Pa", tensile_compliance);
      }
      for (const auto& [frequency, shear, bulk, young, poisson] : curves.in_frequency) {
        in_frequency.begin_row(stage.name, curves.test);
        in_frequency.add("angular_frequency_rad_per_s", frequency);
        add_complex(in_frequency, "shear", shear);
        add_complex(in_frequency, "bulk", bulk);
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
