#include "discretisation/gaps/disc_images.hpp"

#include <algorithm>
#include <cmath>

#include "breccia/error.hpp"

#include "microstructure/vector_algebra.hpp"

namespace breccia::gaps {
namespace {

/// Distance up to which particles are near.
constexpr double reach = 4.0;

/// The unit vector along a vector; zero for a vector of rounding errors.
Vector<2> direction(const Vector<2>& vector) {
  constexpr double rounding = 1e-12;
  const double length = norm(vector);
  return length > rounding ? vector / length : Vector<2>{};
}

}  // namespace

DiscImages::DiscImages(const Microstructure<2>& microstructure, int cells) : cells_(cells) {
  if (microstructure.walls != Walls::periodic) throw InputError("gaps under a cell: expected a periodic box");
  const double per_length = cells / microstructure.side, outside = margin + reach;
  double widest = 0.0;
  for (const auto& ball : microstructure.particles) widest = std::max(widest, per_length * ball.diameter);
  const int sides = 1 + static_cast<int>(std::ceil((outside + 0.5 * widest) / cells));
  for (std::size_t particle = 0; particle < microstructure.particles.size(); ++particle) {
    for_each_index(Index<2>{-sides, -sides}, Index<2>{sides + 1, sides + 1}, [&](const Index<2>& shift) {
      const auto& ball = microstructure.particles[particle];
      Disc disc = {per_length * ball.centre, per_length * ball.diameter};
      bool is_near = true;
      for (std::size_t axis = 0; axis < 2; ++axis) {
        disc.centre[axis] += shift[axis] * cells;
        is_near = is_near && std::abs(disc.centre[axis] - 0.5 * cells) < 0.5 * (cells + disc.diameter) + outside;
      }
      if (is_near) images_.push_back({disc, particle});
    });
  }
  const int along = cells + 2 * margin;
  std::vector<std::vector<ImageIndex>> bins(static_cast<std::size_t>(along) * static_cast<std::size_t>(along));
  for (std::size_t image = 0; image < images_.size(); ++image) {
    const auto& disc = images_[image].disc;
    const double radius = 0.5 * disc.diameter + reach + std::sqrt(0.5);  // from the centre of a cell to its corners
    Index<2> begin{}, end{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      begin[axis] = std::max(static_cast<int>(std::floor(disc.centre[axis] - radius)), -margin);
      end[axis] = std::min(static_cast<int>(std::floor(disc.centre[axis] + radius)) + 1, cells + margin);
    }
    for_each_index(begin, end, [&](const Index<2>& cell) {
      const Vector<2> centre = {cell[0] + 0.5, cell[1] + 0.5};
      if (norm(centre - disc.centre) < radius) bins[bin_of(centre)].push_back(static_cast<ImageIndex>(image));
    });
  }
  first_of_bin_.push_back(0);
  for (const auto& bin : bins) {
    in_bins_.insert(in_bins_.end(), bin.begin(), bin.end());
    first_of_bin_.push_back(in_bins_.size());
  }
}

std::size_t DiscImages::bin_of(const Vector<2>& point) const noexcept {
  const auto place = [&](double x) {
    return static_cast<std::size_t>(std::clamp(static_cast<int>(std::floor(x)), -margin, cells_ + margin - 1) + margin);
  };
  return place(point[1]) * static_cast<std::size_t>(cells_ + 2 * margin) + place(point[0]);
}

std::span<const ImageIndex> DiscImages::near(const Vector<2>& point) const noexcept {
  const auto bin = bin_of(point);
  return std::span(in_bins_).subspan(first_of_bin_[bin], first_of_bin_[bin + 1] - first_of_bin_[bin]);
}

double DiscImages::distance(ImageIndex image, const Vector<2>& point) const noexcept {
  const auto& disc = of(image).disc;
  return norm(point - disc.centre) - 0.5 * disc.diameter;
}

Vector<2> DiscImages::normal(ImageIndex image, const Vector<2>& point) const noexcept {
  return direction(point - of(image).disc.centre);
}

NearestTwo DiscImages::nearest_two(const Vector<2>& point) const noexcept {
  constexpr double rounding = 1e-9;
  NearestTwo nearest;
  for (const auto image : near(point)) {
    const double to_image = distance(image, point);
    if (to_image < nearest.to_first - rounding) {
      nearest = {image, nearest.first, to_image, nearest.to_first};
    } else if (to_image < nearest.to_second - rounding) {
      nearest.second = image;
      nearest.to_second = to_image;
    }
  }
  return nearest;
}

Vector<2> DiscImages::across(ImageIndex one, ImageIndex other, const Vector<2>& point) const noexcept {
  return direction(normal(one, point) - normal(other, point));
}

std::optional<Interval> DiscImages::chord(ImageIndex image, const GridLine& line) const noexcept {
  const auto& disc = of(image).disc;
  const auto to_centre = disc.centre - line.origin;
  const double off = to_centre[1 - line.axis], radius = 0.5 * disc.diameter;
  if (std::abs(off) >= radius) return std::nullopt;
  const double half = std::sqrt((radius - off) * (radius + off));
  return Interval{to_centre[line.axis] - half, to_centre[line.axis] + half};
}

std::vector<Interval> DiscImages::binder_on(const GridLine& line) const {
  constexpr double rounding = 1e-12;
  std::vector<Interval> chords;
  for (const auto image : near(line.at(0.5))) {
    const auto in_particle = chord(image, line);
    if (in_particle && in_particle->end > 0.0 && in_particle->begin < 1.0) chords.push_back(*in_particle);
  }
  std::ranges::sort(chords, {}, &Interval::begin);
  std::vector<Interval> binder;
  double covered = 0.0;
  for (const auto& in_particle : chords) {
    if (in_particle.begin > covered + rounding) binder.push_back({covered, in_particle.begin});
    covered = std::max(covered, in_particle.end);
  }
  if (covered < 1.0 - rounding) binder.push_back({covered, 1.0});
  return binder;
}

}  // namespace breccia::gaps
