#include "breccia/study/prony_file.hpp"

#include <cmath>
#include <limits>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/io/csv.hpp"

namespace breccia {
namespace {

std::string modulus_column(const CsvTable& table) {
  std::vector<std::string> found;
  for (const auto& name : table.names()) {
    if (name.ends_with("modulus_Pa")) found.push_back(name);
  }
  if (found.size() == 1) return found.front();
  throw InputError(fmt::format("{}: expected one column whose name ends in modulus_Pa; it has \"{}\"",
                               table.path().string(), fmt::join(table.names(), "\", \"")));
}

}  // namespace

PronyFile read_prony_file(const std::filesystem::path& path) {
  const auto table = read_csv(path);
  const auto& times = table.numbers("relaxation_time_s");
  const auto& moduli = table.numbers(modulus_column(table));
  PronyFile file;
  std::vector<std::string> mistakes;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (!(times[row] > 0.0)) {
      mistakes.push_back(fmt::format("{}: expected a positive relaxation time, got {}", table.place(row), times[row]));
    } else if (!(moduli[row] >= 0.0) || !std::isfinite(moduli[row])) {
      mistakes.push_back(fmt::format("{}: expected a non-negative modulus, got {}", table.place(row), moduli[row]));
    } else if (std::isfinite(times[row])) {
      file.terms.push_back({times[row], moduli[row]});
    } else if (!file.equilibrium) {
      file.equilibrium = moduli[row];
    } else {
      mistakes.push_back(fmt::format("{}: a second term with an infinite relaxation time", table.place(row)));
    }
  }
  if (!mistakes.empty()) throw InputError(fmt::format("{}", fmt::join(mistakes, "\n")));
  return file;
}

void write_prony_file(const std::filesystem::path& path, const PronySeries& series, std::string_view comment) {
  std::vector<double> times = {std::numeric_limits<double>::infinity()};
  std::vector<double> moduli = {series.equilibrium()};
  for (const auto& [relaxation_time, modulus] : series.terms()) {
    times.push_back(relaxation_time);
    moduli.push_back(modulus);
  }
  write_csv(path, {{"relaxation_time_s", times}, {"modulus_Pa", moduli}}, comment);
}

}  // namespace breccia
