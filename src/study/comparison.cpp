#include "comparison.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "breccia/io/csv.hpp"

#include "stage_materials.hpp"

namespace breccia {
namespace {

double distance_from_one(const ComparedSample& sample) {
  return std::abs(std::log(sample.ratio()));
}

}  // namespace

const ComparedSample& Comparison::best() const {
  return *std::ranges::min_element(samples, {}, distance_from_one);
}

const ComparedSample& Comparison::worst() const {
  return *std::ranges::max_element(samples, {}, distance_from_one);
}

std::vector<Comparison> compare(const Study& study, const Stage& stage, const std::vector<TestResult>& tests) {
  std::vector<Comparison> comparisons;
  for (const auto& measurement : study.measurements) {
    if (measurement.stage != stage.name) continue;
    for (const auto bound : study.tests.bounds) {
      for (const auto method : study.tests.methods) {
        const auto& test = representative(tests, Load::shear, boundary_of(bound), method);
        const auto known = measurement.known_within({test.modulus.front().time, test.modulus.back().time});
        if (!known) continue;
        Comparison comparison{measurement.label, test.boundary, method, test.cells, {}};
        for (const auto& [time, modulus] : test.modulus) {
          if (time < known->begin || time > known->end) continue;
          comparison.samples.push_back({time, modulus, measurement.at(time)});
        }
        if (!comparison.samples.empty()) comparisons.push_back(std::move(comparison));
      }
    }
  }
  return comparisons;
}

void write_comparisons(const std::filesystem::path& directory, const StudyResult& result) {
  std::vector<std::string> stages, boundaries, methods, cells, measurements;
  std::vector<double> times, moduli, measured, ratios;
  for (const auto& stage : result.stages) {
    for (const auto& comparison : stage.comparisons) {
      for (const auto& sample : comparison.samples) {
        stages.push_back(stage.name);
        boundaries.push_back(name_of(comparison.boundary));
        methods.push_back(name_of(comparison.method));
        cells.push_back(name_of_grid(comparison.cells));
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
