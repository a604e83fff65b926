#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <variant>
#include <vector>

#include "breccia/microstructure/microstructure.hpp"
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

/// Particles as listed in a file.
struct ExplicitPacking {
  std::filesystem::path file;
  std::vector<Disc> discs;
  Walls walls = Walls::hard;
};

using PackingMethod = std::variant<LubachevskyStillingerPacking, RegularPacking, ExplicitPacking>;

/// The form in which a deck gives the gap between particles.
enum class GapSource {
  length,         ///< a length
  diameter,       ///< a share of the smallest diameter
  default_share,  ///< not given: the default share of the smallest diameter
  points          ///< a number of material points, so that the gap depends on the grid
};

/// The particles of a stage. An explicit packing has no sizes; only a random packing drawn from sizes has a fraction.
struct Filler {
  Material material;
  std::optional<double> fraction = {};  ///< area fraction in the box [-]
  std::optional<double> smallest = {};  ///< sizes are cut below this diameter [m]
  std::optional<double> largest = {};   ///< sizes are cut above this diameter [m]
  std::optional<Sizes> sizes = {};
  double gap = 0.0;  ///< smallest distance between particles, and between a particle and a wall [m]
  GapSource gap_source = GapSource::length;
  PackingMethod packing = {};
};

}  // namespace breccia
