#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
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
};

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

/// All faces between the cells of each of these pairs of sites. Throws InputError that lists the pairs without a face.
template <int dim>
[[nodiscard]] CellFaces<dim> faces_of_pairs(const Tessellation<dim>& tessellation,
                                            std::span<const std::array<std::size_t, 2>> pairs);

}  // namespace breccia
