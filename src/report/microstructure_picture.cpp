#include "breccia/report/microstructure_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "report/picture_frame.hpp"

namespace breccia {

namespace {

/// Whether any part of the disc lies inside the box [0, side]^2.
bool shows_in_box(const Disc& disc, double side) {
  double squared_distance = 0.0;  // squared distance from the centre to the box
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

/// The disc of a sphere in a plane at this distance from its centre [m]; nothing where the plane does not cut it.
std::optional<double> diameter_of_cut(double diameter, double distance) {
  const double squared = diameter * diameter - 4.0 * distance * distance;
  if (!(squared > 0.0)) return std::nullopt;
  return std::sqrt(squared);
}

/// Adds the discs of the spheres, and of their coatings, that the middle plane cuts.
std::vector<DrawnDisc> cut_discs(const Microstructure<3>& microstructure, const std::vector<DrawnFiller>& fillers,
                                 std::size_t normal) {
  const std::size_t across = (normal + 1) % 3, up = (normal + 2) % 3;
  std::vector<DrawnDisc> discs;
  for_each_image(microstructure, [&](std::size_t particle, const Ball<3>& sphere) {
    const auto& filler = fillers[microstructure.filler_of(particle)];
    const double distance = sphere.centre[normal] - 0.5 * microstructure.side;
    const auto add = [&](double diameter, std::size_t colour) {
      const auto cut = diameter_of_cut(diameter, distance);
      if (!cut) return;
      const Disc disc = {{sphere.centre[across], sphere.centre[up]}, *cut};
      if (shows_in_box(disc, microstructure.side)) discs.push_back({disc, colour});
    };
    if (filler.coating_thickness > 0.0) add(sphere.diameter + 2.0 * filler.coating_thickness, filler.coating_colour);
    add(sphere.diameter, filler.colour);
  });
  return discs;
}

void require_fillers(std::span<const std::size_t> of_particles, std::size_t particles, std::size_t fillers) {
  const auto is_unknown = [&](std::size_t filler) { return filler >= fillers; };
  const bool needs_one = of_particles.empty() && particles > 0;
  if ((needs_one && fillers == 0) || std::ranges::any_of(of_particles, is_unknown)) {
    throw InputError("picture of a microstructure: a particle belongs to no filler");
  }
}

std::string circles(const std::vector<DrawnDisc>& discs, double side) {
  std::string shapes;
  const auto out = std::back_inserter(shapes);
  const double scale = picture_scale(side);
  for (const auto& [disc, colour] : discs) {
    fmt::format_to(out, R"(<circle cx="{:.6g}" cy="{:.6g}" r="{:.4g}")", disc.centre[0] * scale,
                   drawn_side - disc.centre[1] * scale, disc.diameter / 2.0 * scale);
    if (colour != 1) fmt::format_to(out, " fill=\"{}\"", colour_of_phase(colour));
    fmt::format_to(out, "/>\n");
  }
  return shapes;
}

constexpr auto style_of_particles = R"(fill="#5b7f95" stroke="#2f4858" stroke-width="1")";

}  // namespace

std::string_view colour_of_phase(std::size_t number) {
  constexpr std::array<std::string_view, 8> colours = {"#5b7f95", "#b5652b", "#6b8e4e", "#8a6bac",
                                                       "#c9a227", "#a8444f", "#3f8f8b", "#7a7a7a"};
  return colours[(number + colours.size() - 1) % colours.size()];
}

std::string microstructure_picture(const Microstructure<2>& microstructure, const std::vector<DrawnFiller>& fillers) {
  require_fillers(microstructure.fillers, microstructure.particles.size(), fillers.size());
  return framed_picture(microstructure.side, fmt::format("{} particles", microstructure.particles.size()),
                        style_of_particles, circles(visible_discs(microstructure, fillers), microstructure.side));
}

std::string cut_picture(const Microstructure<3>& microstructure, Axis normal, const std::vector<DrawnFiller>& fillers) {
  require_fillers(microstructure.fillers, microstructure.particles.size(), fillers.size());
  constexpr std::array names = {"x", "y", "z"};
  const auto axis = static_cast<std::size_t>(normal);
  return framed_picture(microstructure.side,
                        fmt::format("cut through the middle of {} particles, seen along {}",
                                    microstructure.particles.size(), names[axis]),
                        style_of_particles, circles(cut_discs(microstructure, fillers, axis), microstructure.side));
}

}  // namespace breccia
