#include <cmath>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/io/measured_table.hpp"
#include "breccia/microstructure/validity.hpp"

#include "deck_sections.hpp"

namespace breccia {

namespace {

enum class MethodName { lubachevsky_stillinger, regular, listed };

constexpr double most_rows = 1e4;

std::vector<Disc> read_discs(const std::filesystem::path& path, double side) {
  const auto table = read_measured_table(path);
  table.require({Quantity::x, Quantity::y, Quantity::diameter});
  const auto& x = table.column(Quantity::x).values;
  const auto& y = table.column(Quantity::y).values;
  const auto& diameters = table.column(Quantity::diameter).values;
  std::vector<Disc> discs;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (!(diameters[row] > 0.0) || !std::isfinite(diameters[row])) {
      throw InputError(fmt::format("{}: expected a positive diameter, got {}", table.place(row), diameters[row]));
    }
    const bool outside = x[row] < 0.0 || x[row] > side || y[row] < 0.0 || y[row] > side;
    if (outside) {
      throw InputError(fmt::format("{}: expected a centre in the box, 0 to {} m, got ({}, {})", table.place(row), side,
                                   x[row], y[row]));
    }
    discs.push_back({{x[row], y[row]}, diameters[row]});
  }
  if (discs.empty()) throw InputError(fmt::format("{}: expected at least one disc", path.string()));
  return discs;
}

/// Throws InputError where discs overlap or cross a wall.
void require_room(const std::filesystem::path& path, const std::vector<Disc>& discs, double side) {
  try {
    require_valid({side, Walls::hard, discs});
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", path.string(), error.what()));
  }
}

LubachevskyStillingerPacking read_random(const Section& packing) {
  const bool has_walls = packing.optional_boolean("walls").value_or(true);
  const auto seed = packing.optional_integer("seed", Range::not_negative()).value_or(1);
  return {has_walls ? Walls::hard : Walls::periodic, static_cast<std::uint64_t>(seed)};
}

RegularPacking read_regular(const Section& packing) {
  const Range range{.lower = 1.0, .upper = most_rows};
  return {static_cast<int>(packing.integer("columns", range)), static_cast<int>(packing.integer("rows", range))};
}

ExplicitPacking read_explicit(const Section& packing, double side) {
  ExplicitPacking listed{packing.file("discs"), {}};
  if (listed.file.empty()) return listed;
  packing.report_errors_of("discs", [&] {
    listed.discs = read_discs(listed.file, side);
    const bool box_is_known = side > 0.0;
    if (box_is_known) require_room(listed.file, listed.discs, side);
  });
  return listed;
}

}  // namespace

std::optional<PackingMethod> read_packing(const Section& stage, double side) {
  const auto packing = stage.section("packing");
  const auto method =
      packing.choice<MethodName>("method", {
                                               {"lubachevsky-stillinger", MethodName::lubachevsky_stillinger},
                                               {"regular", MethodName::regular},
                                               {"explicit", MethodName::listed},
                                           });
  if (!method) {
    packing.accept_all_keys();
    return std::nullopt;
  }
  switch (*method) {
    case MethodName::regular:
      return read_regular(packing);
    case MethodName::listed:
      return read_explicit(packing, side);
    default:
      return read_random(packing);
  }
}

}  // namespace breccia
