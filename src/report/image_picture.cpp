#include "report/image_picture.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/report/microstructure_picture.hpp"

#include "report/embedded_png.hpp"
#include "report/picture_frame.hpp"

namespace breccia {
namespace {

/// The most frequent label in the square with this lower left corner and a side of at most `side` pixels.
Label most_frequent_label(const LabelImage<2>& image, std::size_t column, std::size_t row, std::size_t side,
                          std::vector<std::size_t>& counts) {
  const auto columns = static_cast<std::size_t>(image.pixels[0]);
  std::ranges::fill(counts, 0);
  for (auto y = row; y < std::min(row + side, columns); ++y) {
    for (auto x = column; x < std::min(column + side, columns); ++x) ++counts[image.labels[y * columns + x]];
  }
  return static_cast<Label>(std::ranges::max_element(counts) - counts.begin());
}

/// The rows of the picture from the top.
std::vector<std::uint8_t> drawn_labels(const LabelImage<2>& image, std::size_t side, std::size_t labels) {
  const auto columns = static_cast<std::size_t>(image.pixels[0]);
  std::vector<std::size_t> counts(labels);
  std::vector<std::uint8_t> drawn;
  for (auto row = (columns + side - 1) / side; row-- > 0;) {
    for (std::size_t column = 0; column < columns; column += side) {
      drawn.push_back(static_cast<std::uint8_t>(most_frequent_label(image, column, row * side, side, counts)));
    }
  }
  return drawn;
}

std::string coloured_picture(const LabelImage<2>& image, std::span<const std::string_view> colours,
                             std::string_view content) {
  require_valid(image);
  if (!has_equal_sides(image)) throw InputError("picture of an image: expected a square image");
  if (std::ranges::max(image.labels) >= colours.size()) {
    throw InputError("picture of an image: a label has no colour");
  }
  std::vector<Rgb> palette;
  for (const auto colour : colours) palette.push_back(parsed_colour(colour));
  constexpr std::size_t most_columns = 1000;
  const auto columns = static_cast<std::size_t>(image.pixels[0]);
  const auto side = (columns + most_columns - 1) / most_columns;
  const auto drawn = drawn_labels(image, side, colours.size());
  const auto drawn_columns = (columns + side - 1) / side;
  // The last squares may reach beyond the image.
  const double width = drawn_side * static_cast<double>(drawn_columns * side) / static_cast<double>(columns);
  const auto shapes = fmt::format(
      "<image y=\"{0:.6g}\" width=\"{1:.6g}\" height=\"{1:.6g}\" style=\"image-rendering: pixelated\" href=\"{2}\"/>\n",
      drawn_side - width, width, embedded_png(drawn_columns, drawn, palette));
  return framed_picture(box_of(image)[0], content, "", shapes);
}

}  // namespace

std::string image_picture(const LabelImage<2>& image, std::span<const std::size_t> colours) {
  std::vector<std::string_view> of_labels;
  for (const auto colour : colours) of_labels.push_back(colour == 0 ? matrix_colour : colour_of_phase(colour));
  return coloured_picture(image, of_labels, fmt::format("an image of {0} x {0} pixels", image.pixels[0]));
}

std::string plane_picture(const LabelImage<2>& plane, std::span<const std::string_view> colours,
                          std::string_view content) {
  return coloured_picture(plane, colours, content);
}

}  // namespace breccia
