#include "deck/sizes.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/microstructure/draw_diameters.hpp"

#include "deck/known_numbers.hpp"
#include "deck/size_rows.hpp"
#include "deck/size_table.hpp"

namespace breccia {

namespace {

std::optional<Sizes> read_file(const Section& filler) {
  const auto path = filler.file("sizes");
  std::optional<Sizes> sizes;
  if (!path.empty()) filler.report_errors_of("sizes", [&] { sizes = read_size_table(path); });
  return sizes;
}

std::optional<Sizes> read_one_size(const Section& sizes) {
  return SingleSize{sizes.quantity("diameter", Dimension::length, Range::positive())};
}

/// The list of diameters, each repeated by its count.
std::optional<Sizes> read_list(const Section& sizes) {
  const auto diameters = sizes.quantities("list", Dimension::length, Range::positive());
  if (!sizes.has("counts")) return ListedSizes{diameters};
  constexpr auto most = static_cast<std::int64_t>(most_particles);
  const auto counts = sizes.integers("counts", {.lower = 1.0, .upper = static_cast<double>(most)});
  if (counts.size() != diameters.size()) {
    sizes.report("counts", fmt::format("expected as many as in list, {}, got {}", diameters.size(), counts.size()));
    return ListedSizes();
  }
  const auto particles = std::reduce(counts.begin(), counts.end());
  if (particles > most) {
    sizes.report("counts", fmt::format("expected at most {} particles, got {}", most, particles));
    return ListedSizes();
  }
  ListedSizes listed;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    listed.diameters.insert(listed.diameters.end(), static_cast<std::size_t>(counts[i]), diameters[i]);
  }
  return listed;
}

std::optional<Sizes> read_lognormal(const Section& sizes) {
  LognormalSizes lognormal;
  double sum = 0.0;
  for (const auto& component : sizes.sections("lognormal")) {
    lognormal.components.push_back({component.optional_number("weight", Range::above_and_up_to(0.0, 1e6)).value_or(1.0),
                                    component.quantity("median", Dimension::length, Range::positive()),
                                    component.number("sigma", Range::positive())});
    sum += lognormal.components.back().weight;
  }
  for (auto& component : lognormal.components) component.weight /= sum;
  return lognormal;
}

/// A sieve analysis: `passing = [{ size = "2 mm", passing = "40 %" }, ...]`.
std::optional<Sizes> read_passing(const Section& sizes) {
  const auto sections = sizes.sections("passing");
  SizeRows rows;
  rows.sizes.reserve(sections.size());
  rows.passing.reserve(sections.size());
  for (const auto& row : sections) {
    rows.sizes.push_back(row.quantity("size", Dimension::length, Range::positive()));
    rows.passing.push_back(row.fraction("passing", {.lower = 0.0, .upper = 1.0}));
  }
  if (!are_known(rows.sizes) || !are_known(rows.passing)) return std::nullopt;
  bool is_table = true;
  const auto reporter_of = [&](const char* key) {
    return [&sections, &is_table, key](std::size_t row, const std::string& expected) {
      sections[row].report(key, expected);
      is_table = false;
    };
  };
  auto table = table_of(rows, reporter_of("size"), reporter_of("passing"));
  if (is_table && table.diameters.size() < 2) {
    sizes.report("passing", "expected at least two rows");
    is_table = false;
  }
  return is_table ? std::optional<Sizes>(std::move(table)) : std::nullopt;
}

std::optional<Sizes> read_fuller(const Section& sizes) {
  const FullerSizes law = {sizes.quantity("fuller", Dimension::length, Range::positive()),
                           sizes.optional_number("exponent", Range::positive()).value_or(FullerSizes{}.exponent)};
  return are_known({law.largest, law.exponent}) ? std::optional<Sizes>(law) : std::nullopt;
}

std::optional<Sizes> read_rosin_rammler(const Section& sizes) {
  const RosinRammlerSizes law = {sizes.quantity("rosin_rammler", Dimension::length, Range::positive()),
                                 sizes.number("exponent", Range::positive())};
  return are_known({law.size, law.exponent}) ? std::optional<Sizes>(law) : std::nullopt;
}

/// Reads a length that has to be above one that was read before.
double read_above(const Section& sizes, const std::string& key, const std::string& lower_key, double lower) {
  const double value = sizes.quantity(key, Dimension::length, Range::positive());
  if (value <= lower) {
    sizes.report(key, fmt::format("expected more than {} ({}), got {}", readable(lower, Dimension::length), lower_key,
                                  readable(value, Dimension::length)));
  }
  return value;
}

std::optional<Sizes> read_quantiles(const Section& sizes) {
  const double d10 = sizes.quantity("d10", Dimension::length, Range::positive());
  const double d50 = read_above(sizes, "d50", "d10", d10);
  const double d90 = read_above(sizes, "d90", "d50", d50);
  return d10 < d50 && d50 < d90 ? std::optional<Sizes>(QuantileSizes{d10, d50, d90}) : std::nullopt;
}

/// Equal volumes in equal intervals of the logarithm of the diameter: a table of its two ends.
std::optional<Sizes> read_even_sizes(const Section& sizes) {
  const double from = sizes.quantity("from", Dimension::length, Range::positive());
  const double to = read_above(sizes, "to", "from", from);
  return from < to ? std::optional<Sizes>(TabulatedSizes{{}, {from, to}, {0.0, 1.0}}) : std::nullopt;
}

/// A table of sizes, by the key that it must have, and its reader, which returns nothing after a mistake was reported.
struct Notation {
  const char* key;
  std::optional<Sizes> (*read)(const Section& sizes);
};

constexpr std::array notations = {Notation{"diameter", read_one_size},
                                  Notation{"list", read_list},
                                  Notation{"passing", read_passing},
                                  Notation{"d50", read_quantiles},
                                  Notation{"lognormal", read_lognormal},
                                  Notation{"fuller", read_fuller},
                                  Notation{"rosin_rammler", read_rosin_rammler},
                                  Notation{"from", read_even_sizes}};

}  // namespace

std::optional<Sizes> read_sizes(const Section& filler) {
  if (filler.kind("sizes") == Kind::text) return read_file(filler);
  std::vector<std::string> keys;
  keys.reserve(notations.size());
  for (const auto& notation : notations) keys.emplace_back(notation.key);
  if (filler.kind("sizes") != Kind::table) {
    filler.report("sizes", fmt::format("{}expected a file, or a table with one of {}",
                                       filler.has("sizes") ? "" : "missing, ", fmt::join(keys, ", ")));
    return std::nullopt;
  }
  const auto sizes = filler.section("sizes");
  const auto key = sizes.exactly_one(keys);
  const auto* const notation = std::ranges::find(notations, key, &Notation::key);
  return notation == notations.end() ? std::nullopt : notation->read(sizes);
}

}  // namespace breccia
