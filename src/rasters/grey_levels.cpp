#include "rasters/grey_levels.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

namespace breccia {

namespace {

using Pixel = std::span<const std::uint16_t>;
using Colour = std::array<std::uint16_t, 3>;

bool has_colour(std::size_t channels) {
  return channels >= std::tuple_size_v<Colour>;
}

bool is_grey(Pixel pixel) {
  return !has_colour(pixel.size()) || (pixel[0] == pixel[1] && pixel[1] == pixel[2]);
}

bool is_opaque(Pixel pixel, std::uint16_t most) {
  return pixel.size() % 2 == 1 || pixel.back() == most;
}

template <class Action>
void for_each_pixel(const PixelSamples& picture, const Action& action) {
  for (Pixel rest = picture.samples; !rest.empty(); rest = rest.subspan(picture.channels)) {
    action(rest.first(picture.channels));
  }
}

/// The most frequent colours of a picture in colour, with their shares of the pixels.
std::string most_frequent_colours(const PixelSamples& picture) {
  constexpr std::size_t most_counted = 65536, most_named = 5;
  std::map<Colour, std::size_t> counts;
  for_each_pixel(picture, [&](Pixel pixel) {
    const Colour colour{pixel[0], pixel[1], pixel[2]};
    const auto counted = counts.find(colour);
    if (counted != counts.end()) {
      ++counted->second;
    } else if (counts.size() < most_counted) {
      counts.emplace(colour, 1);
    }
  });
  std::vector<std::pair<Colour, std::size_t>> sorted(counts.begin(), counts.end());
  std::ranges::stable_sort(sorted, std::ranges::greater(), &std::pair<Colour, std::size_t>::second);
  const auto pixels = static_cast<double>(picture.samples.size()) / static_cast<double>(picture.channels);
  std::vector<std::string> names;
  for (const auto& [colour, count] : std::span(sorted).first(std::min(most_named, sorted.size()))) {
    names.push_back(fmt::format("({}) {:.3g} %", fmt::join(colour, ", "), 100.0 * static_cast<double>(count) / pixels));
  }
  return fmt::format("{}{} colours: {}{}", sorted.size() == most_counted ? "at least " : "", sorted.size(),
                     fmt::join(names, ", "), sorted.size() > most_named ? ", ..." : "");
}

}  // namespace

std::vector<std::int32_t> grey_levels(const std::filesystem::path& file, const PixelSamples& picture) {
  std::vector<std::int32_t> levels;
  levels.reserve(picture.samples.size() / picture.channels);
  bool are_grey = true, are_opaque = true;
  for_each_pixel(picture, [&](Pixel pixel) {
    are_grey = are_grey && is_grey(pixel);
    are_opaque = are_opaque && is_opaque(pixel, picture.most);
    levels.push_back(pixel[0]);
  });
  if (!are_grey) {
    throw InputError(fmt::format(
        "{}: a picture in colour; expected grey levels, or a palette whose numbers are the labels. It has {}",
        file.string(), most_frequent_colours(picture)));
  }
  if (!are_opaque) {
    throw InputError(fmt::format("{}: a picture with transparent pixels; expected opaque ones", file.string()));
  }
  return levels;
}

}  // namespace breccia
