#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "breccia/microstructure/cubic_array.hpp"
#include "breccia/microstructure/grey_segmentation.hpp"
#include "breccia/microstructure/label_image.hpp"
#include "breccia/microstructure/laguerre_sites.hpp"
#include "breccia/microstructure/microstructure.hpp"
#include "breccia/microstructure/shaped_particles.hpp"
#include "breccia/words.hpp"

namespace breccia {

/// The packing methods of decks. Each method has a struct below, with its value as `name`.
enum class PackingName { lubachevsky_stillinger, regular, listed, laguerre, image, random_sequential };

template <>
inline constexpr auto words<PackingName> =
    std::to_array<Word<PackingName>>({{"lubachevsky-stillinger", PackingName::lubachevsky_stillinger},
                                      {"regular", PackingName::regular},
                                      {"explicit", PackingName::listed},
                                      {"laguerre", PackingName::laguerre},
                                      {"image", PackingName::image},
                                      {"random-sequential", PackingName::random_sequential}});

/// Event-driven growth of moving discs or spheres (Lubachevsky and Stillinger, J. Stat. Phys. 60, 561, 1990).
template <int dim>
struct LubachevskyStillingerPacking {
  Walls walls = Walls::hard;
  std::uint64_t seed = 1;

  static constexpr auto name = PackingName::lubachevsky_stillinger;
  static constexpr bool keeps_gaps = true;
};

/// Discs of one size in the centres of equal rectangles.
struct RegularPacking {
  int columns = 1;
  int rows = 1;

  static constexpr auto name = PackingName::regular;
  static constexpr auto walls = Walls::hard;
};

/// Balls of one size on a cubic lattice, periodic: particles may cross the sides of the box.
struct LatticePacking {
  Lattice lattice = Lattice::simple;
  int repeats = 1;  ///< conventional cells of the lattice along each side

  static constexpr auto name = PackingName::regular;
  static constexpr auto walls = Walls::periodic;
};

/// A list of discs or spheres, or of particles of other shapes.
template <int dim>
using ParticleList = std::variant<std::vector<Ball<dim>>, std::vector<ShapedParticle<dim>>>;

/// Particles as listed in a file.
template <int dim>
struct ExplicitPacking {
  std::filesystem::path file;
  ParticleList<dim> particles = {};
  Walls walls = Walls::hard;
  /// The number of the filler of each particle; empty where all are of the first.
  std::vector<std::size_t> fillers = {};

  static constexpr auto name = PackingName::listed;

  [[nodiscard]] std::size_t count() const {
    return std::visit([](const auto& listed) { return listed.size(); }, particles);
  }
};

/// Grains of a Laguerre tessellation, which fill the box except for films of the matrix between them.
template <int dim>
struct LaguerrePacking {
  Walls walls = Walls::periodic;
  WallFilm wall_film = WallFilm::half;  ///< film along hard walls
  std::uint64_t seed = 1;               ///< seed of a random tessellation
  /// Thickness of the films [m]; if absent, it follows from the fraction of the filler.
  std::optional<double> film = {};
  std::filesystem::path file = {};    ///< file of the sites; empty for a random tessellation
  std::vector<Site<dim>> sites = {};  ///< sites of the grains; none for a random tessellation
  /// Film shares of listed sites [-] (LaguerreSites); none for films of one thickness.
  std::vector<double> film_shares = {};

  static constexpr auto name = PackingName::laguerre;

  [[nodiscard]] bool is_random() const { return sites.empty(); }
};

/// The part of a picture that is used: the pixels left of it, above it and, in a stack, the layers below it, and its
/// own pixels along x, y and z.
struct PictureCrop {
  std::size_t left = 0, top = 0, lowest = 0;
  std::vector<std::size_t> extents = {};
};

/// The pixels of an image, or the voxels of a stack of images, in place of particles. The label 0 is that of the
/// matrix, the label k that of the filler k - 1 of the stage.
template <int dim>
struct ImagePacking {
  std::filesystem::path file;
  std::string array = {};       ///< data set of the file; empty if none was named
  SharedImage<dim> image = {};  ///< image that fills the box
  std::optional<PictureCrop> crop = {};
  std::optional<GreySegmentation> segmentation = {};  ///< of a grey picture

  static constexpr auto name = PackingName::image;
};

/// Particles of any shape placed at random one after the other, the largest first, and grown by a Monte Carlo
/// compression (RandomSequentialRun).
template <int dim>
struct RandomSequentialPacking {
  Walls walls = Walls::hard;
  std::uint64_t seed = 1;

  static constexpr auto name = PackingName::random_sequential;
  static constexpr bool keeps_gaps = true;
};

/// The packing method of a box of `dim` dimensions, with its settings.
template <int dim>
using PackingMethod =
    std::variant<LubachevskyStillingerPacking<dim>, std::conditional_t<dim == 2, RegularPacking, LatticePacking>,
                 ExplicitPacking<dim>, LaguerrePacking<dim>, ImagePacking<dim>, RandomSequentialPacking<dim>>;

/// The name of the elements of an image in this number of dimensions.
constexpr std::string_view name_of_pixels(int dimensions) {
  return dimensions == 3 ? "voxels" : "pixels";
}

/// The packing method of a box of two or of three dimensions, with its settings.
using StagePacking = std::variant<PackingMethod<2>, PackingMethod<3>>;

}  // namespace breccia
