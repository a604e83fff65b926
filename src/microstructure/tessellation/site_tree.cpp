#include "microstructure/tessellation/site_tree.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "microstructure/periodic_images.hpp"
#include "microstructure/vector_algebra.hpp"

namespace breccia {

namespace {

/// The largest number of sites left to compare at a point: twice the number that meet at a corner.
template <int dim>
constexpr std::size_t most_candidates = 2 * (dim + 1);
constexpr int deepest = 32;  // a tree is as deep as this only where more cells than that number meet at one point

}  // namespace

template <int dim>
SiteTree<dim>::SiteTree(const LaguerreSites<dim>& sites) : side_(sites.side), walls_(sites.walls), nodes_(1) {
  using Images = PeriodicImages<dim>;
  const Images images(side_);
  std::vector<Candidate> all;
  for (std::uint32_t site = 0; site < sites.sites.size(); ++site) {
    const auto& [position, weight] = sites.sites[site];
    for (typename Images::Image image = 0; image < Images::count; ++image) {
      if (walls_ == Walls::hard && image != Images::in_place) continue;
      all.push_back({position + images.shift(image), weight, site});
    }
  }
  Part box{{}, 0.5 * side_, 0};
  box.centre.fill(0.5 * side_);
  build(0, box, possible_owners(box, all));
}

template <int dim>
double SiteTree<dim>::power(const Candidate& candidate, const Vector<dim>& point) noexcept {
  const auto seen = point - candidate.position;
  return dot(seen, seen) - candidate.weight;
}

/// The candidates that may own a point in this part of the box. The difference of the powers q of two sites is linear,
/// q - q' = value at the centre + 2 (c' - c) . (x - centre), so at most value + 2 sum |c' - c| half_side in the part.
/// Where that is negative with the owner of the centre as c, the other site owns nothing in the part.
template <int dim>
auto SiteTree<dim>::possible_owners(const Part& part, const std::vector<Candidate>& candidates)
    -> std::vector<Candidate> {
  const auto power_at_centre = [&](const Candidate& candidate) { return power(candidate, part.centre); };
  const Candidate& owner = *std::ranges::min_element(candidates, {}, power_at_centre);
  const double power_of_owner = power_at_centre(owner);
  std::vector<Candidate> possible;
  std::ranges::copy_if(candidates, std::back_inserter(possible), [&](const Candidate& other) {
    double steepness = 0.0;
    for (const double x : other.position - owner.position) steepness += std::abs(x);
    return power_of_owner - power_at_centre(other) + 2.0 * steepness * part.half_side >= 0.0;
  });
  return possible;
}

template <int dim>
void SiteTree<dim>::build(std::size_t node, const Part& part, const std::vector<Candidate>& candidates) {
  if (candidates.size() <= most_candidates<dim> || part.depth == deepest) {
    nodes_[node] = {static_cast<std::uint32_t>(candidates_.size()), static_cast<std::uint32_t>(candidates.size())};
    candidates_.insert(candidates_.end(), candidates.begin(), candidates.end());
    return;
  }
  constexpr std::uint32_t parts = 1U << dim;
  const std::size_t first = nodes_.size();
  nodes_[node] = {static_cast<std::uint32_t>(first), 0};
  nodes_.resize(first + parts);
  // The bits say whether a part is the lower or the upper half along each axis.
  for (std::uint32_t sides = 0; sides < parts; ++sides) {
    Part half{part.centre, 0.5 * part.half_side, part.depth + 1};
    for (std::uint32_t axis = 0; axis < dim; ++axis) {
      half.centre[axis] += ((sides >> axis) & 1U) != 0 ? half.half_side : -half.half_side;
    }
    build(first + sides, half, possible_owners(half, candidates));
  }
}

template <int dim>
auto SiteTree<dim>::owner(const Vector<dim>& point) const -> Owner {
  Vector<dim> inside = point;
  for (double& x : inside) x = walls_ == Walls::periodic ? wrapped(x, side_) : std::clamp(x, 0.0, side_);
  Vector<dim> centre;
  centre.fill(0.5 * side_);
  const Node* node = nodes_.data();
  for (double quarter = 0.25 * side_; node->count == 0; quarter *= 0.5) {
    std::uint32_t part = node->first;
    for (std::uint32_t axis = 0; axis < dim; ++axis) {
      const bool is_above = inside[axis] >= centre[axis];
      part += static_cast<std::uint32_t>(is_above) << axis;
      centre[axis] += is_above ? quarter : -quarter;
    }
    node = &nodes_[part];
  }
  const std::span<const Candidate> candidates(&candidates_[node->first], node->count);
  const Candidate& nearest =
      *std::ranges::min_element(candidates, {}, [&](const Candidate& candidate) { return power(candidate, inside); });
  Owner owner{nearest.site, inside - nearest.position};
  if (walls_ == Walls::hard) owner.point = point - nearest.position;
  return owner;
}

template class SiteTree<2>;
template class SiteTree<3>;

}  // namespace breccia
