#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <variant>
#include <vector>

#include "breccia/microstructure/cubic_array.hpp"
#include "breccia/microstructure/ellipsoid.hpp"
#include "breccia/microstructure/laguerre_sites.hpp"
#include "breccia/microstructure/microstructure.hpp"
#include "breccia/microstructure/particle.hpp"
#include "breccia/study/image_packing.hpp"
#include "breccia/viscoelasticity/material.hpp"

namespace breccia {

/// All particles of one diameter [m].
struct SingleSize {
  double diameter;
};

/// Exactly these particles: diameters [m].
struct ListedSizes {
  std::vector<double> diameters;
};

/// A mixture of lognormal distributions of the diameter, weighted by volume.
struct LognormalSizes {
  struct Component {
    double weight;  ///< share of the volume [-]; the weights add up to 1
    double median;  ///< diameter that halves the volume [m]
    double sigma;   ///< standard deviation of the logarithm of the diameter [-]
  };
  std::vector<Component> components;
};

/// A table of the volume-weighted distribution of the diameter.
struct TabulatedSizes {
  std::filesystem::path file;
  std::vector<double> diameters;                    ///< rising [m]
  std::vector<double> cumulative_volume_fractions;  ///< not falling, from 0 up to 1 [-]
};

using Sizes = std::variant<SingleSize, ListedSizes, LognormalSizes, TabulatedSizes>;

/// Ellipses; in three dimensions ellipsoids of revolution.
struct EllipticOutline {
  double aspect = 1.0;  ///< first axis over the second one, or the axis of revolution over the others [-]
};

/// Convex polygons, all similar to one.
struct PolygonalOutline {
  std::filesystem::path file;
  std::vector<Vector<2>> corners;  ///< in any unit: the size follows from the diameter of equal area
};

/// Shape of the particles of a filler, whose sizes are diameters of discs of equal area, or of balls of equal volume.
struct FillerShape {
  std::variant<EllipticOutline, PolygonalOutline> outline;
  std::optional<double> angle = {};  ///< of all particles [rad]; without it, and in space, each is turned at random
};

/// Event-driven growth of moving particles (Lubachevsky and Stillinger, J. Stat. Phys. 60, 561, 1990).
struct LubachevskyStillingerPacking {
  Walls walls = Walls::hard;
  std::uint64_t seed = 1;
};

/// Particles of one size in the centres of equal rectangles.
struct RegularPacking {
  int columns = 1;
  int rows = 1;
};

/// Balls of one size on a cubic lattice, periodic: particles may cross the sides of the box.
struct LatticePacking {
  Lattice lattice = Lattice::simple;
  int repeats = 1;  ///< conventional cells of the lattice along each side
};

/// Particles as listed in a file.
struct ExplicitPacking {
  std::filesystem::path file;
  std::vector<Disc> discs;
  Walls walls = Walls::hard;
  /// The number of the filler of each disc, sphere or other particle; empty where all are of the first.
  std::vector<std::size_t> fillers = {};
  std::vector<Particle> particles = {};    ///< of other shapes, in place of discs
  std::vector<Ball<3>> spheres = {};       ///< of a box of three dimensions, in place of discs
  std::vector<Ellipsoid> ellipsoids = {};  ///< of a box of three dimensions, in place of spheres
};

/// Particles of any shape placed at random one after the other, the largest first, and grown by a Monte Carlo
/// compression (RandomSequentialRun).
struct RandomSequentialPacking {
  Walls walls = Walls::hard;
  std::uint64_t seed = 1;
};

/// Grains of a Laguerre tessellation, which fill the box but for films of the matrix of one thickness between them.
struct LaguerrePacking {
  Walls walls = Walls::periodic;
  WallFilm wall_film = WallFilm::half;       ///< along hard walls
  std::uint64_t seed = 1;                    ///< of a random tessellation
  std::optional<double> film = {};           ///< thickness [m]; without it that of the fraction of the filler
  std::filesystem::path file = {};           ///< of the sites; empty for a random tessellation
  std::vector<Site<2>> sites = {};           ///< of the grains; none for a random tessellation
  std::vector<Site<3>> sites_in_space = {};  ///< the same in a box of three dimensions
  std::vector<double> film_shares = {};      ///< of listed sites [-] (LaguerreSites); none for films of one thickness

  [[nodiscard]] bool is_random() const { return site_count() == 0; }
  [[nodiscard]] std::size_t site_count() const { return sites.size() + sites_in_space.size(); }
  /// The sites in a box of so many dimensions.
  template <int dim>
  [[nodiscard]] const std::vector<Site<dim>>& sites_in() const {
    if constexpr (dim == 3) {
      return sites_in_space;
    } else {
      return sites;
    }
  }
};

using PackingMethod = std::variant<LubachevskyStillingerPacking, RegularPacking, ExplicitPacking, LaguerrePacking,
                                   ImagePacking, RandomSequentialPacking, LatticePacking>;

/// The form in which a deck gives the gap between particles.
enum class GapSource {
  length,         ///< a length
  diameter,       ///< a share of the smallest diameter
  default_share,  ///< not given: the default share of the smallest diameter
  points          ///< a number of material points, so that the gap depends on the grid
};

/// A layer of another material around each particle (an interphase), outside its diameter.
struct Coating {
  Material material;
  double thickness = 0.0;  ///< [m]
};

/// Particles of one kind in a stage. With an explicit packing a filler has no sizes; only one that is drawn from sizes
/// for a random packing has a fraction.
struct Filler {
  Material material;
  /// Share of the area of the box, or of its volume, that the particles fill without their coatings [-].
  std::optional<double> fraction = {};
  std::optional<double> smallest = {};  ///< sizes are cut below this diameter [m]
  std::optional<double> largest = {};   ///< sizes are cut above this diameter [m]
  std::optional<Sizes> sizes = {};
  double gap = 0.0;  ///< smallest distance between coated particles of this filler [m]
  GapSource gap_source = GapSource::length;
  std::optional<Coating> coating = {};
  std::optional<FillerShape> shape = {};  ///< of its particles; discs or spheres without one

  /// Thickness of the coating [m]; 0 where there is none.
  [[nodiscard]] double coating_thickness() const { return coating ? coating->thickness : 0.0; }
};

}  // namespace breccia
