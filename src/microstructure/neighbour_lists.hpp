#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "breccia/microstructure/microstructure.hpp"

#include "microstructure/level_grid.hpp"
#include "microstructure/periodic_images.hpp"
#include "microstructure/vector_algebra.hpp"

namespace breccia {

/// Lists of the balls that a ball may touch. Every ball has a domain, a larger ball around the point where its list was
/// made (its anchor); its neighbours are the balls whose domains overlap its own. The lists stay valid until a ball
/// leaves its domain, and then only the lists with this ball change (Donev, Torquato, Stillinger 2005).
template <int dim>
class NeighbourLists {
 public:
  using Image = typename PeriodicImages<dim>::Image;
  struct Neighbour {
    std::uint32_t ball;
    Image image;  // the image of the neighbour
  };

  /// Makes all lists. `anchors` are in the box; `domains` are the radii of the domains [m].
  NeighbourLists(double side, Walls walls, std::vector<Vector<dim>> anchors, std::vector<double> domains);

  [[nodiscard]] std::span<const Neighbour> of(std::size_t ball) const noexcept { return lists_[ball]; }
  [[nodiscard]] const Vector<dim>& anchor(std::size_t ball) const noexcept { return anchors_[ball]; }

  /// Moves the domain of one ball to a new anchor, in the box.
  void move(std::uint32_t ball, const Vector<dim>& anchor);

 private:
  void insert(std::uint32_t ball);

  PeriodicImages<dim> images_;
  std::vector<Vector<dim>> anchors_;
  std::vector<double> domains_;
  LevelGrid<dim> grid_;
  std::vector<std::vector<Neighbour>> lists_;
};

template <int dim>
NeighbourLists<dim>::NeighbourLists(double side, Walls walls, std::vector<Vector<dim>> anchors,
                                    std::vector<double> domains)
    : images_(side),
      anchors_(std::move(anchors)),
      domains_(std::move(domains)),
      grid_(side, walls, domains_),
      lists_(anchors_.size()) {
  // Large balls come first: a ball then searches only among larger ones, which are few.
  std::vector<std::uint32_t> order(anchors_.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {}, [this](std::uint32_t ball) { return grid_.level(ball); });
  for (const std::uint32_t ball : order) insert(ball);
}

template <int dim>
void NeighbourLists<dim>::move(std::uint32_t ball, const Vector<dim>& anchor) {
  for (const auto& [other, image] : lists_[ball]) {
    auto& list = lists_[other];
    const auto here = std::ranges::find_if(list, [&, image = image](const Neighbour& neighbour) {
      return neighbour.ball == ball && neighbour.image == PeriodicImages<dim>::opposite(image);
    });
    *here = list.back();
    list.pop_back();
  }
  lists_[ball].clear();
  grid_.remove(ball);
  anchors_[ball] = anchor;
  insert(ball);
}

template <int dim>
void NeighbourLists<dim>::insert(std::uint32_t ball) {
  const Vector<dim>& anchor = anchors_[ball];
  grid_.visit_near(anchor, domains_[ball], [&](std::uint32_t other, Image image) {
    const auto apart = anchors_[other] + images_.shift(image) - anchor;
    const double reach = domains_[ball] + domains_[other];
    if (dot(apart, apart) >= reach * reach) return;
    lists_[ball].push_back({other, image});
    lists_[other].push_back({ball, PeriodicImages<dim>::opposite(image)});
  });
  grid_.insert(ball, anchor);
}

}  // namespace breccia
