#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "breccia/microstructure/laguerre_sites.hpp"

namespace breccia {

/// Finds the site to which a point belongs. The box is divided into halves along all axes, and so are the parts, until
/// few sites can own a point in each part.
template <int dim>
class SiteTree {
 public:
  explicit SiteTree(const LaguerreSites<dim>& sites);

  struct Owner {
    std::uint32_t site;
    Vector<dim> point;  ///< the point relative to the nearest image of the site [m]
  };
  /// The site to which a point belongs.
  [[nodiscard]] Owner owner(const Vector<dim>& point) const;

 private:
  struct Candidate {  // a site or an image of it
    Vector<dim> position;
    double weight;
    std::uint32_t site;
  };
  struct Node {
    std::uint32_t first;  // number of the first candidate of a leaf, or of the first part of a divided node
    std::uint32_t count;  // number of candidates; 0 for a divided node
  };
  struct Part {
    Vector<dim> centre;
    double half_side;
    int depth;
  };

  void build(std::size_t node, const Part& part, const std::vector<Candidate>& candidates);
  [[nodiscard]] static double power(const Candidate& candidate, const Vector<dim>& point) noexcept;
  [[nodiscard]] static std::vector<Candidate> possible_owners(const Part& part,
                                                              const std::vector<Candidate>& candidates);

  double side_;
  Walls walls_;
  std::vector<Node> nodes_;
  std::vector<Candidate> candidates_;  // candidates of the leaves, one leaf after the other
};

}  // namespace breccia
