#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "breccia/microstructure/index.hpp"
#include "breccia/microstructure/tessellation.hpp"
#include "breccia/microstructure/vector.hpp"

namespace breccia {

// Instantiated for 2 and 3 dimensions. In 2D the area of a face is a length.

/// The face between the cells of two sites, which may be one site and an image of it.
template <int dim>
struct CellFace {
  std::size_t first = 0, second = 0;  ///< numbers of the sites, from 0
  Index<dim> image{};                 ///< sides of the box by which the second site is displaced

  friend bool operator<(const CellFace& one, const CellFace& other) {
    return std::tie(one.first, one.second, one.image) < std::tie(other.first, other.second, other.image);
  }
};

/// A face between cells with its shape.
template <int dim>
struct MeasuredFace {
  CellFace<dim> face = {};
  Vector<dim> normal{};  ///< from the first site to the second, of length 1 [-]
  double area = 0.0;     ///< [m^(dim - 1)]
};

/// All faces between the cells of a tessellation, each once.
template <int dim>
[[nodiscard]] std::vector<MeasuredFace<dim>> measured_faces(const Tessellation<dim>& tessellation);

/// Some of the faces between the cells of a tessellation, each once.
template <int dim>
struct CellFaces {
  std::vector<CellFace<dim>> faces;
  double share = 0.0;  ///< share of the area of all faces between cells [-]
};

/// Faces taken at random, by a seed, until their share of the area is as close to the wanted one as the next face
/// allows. Throws InputError unless the share is from 0 to 1.
template <int dim>
[[nodiscard]] CellFaces<dim> random_faces(const Tessellation<dim>& tessellation, double share, std::uint64_t seed);

/// As random_faces(), but the faces whose normals are closest to a direction of any length are taken first. Throws
/// InputError unless the share is from 0 to 1 and the direction has a length.
template <int dim>
[[nodiscard]] CellFaces<dim> faces_across(const Tessellation<dim>& tessellation, double share,
                                          const Vector<dim>& direction);

/// Two sites between which a face is taken: that to the image of the second one which is displaced by so many sides of
/// the box along each axis or, without a displacement, those to all of its images.
struct SitePair {
  std::array<std::size_t, 2> sites{};  ///< numbers from 0
  std::vector<int> image = {};
};

/// The text of a pair: "3-17", or "3-17:0,-1" with an image.
[[nodiscard]] std::string name_of(const SitePair& pair);

/// The faces between the cells of these pairs of sites, each once. Throws InputError that lists the pairs without a
/// face, and the sites that there are not.
template <int dim>
[[nodiscard]] CellFaces<dim> faces_of_pairs(const Tessellation<dim>& tessellation, std::span<const SitePair> pairs);

}  // namespace breccia
