#include "packing.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/io/file_mistakes.hpp"
#include "breccia/io/measured_table_reader.hpp"
#include "breccia/microstructure/validity.hpp"
#include "breccia/study/coatings.hpp"
#include "breccia/study/limits.hpp"

namespace breccia {

namespace {

constexpr std::string_view random_method = "lubachevsky-stillinger", grain_method = "laguerre", image_method = "image";

enum class MethodName { lubachevsky_stillinger, regular, listed, laguerre, image };

std::vector<Disc> read_discs(const MeasuredTable& table, double side, FileMistakes& mistakes) {
  table.require({Quantity::x, Quantity::y, Quantity::diameter});
  const auto& x = table.column(Quantity::x);
  const auto& y = table.column(Quantity::y);
  const auto& diameters = table.column(Quantity::diameter);
  // An unknown side is not a number here, and every centre is accepted.
  const auto is_outside = [side](double coordinate) { return coordinate < 0.0 || coordinate > side; };
  std::vector<Disc> discs;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (!(diameters.values[row] > 0.0) || !std::isfinite(diameters.values[row])) {
      mistakes.add(table.place(row), "expected a positive diameter", fmt::format("{}", diameters.written[row]));
    } else if (is_outside(x.values[row]) || is_outside(y.values[row])) {
      mistakes.add(table.place(row),
                   fmt::format("expected a centre in the box, 0 to {}", readable(side, Dimension::length)),
                   fmt::format("({}, {})", x.written[row], y.written[row]));
    }
    discs.push_back({{x.values[row], y.values[row]}, diameters.values[row]});
  }
  if (discs.empty()) mistakes.add("", "expected at least one disc");
  return discs;
}

/// The number of the filler of each row. Reports numbers that are those of no filler, and a missing column.
std::vector<std::size_t> read_filler_numbers(const MeasuredTable& table, std::size_t fillers, FileMistakes& mistakes) {
  if (!table.has({Quantity::filler})) {
    if (fillers > 1) mistakes.add("", "expected a column called filler with the number of the filler of each disc");
    return {};
  }
  const auto& column = table.column(Quantity::filler);
  std::vector<std::size_t> numbers;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double number = column.values[row];
    const bool is_filler = number >= 0.0 && number < static_cast<double>(fillers) && number == std::floor(number);
    if (!is_filler) {
      mistakes.add(table.place(row), fmt::format("expected the number of a filler, 0 to {}", fillers - 1),
                   fmt::format("{}", column.written[row]));
    }
    numbers.push_back(is_filler ? static_cast<std::size_t>(number) : 0);
  }
  return fillers > 1 ? numbers : std::vector<std::size_t>();
}

Walls read_walls(const Section& packing, bool by_default = true) {
  return packing.optional_boolean("walls").value_or(by_default) ? Walls::hard : Walls::periodic;
}

LubachevskyStillingerPacking read_random(const Section& packing) {
  const auto walls = read_walls(packing);
  const auto seed = packing.optional_integer("seed", Range::not_negative()).value_or(1);
  return {walls, static_cast<std::uint64_t>(seed)};
}

RegularPacking read_regular(const Section& packing) {
  return {static_cast<int>(packing.integer("columns", allowed::rows)),
          static_cast<int>(packing.integer("rows", allowed::rows))};
}

bool is_picture(const std::filesystem::path& file) {
  auto extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char letter) { return std::tolower(letter); });
  constexpr std::array<std::string_view, 8> pictures = {".png",  ".jpg", ".jpeg", ".tif",
                                                        ".tiff", ".bmp", ".gif",  ".svg"};
  return std::ranges::find(pictures, extension) != pictures.end();
}

ExplicitPacking read_explicit(const Section& packing, double side, std::size_t fillers) {
  ExplicitPacking listed{packing.file("discs"), {}, read_walls(packing), {}};
  if (listed.file.empty()) return listed;
  if (is_picture(listed.file)) {
    packing.report("discs", fmt::format("expected a CSV file with columns x_m, y_m, diameter_m, got {}; {}",
                                        listed.file.string(), image_elsewhere));
    return listed;
  }
  packing.report_errors_of("discs", [&] {
    const auto table = read_measured_table(listed.file);
    FileMistakes mistakes(listed.file);
    auto discs = read_discs(table, side, mistakes);
    auto numbers = read_filler_numbers(table, fillers, mistakes);
    mistakes.refuse();
    listed.discs = std::move(discs);
    listed.fillers = std::move(numbers);
  });
  return listed;
}

/// The sites of a tessellation. Those in a table without weights all weigh the same.
std::vector<Site<2>> read_sites(const std::filesystem::path& file, double side, Walls walls) {
  const auto table = read_measured_table(file);
  table.require({Quantity::x, Quantity::y});
  table.refuse_unknown_units({Quantity::weight});
  const auto& x = table.column(Quantity::x);
  const auto& y = table.column(Quantity::y);
  const auto* weights = table.has({Quantity::weight}) ? &table.column(Quantity::weight) : nullptr;
  std::vector<Site<2>> sites;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    sites.push_back({{x.values[row], y.values[row]}, weights == nullptr ? 0.0 : weights->values[row]});
  }
  FileMistakes mistakes(file);
  if (sites.empty()) mistakes.add("", "expected at least one site");
  // The side of the box may be unknown because of a mistake elsewhere.
  if (!sites.empty() && side > 0.0) {
    for (const auto& [site, text] : breccia::mistakes<2>({side, walls, sites})) mistakes.add(table.place(site), text);
  }
  mistakes.refuse();
  return sites;
}

LaguerrePacking read_laguerre(const Section& packing, double side) {
  LaguerrePacking grains = {.walls = read_walls(packing, false)};
  // A film that is no length has been reported; the filler still needs no fraction.
  if (packing.has("film")) grains.film = packing.quantity("film", Dimension::length, Range::positive());
  if (packing.has("sites")) {
    packing.refuse({"seed"}, "the grains follow from packing.sites");
    grains.file = packing.file("sites");
    if (grains.file.empty()) {
      grains.file = "missing";  // which has been reported; the filler still needs no sizes
      return grains;
    }
    packing.report_errors_of("sites", [&] { grains.sites = read_sites(grains.file, side, grains.walls); });
  } else {
    grains.seed = static_cast<std::uint64_t>(packing.optional_integer("seed", Range::not_negative()).value_or(1));
  }
  return grains;
}

/// A packing method that does not exist, but that users may expect.
bool asks_for_other_shapes(const Section& packing) {
  if (packing.kind("method") != Kind::text) return false;
  constexpr std::array<std::string_view, 2> methods = {"polygons", "ellipses"};
  return std::ranges::find(methods, packing.optional_text("method").value_or("")) != methods.end();
}

}  // namespace

bool takes_seed(const Section& packing) {
  if (packing.kind("method") != Kind::text) return false;
  const auto method = packing.optional_text("method");
  return method == random_method || (method == grain_method && !packing.has("sites"));
}

void require_room(const Stage& stage, const ExplicitPacking& listed) {
  if (listed.discs.empty()) return;  // a mistake that has been reported
  try {
    require_valid<2>(with_coatings(stage, {stage.side, listed.walls, listed.discs, listed.fillers}));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", listed.file.string(), error.what()));
  }
}

std::optional<PackingMethod> read_packing(const Section& stage, double side, std::size_t fillers) {
  const auto packing = stage.section("packing");
  if (asks_for_other_shapes(packing)) {
    packing.report("method", discs_alone);
    packing.accept_all_keys();
    return std::nullopt;
  }
  packing.refuse({"image"}, image_elsewhere);
  const auto method = packing.choice<MethodName>("method", {
                                                               {random_method, MethodName::lubachevsky_stillinger},
                                                               {"regular", MethodName::regular},
                                                               {"explicit", MethodName::listed},
                                                               {grain_method, MethodName::laguerre},
                                                               {image_method, MethodName::image},
                                                           });
  if (!method) {
    packing.accept_all_keys();
    return std::nullopt;
  }
  switch (*method) {
    case MethodName::regular:
      return read_regular(packing);
    case MethodName::listed:
      return read_explicit(packing, side, fillers);
    case MethodName::laguerre:
      return read_laguerre(packing, side);
    case MethodName::image:
      return std::nullopt;  // read_image() reads it
    default:
      return read_random(packing);
  }
}

}  // namespace breccia
