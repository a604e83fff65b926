#include "deck/prony_file.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "breccia/tables/measured_table_reader.hpp"

#include "io/file_mistakes.hpp"
#include "tables/csv.hpp"

namespace breccia {

PronyFile read_prony_file(const std::filesystem::path& path, ModulusKind kind) {
  const auto table = read_measured_table(path);
  table.require({Quantity::relaxation_time, Quantity::modulus});
  table.refuse_several_series();
  const auto& times = table.column(Quantity::relaxation_time);
  const auto& moduli = table.column(Quantity::modulus, kind);
  PronyFile file;
  FileMistakes mistakes(path);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double time = times.values[row], modulus = moduli.values[row];
    if (!(time > 0.0)) {
      mistakes.add(table.location(row), "expected a positive relaxation time", fmt::format("{}", times.written[row]));
    } else if (!(modulus >= 0.0) || !std::isfinite(modulus)) {
      mistakes.add(table.location(row), "expected a non-negative modulus", fmt::format("{}", moduli.written[row]));
    } else if (std::isfinite(time)) {
      file.terms.push_back({time, modulus});
    } else if (!file.equilibrium) {
      file.equilibrium = modulus;
    } else {
      mistakes.add(table.location(row), "a second term with an infinite relaxation time");
    }
  }
  mistakes.refuse();
  return file;
}

void write_prony_file(const std::filesystem::path& path, const PronySeries& series, ModulusKind kind,
                      std::string_view comment) {
  std::vector<double> times = {std::numeric_limits<double>::infinity()};
  std::vector<double> moduli = {series.equilibrium()};
  for (const auto& [relaxation_time, modulus] : series.terms()) {
    times.push_back(relaxation_time);
    moduli.push_back(modulus);
  }
  write_csv(path, {{"relaxation_time_s", times}, {fmt::format("{}modulus_Pa", column_prefix(kind)), moduli}}, comment);
}

}  // namespace breccia
