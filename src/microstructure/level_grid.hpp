#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "breccia/microstructure/microstructure.hpp"

#include "microstructure/periodic_images.hpp"

namespace breccia {

/// Finds the balls near a point where balls have very different sizes: balls whose radii agree within a factor of two
/// are on one level, and each level has its own cells, about as large as its balls.
template <int dim>
class LevelGrid {
 public:
  using Image = typename PeriodicImages<dim>::Image;

  /// Makes an empty grid over the box [0, side]^dim for balls with these (positive) radii [m].
  LevelGrid(double side, Walls walls, std::span<const double> radii);

  [[nodiscard]] std::size_t levels() const noexcept { return levels_.size(); }
  /// The level of a ball: 0 for the largest.
  [[nodiscard]] std::size_t level(std::size_t ball) const noexcept { return level_of_ball_[ball]; }

  /// Puts a ball in the grid, its centre in the box.
  void insert(std::uint32_t ball, const Vector<dim>& centre);
  void remove(std::uint32_t ball);

  /// Calls visit(ball, image) for every ball of the grid whose surface is nearer than `reach` [m] to `centre`, and for
  /// some other balls. `centre` is in the box; in a periodic box the images next to the box are visited, too.
  template <class Visit>
  void visit_near(const Vector<dim>& centre, double reach, Visit&& visit) const;

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  struct Level {
    double radius = 0.0;      // radius of the largest ball [m]
    std::size_t members = 0;  // number of balls that belong to the level
    std::size_t present = 0;  // number of these balls that are in the grid
    std::int64_t cells = 1;   // cells per side
    std::size_t first = 0;    // first cell of this level
  };
  struct Links {  // links of a ball to the other balls of its cell
    std::size_t cell = 0;
    std::uint32_t previous = none;
    std::uint32_t next = none;
  };
  using Cell = std::array<std::int64_t, static_cast<std::size_t>(dim)>;

  [[nodiscard]] std::int64_t cell_along_axis(double coordinate, const Level& level) const noexcept {
    return static_cast<std::int64_t>(std::floor(coordinate / side_ * static_cast<double>(level.cells)));
  }
  template <class Visit>
  void visit_cell(const Cell& cell, const Level& level, Visit&& visit) const;

  double side_;
  Walls walls_;
  std::vector<Level> levels_;
  std::vector<std::size_t> level_of_ball_;
  std::vector<Links> links_;
  std::vector<std::uint32_t> head_;  // the first ball of each cell
};

template <int dim>
LevelGrid<dim>::LevelGrid(double side, Walls walls, std::span<const double> radii)
    : side_(side), walls_(walls), level_of_ball_(radii.size()), links_(radii.size()) {
  if (radii.empty()) return;
  const double largest = std::ranges::max(radii);
  const auto octave = [&](double radius) {
    return static_cast<std::size_t>(std::max(0.0, std::floor(std::log2(largest / radius))));
  };
  levels_.resize(octave(std::ranges::min(radii)) + 1);
  for (std::size_t ball = 0; ball < radii.size(); ++ball) {
    level_of_ball_[ball] = octave(radii[ball]);
    Level& level = levels_[level_of_ball_[ball]];
    level.radius = std::max(level.radius, radii[ball]);
    ++level.members;
  }
  std::size_t cells = 0;
  for (Level& level : levels_) {
    if (level.members == 0) continue;
    const double by_size = side / (2.0 * level.radius);
    const double by_number = std::pow(static_cast<double>(level.members), 1.0 / dim) + 1.0;
    level.cells = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::min(by_size, by_number)));
    level.first = cells;
    std::size_t of_level = 1;
    for (int d = 0; d < dim; ++d) of_level *= static_cast<std::size_t>(level.cells);
    cells += of_level;
  }
  head_.assign(cells, none);
}

template <int dim>
void LevelGrid<dim>::insert(std::uint32_t ball, const Vector<dim>& centre) {
  Level& level = levels_[level_of_ball_[ball]];
  std::int64_t cell = 0;
  for (const double coordinate : centre) {
    cell = cell * level.cells + std::clamp<std::int64_t>(cell_along_axis(coordinate, level), 0, level.cells - 1);
  }
  Links& links = links_[ball];
  links.cell = level.first + static_cast<std::size_t>(cell);
  links.previous = none;
  links.next = head_[links.cell];
  if (links.next != none) links_[links.next].previous = ball;
  head_[links.cell] = ball;
  ++level.present;
}

template <int dim>
void LevelGrid<dim>::remove(std::uint32_t ball) {
  const Links& links = links_[ball];
  if (links.next != none) links_[links.next].previous = links.previous;
  if (links.previous != none) {
    links_[links.previous].next = links.next;
  } else {
    head_[links.cell] = links.next;
  }
  --levels_[level_of_ball_[ball]].present;
}

template <int dim>
template <class Visit>
void LevelGrid<dim>::visit_near(const Vector<dim>& centre, double reach, Visit&& visit) const {
  for (const Level& level : levels_) {
    if (level.present == 0) continue;
    // in a periodic box the cells continue into the images; in a box with walls they end
    const std::int64_t lowest = walls_ == Walls::periodic ? -level.cells : 0;
    const std::int64_t highest = (walls_ == Walls::periodic ? 2 * level.cells : level.cells) - 1;
    Cell from;
    Cell to;
    for (std::size_t d = 0; d < centre.size(); ++d) {
      from[d] = std::clamp(cell_along_axis(centre[d] - reach - level.radius, level), lowest, highest);
      to[d] = std::clamp(cell_along_axis(centre[d] + reach + level.radius, level), lowest, highest);
    }
    Cell cell = from;
    for (std::size_t d = 0; d < cell.size();) {
      visit_cell(cell, level, visit);
      for (d = 0; d < cell.size() && ++cell[d] > to[d]; ++d) cell[d] = from[d];
    }
  }
}

template <int dim>
template <class Visit>
void LevelGrid<dim>::visit_cell(const Cell& cell, const Level& level, Visit&& visit) const {
  std::int64_t inside = 0;
  Image image = 0;
  Image digit = 1;
  for (const std::int64_t coordinate : cell) {
    const std::int64_t copy = coordinate < 0 ? 0 : (coordinate < level.cells ? 1 : 2);
    inside = inside * level.cells + coordinate - (copy - 1) * level.cells;
    image += digit * static_cast<Image>(copy);
    digit *= 3;
  }
  for (std::uint32_t ball = head_[level.first + static_cast<std::size_t>(inside)]; ball != none;
       ball = links_[ball].next) {
    visit(ball, image);
  }
}

}  // namespace breccia
