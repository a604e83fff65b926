#include "study/result_names.hpp"

#include <algorithm>
#include <iterator>

#include "io/replacement.hpp"

namespace breccia {

std::vector<std::string> curve_files() {
  return {"curves.csv",        "compliance.csv",          "dynamic.csv", "engineering.csv", "errors.csv",
          "extrapolation.csv", "engineering_dynamic.csv", "prony.csv",   "quality.csv"};
}

std::vector<std::string> comparison_files() {
  return {"comparison.csv", "comparison_dynamic.csv"};
}

std::vector<std::string> files_of_a_study() {
  auto names = curve_files();
  std::ranges::copy(comparison_files(), std::back_inserter(names));
  names.insert(names.end(), {"thermal_expansion.csv", "stiffness.csv", "study.json", "report.html", "checksums.txt"});
  return names;
}

std::vector<std::string> files_of_a_sweep() {
  return {"sweep.csv",  "sweep_dynamic.csv", "spread.csv", "spread_dynamic.csv",
          "sweep.json", "sweep.svg",         "report.html"};
}

std::vector<std::string> reserved_names() {
  auto names = files_of_a_study();
  std::ranges::copy(files_of_a_sweep(), std::back_inserter(names));
  names.emplace_back(unfinished_directory);
  return names;
}

}  // namespace breccia
