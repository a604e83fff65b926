#include "deck/size_rows.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "io/range.hpp"
#include "io/units.hpp"

namespace breccia {
namespace {

constexpr auto expected_share =
    "expected the volume fraction up to each diameter, from 0 to 1, or in per cent in a column called passing [%]";

/// The numbers of the rows with a size and a share, by rising size; the other rows are reported, but for the pan below
/// the sieves, of size 0, which nothing passes.
std::vector<std::size_t> rows_by_size(const SizeRows& rows, const RowReporter& report_size,
                                      const RowReporter& report_passing) {
  constexpr Range shares = {.lower = 0.0, .upper = 1.0};
  std::vector<std::size_t> rising;
  rising.reserve(rows.sizes.size());
  for (std::size_t row = 0; row < rows.sizes.size(); ++row) {
    const bool is_pan = rows.sizes[row] == 0.0 && rows.passing[row] == 0.0;
    if (is_pan) continue;
    const bool has_size = accepts(Range::positive(), rows.sizes[row]);
    const bool has_share = accepts(shares, rows.passing[row]);
    if (!has_size) report_size(row, "expected a positive diameter");
    if (!has_share) report_passing(row, expected_share);
    if (has_size && has_share) rising.push_back(row);
  }
  std::ranges::stable_sort(rising, {}, [&rows](std::size_t row) { return rows.sizes[row]; });
  return rising;
}

/// The table without sieves that nothing passes but the coarsest of them, and without those that all pass but the
/// finest of them: its ends are those of the sizes.
TabulatedSizes without_empty_ends(TabulatedSizes table) {
  auto& diameters = table.diameters;
  auto& shares = table.cumulative_volume_fractions;
  const auto all = std::ranges::find_if(shares, [](double share) { return share >= 1.0; });
  if (all != shares.end()) shares.erase(all + 1, shares.end());
  diameters.resize(shares.size());
  const auto some = std::ranges::find_if(shares, [](double share) { return share > 0.0; });
  if (some == shares.begin() || some == shares.end()) return table;
  diameters.erase(diameters.begin(), diameters.begin() + (some - shares.begin()) - 1);
  shares.erase(shares.begin(), some - 1);
  return table;
}

std::string in_percent(double share) {
  return fmt::format("{:.4g} %", 100.0 * share);
}

}  // namespace

TabulatedSizes table_of(const SizeRows& rows, const RowReporter& report_size, const RowReporter& report_passing) {
  TabulatedSizes table;
  auto& diameters = table.diameters;
  auto& shares = table.cumulative_volume_fractions;
  diameters.reserve(rows.sizes.size());
  shares.reserve(rows.sizes.size());
  for (const auto row : rows_by_size(rows, report_size, report_passing)) {
    const double diameter = rows.sizes[row], share = rows.passing[row];
    if (!diameters.empty() && diameter == diameters.back()) {
      report_size(row, "expected a diameter that no other row has");
    } else if (!shares.empty() && share < shares.back()) {
      report_passing(row, "expected a volume fraction that is not below that up to a smaller diameter");
    } else {
      diameters.push_back(diameter);
      shares.push_back(share);
    }
  }
  return without_empty_ends(std::move(table));
}

TabulatedSizes with_known_ends(TabulatedSizes table, std::optional<double> from, std::optional<double> to) {
  const auto& diameters = table.diameters;
  auto& shares = table.cumulative_volume_fractions;
  const double first = shares.front(), last = shares.back();
  const auto place = table.file.empty() ? "" : table.file.string() + ": ";
  std::vector<std::string> mistakes;
  if (first > 0.0 && !(from && *from >= diameters.front())) {
    const auto smallest = readable(diameters.front(), Dimension::length);
    mistakes.push_back(
        fmt::format("{}{} of the volume pass {}, the smallest size, and have no sizes: expected a row with 0 %, the "
                    "size that nothing passes, or from = \"{}\", which leaves them out",
                    place, in_percent(first), smallest, smallest));
  }
  if (last < 1.0 && !(to && *to <= diameters.back())) {
    const auto largest = readable(diameters.back(), Dimension::length);
    mistakes.push_back(
        fmt::format("{}{} of the volume do not pass {}, the largest size, and have no sizes: expected a row with "
                    "100 %, or to = \"{}\", which leaves them out",
                    place, in_percent(1.0 - last), largest, largest));
  }
  if (mistakes.empty() && !(last > first)) mistakes.push_back(place + "expected shares that rise with the size");
  if (!mistakes.empty()) throw InputError(fmt::format("{}", fmt::join(mistakes, "\n")));
  if (first == 0.0 && last == 1.0) return table;
  for (auto& share : shares) share = (share - first) / (last - first);
  return table;
}

}  // namespace breccia
