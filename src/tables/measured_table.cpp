#include "breccia/tables/measured_table.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "io/file_mistakes.hpp"
#include "io/printable.hpp"

namespace breccia {

namespace {

/// Names that a column of a quantity may have, for the message about a missing one.
std::string_view example_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::time:
      return "of times, such as time_s";
    case Quantity::relaxation_time:
      return "of relaxation times, such as relaxation_time_s";
    case Quantity::modulus:
      return "of moduli, such as modulus_Pa";
    case Quantity::compliance:
      return "of compliances, such as compliance_1_per_Pa";
    case Quantity::storage_modulus:
      return "of storage moduli, such as storage_modulus_Pa";
    case Quantity::loss_modulus:
      return "of loss moduli, such as loss_modulus_Pa";
    case Quantity::absolute_modulus:
      return "of absolute values of a complex modulus, such as \"|G*| [Pa]\"";
    case Quantity::phase_angle:
      return "of phase angles, such as phase_angle_deg";
    case Quantity::loss_tangent:
      return "of loss tangents, such as tan_delta";
    case Quantity::angular_frequency:
      return "of frequencies, such as frequency_Hz or angular_frequency_rad_per_s";
    case Quantity::temperature:
      return "of temperatures, such as temperature_degC";
    case Quantity::shift_factor:
      return "called shift_factor";
    case Quantity::log10_shift_factor:
      return "called shift_factor or log10_shift_factor";
    case Quantity::diameter:
      return "of diameters, such as diameter_um";
    case Quantity::x:
      return "called x, such as x_um";
    case Quantity::y:
      return "called y, such as y_um";
    case Quantity::z:
      return "called z, such as z_um";
    case Quantity::cumulative_volume_fraction:
      return "called cumulative_volume_fraction, or passing [%]";
    case Quantity::weight:
      return "called weight, such as weight_m2";
    case Quantity::film_share:
      return "called film_share";
    case Quantity::filler:
      return "called filler";
    case Quantity::axis_1:
      return "called axis_1, such as axis_1_um";
    case Quantity::axis_2:
      return "called axis_2, such as axis_2_um";
    case Quantity::axis_3:
      return "called axis_3, such as axis_3_um";
    case Quantity::azimuth:
      return "called azimuth, such as azimuth_deg";
    case Quantity::elevation:
      return "called elevation, such as elevation_deg";
    case Quantity::roll:
      return "called roll, such as roll_deg";
    case Quantity::angle:
      return "called angle, such as angle_deg";
    case Quantity::particle:
      return "called particle";
  }
  return {};
}

/// The name of a kind with its article: "the shear modulus", "Young's modulus".
std::string with_article(ModulusKind kind) {
  return fmt::format("{}{}", kind == ModulusKind::young ? "" : "the ", name(kind));
}

}  // namespace

std::string MeasuredTable::place_of_line(std::size_t line) const {
  return reading_.sheet.empty() ? fmt::format("{}:{}", path_.string(), line)
                                : fmt::format("{}:{}:{}", path_.string(), printable(reading_.sheet), line);
}

std::string MeasuredTable::location(std::size_t row) const {
  return place_of_line(lines_.at(row));
}

bool MeasuredTable::has(std::initializer_list<Quantity> quantities) const {
  return std::ranges::all_of(quantities, [&](Quantity quantity) {
    return std::ranges::find(columns_, quantity, &MeasuredColumn::quantity) != columns_.end();
  });
}

std::vector<ModulusKind> MeasuredTable::kinds() const {
  std::vector<ModulusKind> all;
  for (const auto& column : columns_) {
    using enum Quantity;
    const auto quantity = column.quantity;
    const bool has_kind = quantity == modulus || quantity == compliance || quantity == storage_modulus ||
                          quantity == loss_modulus || quantity == absolute_modulus;
    if (has_kind && std::ranges::find(all, column.kind) == all.end()) all.push_back(column.kind);
  }
  return all;
}

std::vector<std::string> MeasuredTable::unknown_units(std::initializer_list<Quantity> quantities) const {
  std::vector<std::string> lines;
  for (const auto& [quantity, message] : unknown_units_) {
    if (std::ranges::find(quantities, quantity) == quantities.end() || has({quantity})) continue;
    lines.push_back(fmt::format("{}: {}", path_.string(), message));
  }
  return lines;
}

void MeasuredTable::refuse_unknown_units(std::initializer_list<Quantity> quantities) const {
  const auto lines = unknown_units(quantities);
  if (!lines.empty()) throw InputError(fmt::format("{}", fmt::join(lines, "\n")));
}

void MeasuredTable::require(std::initializer_list<Quantity> quantities) const {
  std::vector<std::string> lines;
  for (const auto quantity : quantities) {
    if (has({quantity})) continue;
    const auto of_units = unknown_units({quantity});
    lines.insert(lines.end(), of_units.begin(), of_units.end());
    if (!of_units.empty()) continue;
    lines.push_back(fmt::format("{}: no column {}; it has {}", path_.string(), example_of(quantity), list_of_names()));
  }
  if (!lines.empty()) throw InputError(fmt::format("{}", fmt::join(lines, "\n")));
}

std::string MeasuredTable::list_of_names() const {
  std::vector<std::string> shown;
  for (const auto& name : names_) shown.push_back(shown_value(name));
  constexpr std::size_t most = 20;
  if (shown.size() <= most) return fmt::format("{}", fmt::join(shown, ", "));
  return fmt::format("{} and {} more", fmt::join(shown.begin(), shown.begin() + most, ", "), shown.size() - most);
}

const MeasuredColumn& MeasuredTable::column(Quantity quantity) const {
  require({quantity});
  return *std::ranges::find(columns_, quantity, &MeasuredColumn::quantity);
}

const MeasuredColumn& MeasuredTable::column(Quantity quantity, ModulusKind wanted) const {
  const auto& any = column(quantity);
  if (wanted == ModulusKind::unspecified) return any;
  for (const auto kind : {wanted, ModulusKind::unspecified}) {
    const auto found = std::ranges::find_if(
        columns_, [&](const MeasuredColumn& column) { return column.quantity == quantity && column.kind == kind; });
    if (found != columns_.end()) return *found;
  }
  const auto held = any.kind == ModulusKind::other ? "" : fmt::format(", that of {}", with_article(any.kind));
  throw InputError(fmt::format("{}: expected a column of {}, got {}{}: {}", path_.string(), with_article(wanted),
                               shown_value(any.name), held, conversion_hint(any.kind, wanted)));
}

void MeasuredTable::refuse_several_series() const {
  if (!has_several_series_) return;
  throw InputError(fmt::format(
      "{}: results with several curves, of stages, loads, boundaries or tasks; keep the rows of one of them",
      path_.string()));
}

}  // namespace breccia
