#include "rasters/imagej_description.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace breccia {

namespace {

/// The number at the beginning of a text.
template <class Number>
std::optional<Number> leading_number(std::string_view text) {
  Number number{};
  if (std::from_chars(text.data(), text.data() + text.size(), number).ec != std::errc()) return {};
  return number;
}

/// A unit as ImageJ spells it [m].
std::optional<double> unit_of_length(std::string_view name) {
  struct Unit {
    std::string_view name;
    double metres;
  };
  static constexpr std::array<Unit, 11> units = {{{"nm", 1e-9},
                                                  {"um", 1e-6},
                                                  {"\xb5m", 1e-6},  // in Latin-1
                                                  {"\xc2\xb5m", 1e-6},
                                                  {"\\u00B5m", 1e-6},
                                                  {"micron", 1e-6},
                                                  {"microns", 1e-6},
                                                  {"mm", 1e-3},
                                                  {"cm", 1e-2},
                                                  {"inch", 0.0254},
                                                  {"m", 1.0}}};
  const auto* const known = std::ranges::find(units, name, &Unit::name);
  return known == units.end() ? std::nullopt : std::optional(known->metres);
}

}  // namespace

std::optional<ImagejDescription> read_imagej_description(std::string_view text) {
  if (!text.starts_with("ImageJ=")) return {};
  ImagejDescription description;
  while (!text.empty()) {
    const auto line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    const auto key = line.substr(0, line.find('='));
    const auto value = line.substr(std::min(key.size() + 1, line.size()));
    if (key == "images") description.images = leading_number<std::size_t>(value).value_or(1);
    if (key == "channels") description.channels = leading_number<std::size_t>(value).value_or(1);
    if (key == "frames") description.frames = leading_number<std::size_t>(value).value_or(1);
    if (key == "unit") description.unit = unit_of_length(value);
    if (key == "spacing") description.spacing = leading_number<double>(value);
  }
  return description;
}

}  // namespace breccia
