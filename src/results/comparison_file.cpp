#include "results/comparison_file.hpp"

#include <string>
#include <vector>

#include "tables/csv.hpp"

namespace breccia {

void write_comparisons(const std::filesystem::path& directory, const StudyResult& result) {
  std::vector<std::string> stages, boundaries, methods, cells, measurements;
  std::vector<double> times, moduli, measured, ratios;
  for (const auto& stage : result.stages) {
    for (const auto& comparison : stage.comparisons) {
      for (const auto& sample : comparison.samples) {
        stages.push_back(stage.name);
        boundaries.push_back(name_of(comparison.test.boundary));
        methods.push_back(name_of(comparison.test.method));
        cells.push_back(name_of(comparison.test.grid));
        measurements.push_back(comparison.measurement);
        times.push_back(sample.time);
        moduli.push_back(sample.modulus);
        measured.push_back(sample.measured);
        ratios.push_back(sample.ratio());
      }
    }
  }
  if (times.empty()) return;
  write_csv(directory / "comparison.csv", {{"measurement", measurements},
                                           {"stage", stages},
                                           {"boundary", boundaries},
                                           {"method", methods},
                                           {"cells", cells},
                                           {"time_s", times},
                                           {"modulus_Pa", moduli},
                                           {"measured_Pa", measured},
                                           {"ratio", ratios}});
}

}  // namespace breccia
