#include "breccia/microstructure/image_statistics.hpp"

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {

std::vector<double> label_fractions(const LabelImage<2>& image, std::size_t count) {
  std::vector<std::size_t> pixels(count);
  for (const auto label : image.labels) {
    if (label >= count) {
      throw InputError(
          fmt::format("image: a pixel has the label {}, counted from 0, but there are only {}", label, count));
    }
    ++pixels[label];
  }
  std::vector<double> fractions;
  for (const auto of_label : pixels) {
    fractions.push_back(static_cast<double>(of_label) / static_cast<double>(image.labels.size()));
  }
  return fractions;
}

double specific_interface(const LabelImage<2>& image) {
  const auto columns = static_cast<std::size_t>(image.pixels[0]), rows = static_cast<std::size_t>(image.pixels[1]);
  const bool is_periodic = image.walls == Walls::periodic;
  const auto differ = [&](std::size_t column, std::size_t row, std::size_t other_column, std::size_t other_row) {
    return image.labels[row * columns + column] != image.labels[other_row * columns + other_column];
  };
  std::size_t sides = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      if (column + 1 < columns || is_periodic) sides += differ(column, row, (column + 1) % columns, row) ? 1U : 0U;
      if (row + 1 < rows || is_periodic) sides += differ(column, row, column, (row + 1) % rows) ? 1U : 0U;
    }
  }
  return static_cast<double>(sides) / (static_cast<double>(columns * rows) * image.pixel_side);
}

}  // namespace breccia
