#include "rasters/vti_reader.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/display.hpp"
#include "io/file_mistakes.hpp"
#include "io/nearest_name.hpp"
#include "rasters/raster_elements.hpp"
#include "rasters/raster_layout.hpp"
#include "rasters/vti_document.hpp"

namespace breccia {

namespace {

/// The numbers of an attribute such as Extent="0 4 0 3 0 0".
template <std::size_t count>
std::array<double, count> attribute_numbers(const VtiDocument& document, const pugi::xml_node& node, const char* name,
                                            std::string_view otherwise) {
  const std::string_view text = node.attribute(name).as_string(otherwise.data());
  std::array<double, count> numbers{};
  auto rest = text;
  for (auto& number : numbers) {
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t\r\n"), rest.size()));
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    if (error != std::errc() || !std::isfinite(number)) {
      document.refuse(fmt::format("{}={}", name, shown_value(text)), fmt::format("{} numbers", count));
    }
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  }
  return numbers;
}

/// The only piece of the image.
pugi::xml_node only_piece(const VtiDocument& document) {
  const auto pieces = document.image().children("Piece");
  const auto count = std::distance(pieces.begin(), pieces.end());
  if (count != 1) document.refuse(fmt::format("an image in {} pieces", count), "one piece");
  return *pieces.begin();
}

void require_cubes_along_axes(const VtiDocument& document) {
  constexpr double tolerance = 1e-6;
  const auto spacing = attribute_numbers<3>(document, document.image(), "Spacing", "1 1 1");
  const auto extent = attribute_numbers<6>(document, document.image(), "WholeExtent", "");
  const auto is_like_first = [&](std::size_t axis) {
    const bool is_flat = extent[2 * axis] == extent[2 * axis + 1];
    return is_flat || std::abs(spacing[axis] - spacing[0]) <= tolerance * std::abs(spacing[0]);
  };
  if (!is_like_first(1) || !is_like_first(2)) {
    document.refuse(fmt::format("Spacing=\"{}\"", fmt::join(spacing, " ")), "the same along all axes");
  }
  constexpr std::array<double, 9> along_axes = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  if (attribute_numbers<9>(document, document.image(), "Direction", "1 0 0 0 1 0 0 0 1") != along_axes) {
    document.refuse("an image whose Direction is rotated", "one along the axes");
  }
}

/// Arrays of the cells and of the points, except those of VTK's own (vtkGhostType).
std::vector<pugi::xml_node> arrays_of(const pugi::xml_node& piece) {
  std::vector<pugi::xml_node> arrays;
  for (const auto* const place : {"CellData", "PointData"}) {
    for (const auto& array : piece.child(place).children("DataArray")) {
      if (!std::string_view(array.attribute("Name").value()).starts_with("vtk")) arrays.push_back(array);
    }
  }
  return arrays;
}

std::string name_of(const pugi::xml_node& array) {
  return array.attribute("Name").value();
}

bool is_active(const pugi::xml_node& array) {
  const std::string_view active = array.parent().attribute("Scalars").value();
  return !active.empty() && active == name_of(array);
}

/// The array of this name or, without one, the active scalars or the only array.
pugi::xml_node chosen_array(const VtiDocument& document, const pugi::xml_node& piece, std::string_view name) {
  const auto arrays = arrays_of(piece);
  if (arrays.empty()) document.refuse("no array", "one, in CellData or PointData");
  std::vector<std::string> names;
  std::ranges::transform(arrays, std::back_inserter(names), name_of);
  if (!name.empty()) {
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) {
      document.refuse(fmt::format("no array {}", shown_value(name)),
                      fmt::format("the name of one{}", suggestion(name, names)));
    }
    return arrays[static_cast<std::size_t>(found - names.begin())];
  }
  if (arrays.size() == 1) return arrays.front();
  const auto active = std::ranges::find_if(arrays, is_active);
  if (std::ranges::count_if(arrays, is_active) == 1) return *active;
  document.refuse(fmt::format("{} arrays", arrays.size()),
                  fmt::format("the name of one of them: \"{}\"", fmt::join(names, "\", \"")));
}

ElementType element_type(const VtiDocument& document, const pugi::xml_node& array) {
  using enum ElementType::Kind;
  struct Known {
    std::string_view name;
    ElementType::Kind kind;
    std::size_t bytes;
  };
  static constexpr std::array<Known, 10> known = {{{"Int8", signed_integer, 1},
                                                   {"UInt8", unsigned_integer, 1},
                                                   {"Int16", signed_integer, 2},
                                                   {"UInt16", unsigned_integer, 2},
                                                   {"Int32", signed_integer, 4},
                                                   {"UInt32", unsigned_integer, 4},
                                                   {"Int64", signed_integer, 8},
                                                   {"UInt64", unsigned_integer, 8},
                                                   {"Float32", floating_point, 4},
                                                   {"Float64", floating_point, 8}}};
  const std::string_view type = array.attribute("type").value();
  const auto* const found = std::ranges::find(known, type, &Known::name);
  if (found == known.end()) {
    document.refuse(fmt::format("an array of type {}", shown_value(type)), "integers, or numbers that are whole");
  }
  return {found->kind, found->bytes, document.byte_order()};
}

/// Number of pixels along each axis: of the cells or of the points between which they lie. A flat image has one layer
/// of cells.
std::vector<std::size_t> extents_of(const VtiDocument& document, const pugi::xml_node& piece,
                                    const pugi::xml_node& array) {
  const auto extent = attribute_numbers<6>(document, piece, "Extent", "");
  if (extent != attribute_numbers<6>(document, document.image(), "WholeExtent", "")) {
    document.refuse("a piece that is not the whole image", "one piece of the WholeExtent");
  }
  const double of_points = std::string_view(array.parent().name()) == "PointData" ? 1.0 : 0.0;
  std::vector<std::size_t> extents;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    constexpr double most = 4294967295.0;
    const double count = extent[2 * axis + 1] - extent[2 * axis] + of_points;
    if (!(count >= 0.0 && count <= most) || count != std::trunc(count)) {
      document.refuse(fmt::format("the extent {}", fmt::join(extent, " ")), "whole numbers, in order");
    }
    extents.push_back(static_cast<std::size_t>(count));
  }
  extents[2] = std::max<std::size_t>(extents[2], 1);
  return extents;
}

std::vector<std::int32_t> numbers_of_text(const VtiDocument& document, std::string_view text, std::size_t count) {
  std::vector<std::int32_t> values;
  values.reserve(std::min(count, text.size()));
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    if (text.empty()) break;
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) document.refuse(shown_value(text.substr(0, text.find_first_of(" \t\r\n"))), "a number");
    values.push_back(raster_value(document.file(), number));
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
  if (values.size() != count) {
    document.refuse(fmt::format("an array of {}", display_count(values.size(), "number")),
                    fmt::format("{} for the extent", count));
  }
  return values;
}

std::vector<std::int32_t> values_of(const VtiDocument& document, const pugi::xml_node& array, std::size_t count) {
  const auto type = element_type(document, array);
  const std::string_view format = array.attribute("format").value();
  if (format == "ascii") return numbers_of_text(document, array.text().get(), count);
  if (format != "binary" && format != "appended") {
    document.refuse(fmt::format("an array in the format {}", shown_value(format)), "ascii, binary or appended");
  }
  require_plausible_size(document.file(), count * type.bytes, document.file_size());
  const auto bytes = document.array_bytes(array, count * type.bytes);
  std::vector<std::int32_t> values;
  values.reserve(count);
  append_elements(values, document.file(), bytes, type);
  return values;
}

}  // namespace

Raster read_vti(const std::filesystem::path& file, std::string_view bytes, std::string_view array_name) {
  const VtiDocument document(file, bytes);
  const auto piece = only_piece(document);
  require_cubes_along_axes(document);
  const auto array = chosen_array(document, piece, array_name);
  if (const auto components = array.attribute("NumberOfComponents").as_uint(1); components > 1) {
    document.refuse(fmt::format("{} numbers a pixel in array {}", components, shown_value(name_of(array))), "one");
  }
  auto extents = extents_of(document, piece, array);
  auto values = values_of(document, array, pixel_count(file, extents));
  return raster_from_bottom(std::move(extents), std::move(values));
}

}  // namespace breccia
