#include "results/stored_comparisons.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "results/test_columns.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;
using Comparisons = std::map<std::string, std::vector<Comparison>>;

/// The modulus that a row of a table is of.
ModulusKind kind_in_row(const CsvTable& table, std::size_t row) {
  const auto& word = table.text("modulus")[row];
  if (const auto kind = value_named<ModulusKind>(word)) return *kind;
  throw FileError(fmt::format("{}: modulus: expected shear, young or bulk, got \"{}\"", table.location(row), word));
}

/// The comparison to which a row of a table belongs; a new one where there is none.
Comparison& comparison_of(Comparisons& comparisons, const CsvTable& table, std::size_t row) {
  const auto& measurement = table.text("measurement")[row];
  const auto id = id_of_row(table, row);
  auto& all = comparisons[table.text("stage")[row]];
  const auto known = std::ranges::find_if(
      all, [&](const Comparison& one) { return one.measurement == measurement && one.test == id; });
  if (known != all.end()) return *known;
  auto& added = all.emplace_back(Comparison{measurement, id, {}});
  // Tables of earlier versions are of shear moduli.
  if (table.has("modulus")) added.kind = kind_in_row(table, row);
  return added;
}

/// Calls a function with the comparison of each row of a table, if it exists, with its numbers and its error.
template <class Add>
void for_each_row(const fs::path& file, Comparisons& comparisons, const Add& add) {
  if (!fs::exists(file)) return;
  const auto table = read_csv(file, {"measurement", "modulus", "stage", "boundary", "method", "cells", "error"});
  for (std::size_t row = 0; row < table.rows(); ++row) {
    // Tables of earlier versions have no errors.
    const auto error = table.has("error") ? number_if_known(table, "error", row) : std::nullopt;
    add(
        comparison_of(comparisons, table, row), [&](const char* column) { return table.numbers(column)[row]; }, error);
  }
}

}  // namespace

std::map<std::string, std::vector<Comparison>> read_comparisons(const fs::path& directory) {
  Comparisons comparisons;
  for_each_row(directory / "comparison.csv", comparisons,
               [](Comparison& comparison, const auto& number, const auto& error) {
                 comparison.samples.push_back({number("time_s"), number("modulus_Pa"), number("measured_Pa"), error});
               });
  for_each_row(directory / "comparison_dynamic.csv", comparisons,
               [](Comparison& comparison, const auto& number, const auto& error) {
                 comparison.in_frequency.push_back({number("angular_frequency_rad_per_s"), number("storage_modulus_Pa"),
                                                    number("loss_modulus_Pa"), number("measured_storage_modulus_Pa"),
                                                    number("measured_loss_modulus_Pa"), error});
               });
  return comparisons;
}

}  // namespace breccia
