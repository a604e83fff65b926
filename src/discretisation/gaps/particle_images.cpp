#include "discretisation/gaps/particle_images.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "breccia/error.hpp"

#include "microstructure/vector_algebra.hpp"

namespace breccia::gaps {
namespace {

/// Distance up to which particles are near.
constexpr double reach = 4.0;

}  // namespace

ParticleImages::ParticleImages(const ParticlesInBox& particles, int cells, Boundary boundary)
    : cells_(cells), boundary_(boundary) {
  const auto& box = particles.box;
  if ((box.walls == Walls::periodic) != is_periodic()) {
    throw InputError("gaps under a cell: expected a periodic boundary for a periodic box, and for no other");
  }
  const double per_length = cells / box.side;
  for (std::size_t particle = 0; particle < box.particles.size(); ++particle) {
    const double thickness = particles.phases[particle].coating_thickness;
    const Outline outline(box.particles[particle], thickness, per_length);
    std::optional<Outline> core;
    if (thickness > 0.0) core = Outline(box.particles[particle], 0.0, per_length);
    for (const auto& shift : shifts_of_images(outline)) {
      images_.push_back({outline.moved(shift), core ? std::optional(core->moved(shift)) : std::nullopt, particle});
    }
  }
  sort_into_bins();
}

/// The distances of the images of a particle that are near to the box or to its margin.
std::vector<Vector<2>> ParticleImages::shifts_of_images(const Outline& outline) const {
  const double outside = margin() + reach + outline.reach();
  const int sides = is_periodic() ? 1 + static_cast<int>(std::ceil(outside / cells_)) : 0;
  std::vector<Vector<2>> shifts;
  for_each_index(Index<2>{-sides, -sides}, Index<2>{sides + 1, sides + 1}, [&](const Index<2>& boxes) {
    const Vector<2> shift = {static_cast<double>(boxes[0] * cells_), static_cast<double>(boxes[1] * cells_)};
    const auto from_middle = outline.centre() + shift - Vector<2>{0.5 * cells_, 0.5 * cells_};
    if (std::max(std::abs(from_middle[0]), std::abs(from_middle[1])) < 0.5 * cells_ + outside) shifts.push_back(shift);
  });
  return shifts;
}

void ParticleImages::sort_into_bins() {
  const int along = cells_ + 2 * margin();
  std::vector<std::vector<ImageIndex>> bins(static_cast<std::size_t>(along) * static_cast<std::size_t>(along));
  const double from_middle = reach + std::sqrt(0.5);  // from the middle of a cell to its corners
  for (std::size_t image = 0; image < images_.size(); ++image) {
    const auto& outline = images_[image].outline;
    Index<2> begin{}, end{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double extent = outline.reach() + from_middle;
      begin[axis] = std::max(static_cast<int>(std::floor(outline.centre()[axis] - extent)), -margin());
      end[axis] = std::min(static_cast<int>(std::floor(outline.centre()[axis] + extent)) + 1, cells_ + margin());
    }
    for_each_index(begin, end, [&](const Index<2>& cell) {
      const Vector<2> middle = {cell[0] + 0.5, cell[1] + 0.5};
      if (outline.distance(middle) < from_middle) bins[bin_of(middle)].push_back(static_cast<ImageIndex>(image));
    });
  }
  if (has_walls()) {
    for_each_index(Index<2>{}, Index<2>{cells_, cells_}, [&](const Index<2>& cell) {
      const Vector<2> middle = {cell[0] + 0.5, cell[1] + 0.5};
      if (nearest_side(middle).distance < from_middle) bins[bin_of(middle)].push_back(walls);
    });
  }
  first_of_bin_.push_back(0);
  for (const auto& bin : bins) {
    in_bins_.insert(in_bins_.end(), bin.begin(), bin.end());
    first_of_bin_.push_back(in_bins_.size());
  }
}

std::size_t ParticleImages::bin_of(const Vector<2>& point) const noexcept {
  const auto place = [&](double x) {
    const int cell = std::clamp(static_cast<int>(std::floor(x)), -margin(), cells_ + margin() - 1) + margin();
    return static_cast<std::size_t>(cell);
  };
  const int along = cells_ + 2 * margin();
  return place(point[1]) * static_cast<std::size_t>(along) + place(point[0]);
}

std::span<const ImageIndex> ParticleImages::near(const Vector<2>& point) const noexcept {
  const auto bin = bin_of(point);
  return std::span(in_bins_).subspan(first_of_bin_[bin], first_of_bin_[bin + 1] - first_of_bin_[bin]);
}

ParticleImages::Side ParticleImages::nearest_side(const Vector<2>& point) const noexcept {
  Side nearest = {0, 1.0, std::numeric_limits<double>::infinity()};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double lower = point[axis], upper = cells_ - point[axis];
    if (lower < nearest.distance) nearest = {axis, 1.0, lower};
    if (upper < nearest.distance) nearest = {axis, -1.0, upper};
  }
  return nearest;
}

Interval ParticleImages::inside(const GridLine& line) const noexcept {
  constexpr double without_end = std::numeric_limits<double>::infinity();
  if (is_periodic()) return {-without_end, without_end};
  return {-line.origin[line.axis], cells_ - line.origin[line.axis]};
}

double ParticleImages::area_of_core(ImageIndex image, const Vector<2>& corner) const {
  const auto& [outline, core, particle] = of(image);
  return (core ? *core : outline).area_in_square(corner);
}

double ParticleImages::distance(ImageIndex image, const Vector<2>& point) const {
  if (image == walls) return nearest_side(point).distance;
  return of(image).outline.distance(point);
}

Vector<2> ParticleImages::normal(ImageIndex image, const Vector<2>& point) const {
  if (image == walls) {
    const auto side = nearest_side(point);
    Vector<2> normal{};
    normal[side.axis] = side.inwards;
    return normal;
  }
  return of(image).outline.normal(point);
}

NearestTwo ParticleImages::nearest_two(const Vector<2>& point) const {
  constexpr double nearer = 1e-9;
  NearestTwo nearest;
  for (const auto image : near(point)) {
    const double to_image = distance(image, point);
    if (to_image < nearest.to_first - nearer) {
      nearest = {image, nearest.first, to_image, nearest.to_first};
    } else if (to_image < nearest.to_second - nearer) {
      nearest.second = image;
      nearest.to_second = to_image;
    }
  }
  return nearest;
}

Vector<2> ParticleImages::across(ImageIndex one, ImageIndex other, const Vector<2>& point) const {
  return direction(normal(one, point) - normal(other, point));
}

std::optional<Interval> ParticleImages::chord(ImageIndex image, const GridLine& line) const {
  if (image == walls) {
    constexpr double without_end = std::numeric_limits<double>::infinity();
    const auto [begin, end] = inside(line);
    const bool is_lower = begin + end > 1.0;  // as seen from the face that begins at the origin
    return is_lower ? Interval{-without_end, begin} : Interval{end, without_end};
  }
  return of(image).outline.chord(line);
}

std::vector<Interval> ParticleImages::binder_on(const GridLine& line) const {
  constexpr double least = 1e-12;
  std::vector<Interval> chords;
  for (const auto image : near(line.at(0.5))) {
    const auto in_particle = chord(image, line);
    if (in_particle && in_particle->end > 0.0 && in_particle->begin < 1.0) chords.push_back(*in_particle);
  }
  std::ranges::sort(chords, {}, &Interval::begin);
  std::vector<Interval> binder;
  const auto in_box = inside(line);
  const double last = std::min(1.0, in_box.end);
  double covered = std::max(0.0, in_box.begin);
  for (const auto& in_particle : chords) {
    if (in_particle.begin > covered + least) binder.push_back({covered, in_particle.begin});
    covered = std::max(covered, in_particle.end);
  }
  if (covered < last - least) binder.push_back({covered, last});
  return binder;
}

}  // namespace breccia::gaps
