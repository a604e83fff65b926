#include "results/comparison_file.hpp"

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include "results/test_columns.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

/// The columns of a table that say what is compared with which measurement.
class ComparisonColumns {
 public:
  void add(const std::string& stage, const Comparison& comparison) {
    measurements_.push_back(comparison.measurement);
    moduli_.push_back(name_of(comparison.kind));
    stages_.push_back(stage);
    boundaries_.push_back(name_of(comparison.test.boundary));
    methods_.push_back(name_of(comparison.test.method));
    cells_.push_back(name_of(comparison.test.grid));
  }
  [[nodiscard]] std::vector<CsvColumn> columns() const {
    return {{"measurement", measurements_}, {"modulus", moduli_}, {"stage", stages_},
            {"boundary", boundaries_},      {"method", methods_}, {"cells", cells_}};
  }

 private:
  std::vector<std::string> measurements_, moduli_, stages_, boundaries_, methods_, cells_;
};

void write_in_time(const std::filesystem::path& file, const StudyResult& result) {
  ComparisonColumns compared;
  std::vector<double> times, moduli, measured, ratios;
  std::vector<std::string> errors;
  for (const auto& stage : result.stages) {
    for (const auto& comparison : stage.comparisons) {
      for (const auto& sample : comparison.samples) {
        compared.add(stage.name, comparison);
        times.push_back(sample.time);
        moduli.push_back(sample.modulus);
        measured.push_back(sample.measured);
        ratios.push_back(sample.ratio());
        errors.push_back(text_if_known(sample.error));
      }
    }
  }
  if (times.empty()) return;
  auto table = compared.columns();
  table.insert(
      table.end(),
      {{"time_s", times}, {"modulus_Pa", moduli}, {"measured_Pa", measured}, {"ratio", ratios}, {"error", errors}});
  write_csv(file, table);
}

void write_in_frequency(const std::filesystem::path& file, const StudyResult& result) {
  constexpr double per_cycle = 2.0 * std::numbers::pi, degrees = 180.0 / std::numbers::pi;
  ComparisonColumns compared;
  std::vector<double> hertz, omegas, storage, loss, measured_storage, measured_loss, ratios, storage_ratios,
      loss_ratios, phases;
  std::vector<std::string> errors;
  for (const auto& stage : result.stages) {
    for (const auto& comparison : stage.comparisons) {
      for (const auto& sample : comparison.in_frequency) {
        compared.add(stage.name, comparison);
        hertz.push_back(sample.angular_frequency / per_cycle);
        omegas.push_back(sample.angular_frequency);
        storage.push_back(sample.storage);
        loss.push_back(sample.loss);
        measured_storage.push_back(sample.measured_storage);
        measured_loss.push_back(sample.measured_loss);
        ratios.push_back(sample.ratio());
        storage_ratios.push_back(sample.storage / sample.measured_storage);
        loss_ratios.push_back(sample.loss / sample.measured_loss);
        phases.push_back(degrees * sample.phase_difference());
        errors.push_back(text_if_known(sample.error));
      }
    }
  }
  if (omegas.empty()) return;
  auto table = compared.columns();
  table.insert(table.end(), {{"frequency_Hz", hertz},
                             {"angular_frequency_rad_per_s", omegas},
                             {"storage_modulus_Pa", storage},
                             {"loss_modulus_Pa", loss},
                             {"measured_storage_modulus_Pa", measured_storage},
                             {"measured_loss_modulus_Pa", measured_loss},
                             {"ratio", ratios},
                             {"storage_ratio", storage_ratios},
                             {"loss_ratio", loss_ratios},
                             {"phase_difference_deg", phases},
                             {"error", errors}});
  write_csv(file, table);
}

}  // namespace

void write_comparisons(const std::filesystem::path& directory, const StudyResult& result) {
  write_in_time(directory / "comparison.csv", result);
  write_in_frequency(directory / "comparison_dynamic.csv", result);
}

}  // namespace breccia
