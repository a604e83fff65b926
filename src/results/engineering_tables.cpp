#include "results/engineering_tables.hpp"

#include <algorithm>
#include <complex>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "results/engineering_curves.hpp"
#include "results/test_columns.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

/// A table whose columns are filled by name.
class EngineeringTable {
 public:
  void begin_row(const std::string& stage, const TestId& test) { tests_.add(stage, test); }
  void add(const std::string& column, double value) { add_to(numbers_, column, value); }
  /// Adds a number that may not be known.
  void add(const std::string& column, const std::optional<double>& value) {
    add_to(texts_, column, text_if_known(value));
  }
  void write(const std::filesystem::path& file) const {
    if (numbers_.empty()) return;
    std::vector<CsvColumn> table = {
        {"stage", tests_.stages}, {"boundary", tests_.boundaries}, {"method", tests_.methods}, {"cells", tests_.cells}};
    for (const auto& [name, values] : numbers_) table.push_back({name, values});
    for (const auto& [name, values] : texts_) table.push_back({name, values});
    write_csv(file, table);
  }

 private:
  template <class Value>
  using Columns = std::vector<std::pair<std::string, std::vector<Value>>>;

  template <class Value>
  static void add_to(Columns<Value>& columns, const std::string& name, Value value) {
    auto known = std::ranges::find(columns, name, &std::pair<std::string, std::vector<Value>>::first);
    if (known == columns.end()) known = columns.insert(known, {name, {}});
    known->second.push_back(std::move(value));
  }

  TestColumns tests_;
  Columns<double> numbers_;
  Columns<std::string> texts_;
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
      for (const auto& [time, shear, bulk, young, poisson, tensile_compliance, errors] : curves.in_time) {
        in_time.begin_row(stage.name, curves.test);
        in_time.add("time_s", time);
        in_time.add("shear_modulus_Pa", shear);
        in_time.add("bulk_modulus_Pa", bulk);
        in_time.add("youngs_modulus_Pa", young);
        in_time.add("poisson_ratio", poisson);
        in_time.add("tensile_compliance_1_per_Pa", tensile_compliance);
        in_time.add("bulk_modulus_error", errors.bulk);
        in_time.add("youngs_modulus_error", errors.young);
        in_time.add("poisson_ratio_error", errors.poisson);
      }
      for (const auto& [frequency, shear, bulk, young, poisson, errors] : curves.in_frequency) {
        in_frequency.begin_row(stage.name, curves.test);
        in_frequency.add("angular_frequency_rad_per_s", frequency);
        in_frequency.add("frequency_Hz", frequency / (2.0 * std::numbers::pi));
        add_complex(in_frequency, "shear", shear);
        add_complex(in_frequency, "bulk", bulk);
        add_complex(in_frequency, "youngs", young);
        in_frequency.add("youngs_loss_tangent", young.imag() / young.real());
        in_frequency.add("youngs_absolute_modulus_Pa", std::abs(young));
        in_frequency.add("youngs_phase_angle_deg", std::arg(young) * 180.0 / std::numbers::pi);
        in_frequency.add("poisson_ratio_real", poisson.real());
        in_frequency.add("poisson_ratio_imaginary", poisson.imag());
        in_frequency.add("youngs_modulus_error", errors.young);
      }
    }
  }
  in_time.write(directory / "engineering.csv");
  in_frequency.write(directory / "engineering_dynamic.csv");
}

}  // namespace breccia
