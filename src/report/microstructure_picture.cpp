#include "breccia/report/microstructure_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "picture_frame.hpp"

namespace breccia {

namespace {

/// Whether any part of the disc lies inside the box [0, side]^2.
bool shows_in_box(const Disc& disc, double side) {
  double squared_distance = 0.0;  // from the centre to the box
  for (const double x : disc.centre) {
    const double outside = x < 0.0 ? -x : (x > side ? x - side : 0.0);
    squared_distance += outside * outside;
  }
  return 4.0 * squared_distance < disc.diameter * disc.diameter;
}

/// A disc to draw, with its colour.
struct DrawnDisc {
  Disc disc;
  std::size_t colour;
};

/// Adds a particle, above its coating.
void add_particle(const Disc& disc, const DrawnFiller& filler, std::vector<DrawnDisc>& discs) {
  if (filler.coating_thickness > 0.0) {
    discs.push_back({{disc.centre, disc.diameter + 2.0 * filler.coating_thickness}, filler.coating_colour});
  }
  discs.push_back({disc, filler.colour});
}

/// The discs to draw: the discs of the box and, in a periodic box, their visible images.
std::vector<DrawnDisc> visible_discs(const Microstructure<2>& microstructure, const std::vector<DrawnFiller>& fillers) {
  const double side = microstructure.side;
  std::vector<DrawnDisc> visible;
  for (std::size_t particle = 0; particle < microstructure.particles.size(); ++particle) {
    const auto& disc = microstructure.particles[particle];
    const auto& filler = fillers[microstructure.filler_of(particle)];
    add_particle(disc, filler, visible);
    if (microstructure.walls == Walls::hard) continue;
    for (const double dx : {-side, 0.0, side}) {
      for (const double dy : {-side, 0.0, side}) {
        const Disc image{{disc.centre[0] + dx, disc.centre[1] + dy}, disc.diameter};
        const Disc outer{image.centre, image.diameter + 2.0 * filler.coating_thickness};
        if (image != disc && shows_in_box(outer, side)) add_particle(image, filler, visible);
      }
    }
  }
  return visible;
}

}  // namespace

std::string_view colour_of_phase(std::size_t number) {
  constexpr std::array<std::string_view, 8> colours = {"#5b7f95", "#b5652b", "#6b8e4e", "#8a6bac",
                                                       "#c9a227", "#a8444f", "#3f8f8b", "#7a7a7a"};
  return colours[(number + colours.size() - 1) % colours.size()];
}

std::string microstructure_picture(const Microstructure<2>& microstructure, const std::vector<DrawnFiller>& fillers) {
  const double side = microstructure.side;
  const auto is_unknown = [&](std::size_t filler) { return filler >= fillers.size(); };
  const bool needs_one = microstructure.fillers.empty() && !microstructure.particles.empty();
  if ((needs_one && fillers.empty()) || std::ranges::any_of(microstructure.fillers, is_unknown)) {
    throw InputError("picture of a microstructure: a particle belongs to no filler");
  }
  std::string shapes;
  const auto out = std::back_inserter(shapes);
  const double scale = picture_scale(side);
  for (const auto& [disc, colour] : visible_discs(microstructure, fillers)) {
    fmt::format_to(out, "<circle cx=\"{:.6g}\" cy=\"{:.6g}\" r=\"{:.4g}\"", disc.centre[0] * scale,
                   drawn_side - disc.centre[1] * scale, disc.diameter / 2.0 * scale);
    if (colour != 1) fmt::format_to(out, " fill=\"{}\"", colour_of_phase(colour));
    fmt::format_to(out, "/>\n");
  }
  constexpr auto style = R"(fill="#5b7f95" stroke="#2f4858" stroke-width="1")";
  return framed_picture(side, fmt::format("{} particles", microstructure.particles.size()), style, shapes);
}

}  // namespace breccia
