#include "results/dynamic_curves.hpp"

#include <vector>

#include "homogenisation/complex_moduli.hpp"
#include "results/best_tests.hpp"
#include "results/test_columns.hpp"
#include "tables/csv.hpp"

namespace breccia {

void write_dynamic_curves(const std::filesystem::path& file, const StudyResult& result, const FrequencyRows& rows) {
  TestColumns tests;
  std::vector<double> frequencies, storage, loss, loss_tangents;
  for (const auto& stage : result.stages) {
    for (const auto* test : best_tests(stage)) {
      for (const auto& sample : complex_moduli(*test, rows.of(test->modulus))) {
        tests.add(stage.name, test->id);
        frequencies.push_back(sample.angular_frequency);
        storage.push_back(sample.storage);
        loss.push_back(sample.loss);
        loss_tangents.push_back(sample.loss / sample.storage);
      }
    }
  }
  if (frequencies.empty()) return;
  std::vector<CsvColumn> table;
  tests.append_to(table);
  table.insert(table.end(), {{"angular_frequency_rad_per_s", frequencies},
                             {"storage_modulus_Pa", storage},
                             {"loss_modulus_Pa", loss},
                             {"loss_tangent", loss_tangents}});
  write_csv(file, table);
}

}  // namespace breccia
