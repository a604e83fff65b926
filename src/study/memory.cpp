#include "breccia/study/memory.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <sys/resource.h>

#include "breccia/error.hpp"
#include "breccia/study/run.hpp"

namespace breccia {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The number after a word at the beginning of a line of a file of the kernel, such as `MemAvailable:`.
std::optional<double> number_after(const char* file, const std::string& word) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with(word)) continue;
    const auto begin = line.find_first_of("0123456789", word.size());
    if (begin == std::string::npos) return std::nullopt;
    double number = 0.0;
    std::from_chars(line.data() + begin, line.data() + line.size(), number);
    return number;
  }
  return std::nullopt;
}

constexpr double kibibyte = 1024.0;

double left_on_machine() {
  const auto available = number_after("/proc/meminfo", "MemAvailable:");
  return available ? kibibyte * *available : unlimited;
}

double left_in_control_group() {
  const auto most = number_after("/sys/fs/cgroup/memory.max", "");
  const auto used = number_after("/sys/fs/cgroup/memory.current", "");
  // What of it is files the kernel gives back.
  const auto files = number_after("/sys/fs/cgroup/memory.stat", "inactive_file");
  return most && used ? *most - *used + files.value_or(0.0) : unlimited;
}

double left_of_address_space() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited;
  // With less than this the libraries for MPI and linear algebra fail, or wait for ever for memory.
  constexpr double of_libraries = 4e8;
  const auto used = number_after("/proc/self/status", "VmSize:");
  return static_cast<double>(limit.rlim_cur) - kibibyte * used.value_or(0.0) - of_libraries;
}

/// Largest of the tests of a stage by the dynamic method, on a grid of so many cells; nothing where the estimate finds
/// no way through the times, about which the run itself knows better.
double dynamic_memory(const Study& study, const Stage& stage, int cells) {
  // Where the particles are does not matter.
  const auto discretisation = discretise({stage.side, Walls::hard, {}}, cells);
  double most = 0.0;
  try {
    for (const auto bound : study.tests.bounds) {
      for (const auto load : loads_of(study, stage)) {
        const auto test =
            make_dynamic_test(study, stage, expected_matrix(study, stage), discretisation, boundary_of(bound), load, 0);
        most = std::max(most, static_cast<double>(plan_dynamic_test(test).bytes));
      }
    }
  } catch (const NumericalError&) {
    // What was found until then is all there is to compare.
  }
  return most;
}

}  // namespace

double quasistatic_memory(const Study& study, const Stage& stage, int cells) {
  const double unknowns = 2.0 * cells * cells;
  double steps = 0.0;
  if (study.tests.quasistatic.solver == Solver::stepping) {
    // A nodal vector for each term, of the fine run and the coarse one.
    const auto matrix = expected_matrix(study, stage);
    const auto terms = matrix.bulk.terms().size() + matrix.shear.terms().size();
    steps = 2.0 * sizeof(double) * static_cast<double>(terms * loads_of(study, stage).size());
  }
  if (study.tests.quasistatic.linear.is_direct(static_cast<std::int64_t>(unknowns), 1)) {
    // Sparse Cholesky factors of a square grid, ordered by nested dissection.
    return unknowns * (640.0 + 60.0 * std::log2(unknowns) + steps);
  }
  // Substructures and a dozen of nodal vectors; fields take as much again.
  const double fields = study.tests.field_times.empty() ? 0.0 : 340.0;
  return unknowns * (340.0 + fields + steps);
}

double available_memory() {
  return std::min({left_on_machine(), left_in_control_group(), left_of_address_space()});
}

void require_memory(const Study& study, double available) {
  std::string mistakes;
  for (const auto& stage : study.stages) {
    const int cells = stage.cells;
    for (const auto method : study.tests.methods) {
      const double bytes =
          method == Method::quasistatic ? quasistatic_memory(study, stage, cells) : dynamic_memory(study, stage, cells);
      if (bytes <= available) continue;
      const double left = std::max(0.0, available);
      const int fitting = static_cast<int>(cells * std::sqrt(left / bytes));
      mistakes += fmt::format(
          "{}{}: {} x {} cells take about {:.3g} GB by the {} method, and {:.3g} GB are left{} "
          "(--no-memory-check runs them nevertheless)",
          mistakes.empty() ? "" : "\n", stage.name, cells, cells, bytes / 1e9,
          method == Method::quasistatic ? "quasi-static" : "dynamic", left / 1e9,
          fitting > 1 ? fmt::format("; cells = {} would fit", fitting) : "");
    }
  }
  if (!mistakes.empty()) throw InputError(mistakes);
}

}  // namespace breccia
