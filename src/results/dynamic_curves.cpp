#include "results/dynamic_curves.hpp"

#include <vector>

#include "homogenisation/complex_moduli.hpp"
#include "results/best_tests.hpp"
#include "results/complex_columns.hpp"
#include "results/test_columns.hpp"
#include "tables/csv.hpp"

namespace breccia {

void write_dynamic_curves(const std::filesystem::path& file, const StudyResult& result, const FrequencyRows& rows) {
  TestColumns tests;
  ComplexColumns moduli;
  for (const auto& stage : result.stages) {
    for (const auto* test : best_tests(stage)) {
      for (const auto& sample : complex_moduli(*test, rows.of(test->modulus))) {
        tests.add(stage.name, test->id);
        moduli.add(sample);
      }
    }
  }
  if (moduli.empty()) return;
  std::vector<CsvColumn> table;
  tests.append_to(table);
  moduli.append_to(table);
  write_csv(file, table);
}

}  // namespace breccia
