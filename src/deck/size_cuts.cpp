#include "deck/size_cuts.hpp"

#include <optional>
#include <string>

#include <fmt/format.h>

#include "deck/size_rows.hpp"
#include "study/filler_sizes.hpp"

namespace breccia {
namespace {

std::optional<double> read_cut(const Section& section, const std::string& key) {
  return section.optional_quantity(key, Dimension::length, Range::positive());
}

/// Reads `from` or `to`, which is an end of the distribution itself where the key is missing.
double read_cut_or_end(const Section& section, const std::string& key, std::optional<double> own) {
  return own && !section.has(key) ? *own : section.quantity(key, Dimension::length, Range::positive());
}

/// Whether the cuts leave out all sizes of a table, which is reported.
bool misses_table(const Section& section, const Filler& filler, const TabulatedSizes& table) {
  const double first = table.diameters.front(), last = table.diameters.back();
  if (!(*filler.smallest >= last || *filler.largest <= first)) return false;
  section.report(
      "sizes", fmt::format("the table has no sizes from {} to {}: it covers {} to {}",
                           readable(*filler.smallest, Dimension::length), readable(*filler.largest, Dimension::length),
                           readable(first, Dimension::length), readable(last, Dimension::length)));
  return true;
}

}  // namespace

void read_cuts(const Section& section, Filler& filler) {
  if (!filler.sizes) {
    // The missing sizes have been reported already.
    for (const auto* key : {"from", "to"}) static_cast<void>(read_cut(section, key));
    return;
  }
  const auto ends = ends_of(*filler.sizes);
  if (!ends) {
    section.refuse({"from", "to"}, "only a distribution of sizes (a table or a law) is cut");
    return;
  }
  const double smallest = read_cut_or_end(section, "from", ends->smallest),
               largest = read_cut_or_end(section, "to", ends->largest);
  filler.smallest = smallest;
  filler.largest = largest;
  auto* const table = std::get_if<TabulatedSizes>(&*filler.sizes);
  const bool is_missed = table != nullptr && misses_table(section, filler, *table);
  if (smallest >= largest) {
    section.report("from", fmt::format("expected less than {} (to), got {}", readable(largest, Dimension::length),
                                       readable(smallest, Dimension::length)));
  } else if (smallest < largest && !is_missed) {  // this is true only of numbers
    section.report_errors_of("sizes", [&] {
      if (table != nullptr) *table = with_known_ends(*table, read_cut(section, "from"), read_cut(section, "to"));
      static_cast<void>(distribution_of(filler));
    });
  }
}

}  // namespace breccia
