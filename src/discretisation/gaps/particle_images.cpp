#include "discretisation/gaps/particle_images.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "breccia/error.hpp"

#include "microstructure/vector_algebra.hpp"

namespace breccia::gaps {
namespace {

/// Distance up to which particles are near.
constexpr double reach = 4.0;

template <int dim>
Vector<dim> middle_of_cell(const Index<dim>& cell) noexcept {
  Vector<dim> middle{};
  for (std::size_t axis = 0; axis < dim; ++axis) middle[axis] = cell[axis] + 0.5;
  return middle;
}

}  // namespace

template <int dim>
ParticleImages<dim>::ParticleImages(const ParticlesInBox<dim>& particles, int cells, Boundary boundary)
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
template <int dim>
std::vector<Vector<dim>> ParticleImages<dim>::shifts_of_images(const Outline& outline) const {
  const double outside = margin() + reach + outline.reach();
  const int sides = is_periodic() ? 1 + static_cast<int>(std::ceil(outside / cells_)) : 0;
  std::vector<Vector<dim>> shifts;
  for_each_index(equal(-sides), equal(sides + 1), [&](const Index<dim>& boxes) {
    Vector<dim> shift{};
    double furthest = 0.0;
    for (std::size_t axis = 0; axis < dim; ++axis) {
      shift[axis] = boxes[axis] * cells_;
      furthest = std::max(furthest, std::abs(outline.centre()[axis] + shift[axis] - 0.5 * cells_));
    }
    if (furthest < 0.5 * cells_ + outside) shifts.push_back(shift);
  });
  return shifts;
}

template <int dim>
template <class Action>
void ParticleImages<dim>::for_images_near_cells(const Action& action) const {
  const double from_middle = reach + std::sqrt(0.25 * dim);  // from the middle of a cell to its corners
  for (std::size_t image = 0; image < images_.size(); ++image) {
    const auto& outline = images_[image].outline;
    Index<dim> begin{}, end{};
    for (std::size_t axis = 0; axis < dim; ++axis) {
      const double extent = outline.reach() + from_middle;
      begin[axis] = std::max(static_cast<int>(std::floor(outline.centre()[axis] - extent)), -margin());
      end[axis] = std::min(static_cast<int>(std::floor(outline.centre()[axis] + extent)) + 1, cells_ + margin());
    }
    for_each_index(begin, end, [&](const Index<dim>& cell) {
      const auto middle = middle_of_cell<dim>(cell);
      if (outline.distance(middle) < from_middle) action(bin_of(middle), static_cast<ImageIndex>(image));
    });
  }
  if (!has_walls()) return;
  for_each_index(Index<dim>{}, equal(cells_), [&](const Index<dim>& cell) {
    const auto middle = middle_of_cell<dim>(cell);
    if (nearest_side(middle).distance < from_middle) action(bin_of(middle), walls);
  });
}

template <int dim>
void ParticleImages<dim>::sort_into_bins() {
  std::size_t bins = 1;
  for (int axis = 0; axis < dim; ++axis) bins *= static_cast<std::size_t>(cells_ + 2 * margin());
  first_of_bin_.assign(bins + 1, 0);
  for_images_near_cells([&](std::size_t bin, ImageIndex) { ++first_of_bin_[bin + 1]; });
  std::partial_sum(first_of_bin_.begin(), first_of_bin_.end(), first_of_bin_.begin());
  in_bins_.resize(first_of_bin_.back());
  auto next = first_of_bin_;
  for_images_near_cells([&](std::size_t bin, ImageIndex image) { in_bins_[next[bin]++] = image; });
}

template <int dim>
std::size_t ParticleImages<dim>::bin_of(const Vector<dim>& point) const noexcept {
  std::size_t bin = 0;
  for (std::size_t axis = dim; axis-- > 0;) {
    const int place = std::clamp(static_cast<int>(std::floor(point[axis])), -margin(), cells_ + margin() - 1);
    bin = bin * static_cast<std::size_t>(cells_ + 2 * margin()) + static_cast<std::size_t>(place + margin());
  }
  return bin;
}

template <int dim>
std::span<const ImageIndex> ParticleImages<dim>::near(const Vector<dim>& point) const noexcept {
  const auto bin = bin_of(point);
  return std::span(in_bins_).subspan(first_of_bin_[bin], first_of_bin_[bin + 1] - first_of_bin_[bin]);
}

template <int dim>
typename ParticleImages<dim>::Side ParticleImages<dim>::nearest_side(const Vector<dim>& point) const noexcept {
  Side nearest = {0, 1.0, std::numeric_limits<double>::infinity()};
  for (std::size_t axis = 0; axis < dim; ++axis) {
    const double lower = point[axis], upper = cells_ - point[axis];
    if (lower < nearest.distance) nearest = {axis, 1.0, lower};
    if (upper < nearest.distance) nearest = {axis, -1.0, upper};
  }
  return nearest;
}

template <int dim>
Interval ParticleImages<dim>::inside(const GridLine<dim>& line) const noexcept {
  constexpr double without_end = std::numeric_limits<double>::infinity();
  if (is_periodic()) return {-without_end, without_end};
  return {-line.origin[line.axis], cells_ - line.origin[line.axis]};
}

template <int dim>
double ParticleImages<dim>::content_of_core(ImageIndex image, const Vector<dim>& corner) const {
  const auto& [outline, core, particle] = of(image);
  return (core ? *core : outline).content_of_cell(corner);
}

template <int dim>
double ParticleImages<dim>::distance(ImageIndex image, const Vector<dim>& point) const {
  if (image == walls) return nearest_side(point).distance;
  return of(image).outline.distance(point);
}

template <int dim>
Vector<dim> ParticleImages<dim>::normal(ImageIndex image, const Vector<dim>& point) const {
  if (image == walls) {
    const auto side = nearest_side(point);
    Vector<dim> normal{};
    normal[side.axis] = side.inwards;
    return normal;
  }
  return of(image).outline.normal(point);
}

template <int dim>
NearestTwo ParticleImages<dim>::nearest_two(const Vector<dim>& point) const {
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

template <int dim>
Vector<dim> ParticleImages<dim>::across(ImageIndex one, ImageIndex other, const Vector<dim>& point) const {
  return direction(normal(one, point) - normal(other, point));
}

template <int dim>
std::optional<Interval> ParticleImages<dim>::chord(ImageIndex image, const GridLine<dim>& line) const {
  if (image == walls) {
    constexpr double without_end = std::numeric_limits<double>::infinity();
    const auto [begin, end] = inside(line);
    const bool is_lower = begin + end > 1.0;  // as seen from the face that begins at the origin
    return is_lower ? Interval{-without_end, begin} : Interval{end, without_end};
  }
  return of(image).outline.chord(line);
}

template <int dim>
std::vector<Interval> ParticleImages<dim>::binder_on(const GridLine<dim>& line, const Interval& within) const {
  constexpr double least = 1e-12;
  std::vector<ImageIndex> images;
  for (double middle = within.begin + 0.5; middle < within.end; middle += 1.0) {
    for (const auto image : near(line.at(middle))) {
      if (std::ranges::find(images, image) == images.end()) images.push_back(image);
    }
  }
  std::vector<Interval> chords;
  for (const auto image : images) {
    const auto in_particle = chord(image, line);
    if (in_particle && in_particle->end > within.begin && in_particle->begin < within.end) {
      chords.push_back(*in_particle);
    }
  }
  std::ranges::sort(chords, {}, &Interval::begin);
  std::vector<Interval> binder;
  const auto in_box = inside(line);
  const double last = std::min(within.end, in_box.end);
  double covered = std::max(within.begin, in_box.begin);
  for (const auto& in_particle : chords) {
    if (in_particle.begin > covered + least) binder.push_back({covered, in_particle.begin});
    covered = std::max(covered, in_particle.end);
  }
  if (covered < last - least) binder.push_back({covered, last});
  return binder;
}

template class ParticleImages<2>;
template class ParticleImages<3>;

}  // namespace breccia::gaps
