#pragma once

#include <filesystem>
#include <optional>
#include <variant>
#include <vector>

#include "breccia/microstructure/size_laws.hpp"
#include "breccia/microstructure/vector.hpp"
#include "breccia/study/crystal.hpp"
#include "breccia/viscoelasticity/material.hpp"

namespace breccia {

/// All particles of one diameter [m].
struct SingleSize {
  double diameter;
};

/// The diameters of all particles of a filler, as a list [m].
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

/// A table of the volume-weighted distribution of the diameter, linear in the logarithm of the diameter between its
/// rows.
struct TabulatedSizes {
  std::filesystem::path file;                       ///< empty for a table in the deck
  std::vector<double> diameters;                    ///< rising [m]
  std::vector<double> cumulative_volume_fractions;  ///< not falling, from 0 up to 1 [-]
};

using Sizes = std::variant<SingleSize, ListedSizes, LognormalSizes, TabulatedSizes, FullerSizes, RosinRammlerSizes,
                           QuantileSizes>;

/// Ellipses; in three dimensions ellipsoids of revolution.
struct EllipticOutline {
  double aspect = 1.0;  ///< first axis over the second one, or the axis of revolution over the other axes [-]
};

/// Convex polygons, all similar to one.
struct PolygonalOutline {
  std::filesystem::path file;
  std::vector<Vector<2>> corners;  ///< corners in any unit: the size follows from the diameter of equal area
};

/// Shape of the particles of a filler, whose sizes are diameters of discs of equal area, or of balls of equal volume.
struct FillerShape {
  std::variant<EllipticOutline, PolygonalOutline> outline;
  /// Angle of all particles [rad]; without it, and in three dimensions, each is turned at random.
  std::optional<double> angle = {};
};

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

/// Particles of one kind in a stage. With an explicit packing a filler has no sizes. Only a filler that is drawn from
/// sizes for a random packing has a fraction.
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
  std::optional<FillerShape> shape = {};  ///< shape of the particles; discs or spheres if absent
  /// Particles or grains that are crystals, one each; the material has Hill's means of their constants.
  std::optional<Crystal> crystal = {};

  /// Thickness of the coating [m]; 0 where there is none.
  [[nodiscard]] double coating_thickness() const { return coating ? coating->thickness : 0.0; }
};

}  // namespace breccia
