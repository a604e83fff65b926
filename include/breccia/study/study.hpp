#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "breccia/microstructure/microstructure.hpp"
#include "breccia/virtual_test/curve.hpp"
#include "breccia/virtual_test/quasistatic_test.hpp"
#include "breccia/virtual_test/virtual_test.hpp"
#include "breccia/viscoelasticity/material.hpp"
#include "breccia/viscoelasticity/temperature_shift.hpp"

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
  std::vector<double> cumulative_volume_fractions;  ///< not falling, from 0..1 up to 1 [-]
};

using Sizes = std::variant<SingleSize, ListedSizes, LognormalSizes, TabulatedSizes>;

/// Event-driven growth of moving particles (Lubachevsky and Stillinger, J. Stat. Phys. 60, 561, 1990).
struct LubachevskyStillingerPacking {
  Walls walls = Walls::hard;
  std::uint64_t seed = 1;
};

/// Particles of one size in the middle of equal rectangles.
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

/// What a deck has derived the gap between particles from.
enum class GapSource {
  length,         ///< a length
  diameter,       ///< a share of the smallest diameter
  default_share,  ///< the share of the smallest diameter that holds where the deck says nothing
  points          ///< a number of material points, so that the gap follows the grid
};

/// The particles of a stage. An explicit packing has no sizes; only a random packing drawn from sizes has a fraction.
struct Filler {
  Material material;
  std::optional<double> fraction;  ///< share of the box [-]
  std::optional<double> smallest;  ///< sizes are cut below this diameter [m]
  std::optional<double> largest;   ///< sizes are cut above this diameter [m]
  std::optional<Sizes> sizes;
  double gap = 0.0;  ///< smallest distance between particles, and between a particle and a wall [m]
  GapSource gap_source = GapSource::length;
  PackingMethod packing;
};

/// An earlier stage, by name, whose result serves as a material.
struct EarlierStage {
  std::string name;
};

/// What lies between the particles of a stage.
using StageMatrix = std::variant<Material, EarlierStage>;

/// A microstructure to be tested.
struct Stage {
  std::string name;  ///< also that of its directory
  StageMatrix matrix;
  double side = 0.0;                    ///< of the square box [m]
  int cells = 0;                        ///< per side; of the finest grid where there are several
  std::vector<int> coarser_cells = {};  ///< per side of the coarser grids from which curves are extrapolated, rising
  std::optional<Filler> filler;
  std::vector<std::string> warnings = {};  ///< what is doubtful in the deck itself, without the name of the stage

  /// Side of a cell [m].
  [[nodiscard]] double cell_size() const { return side / cells; }
};

/// What a test says of the modulus.
enum class Bound {
  upper,    ///< displacement boundary and relaxation
  lower,    ///< traction boundary and creep
  periodic  ///< periodic boundary and relaxation: between the two
};

/// How a test is computed.
enum class Method {
  quasistatic,  ///< implicit, without inertia
  dynamic       ///< explicit material point method
};

/// The virtual tests of every stage.
struct Tests {
  std::vector<Load> loads{Load::shear};
  std::vector<Bound> bounds{Bound::upper, Bound::lower};
  std::vector<Method> methods{Method::quasistatic};
  double first_time = 0.0;  ///< [s]
  double last_time = 0.0;   ///< [s]
  int points_per_decade = 20;
  std::vector<double> field_times = {};  ///< at which the fields of the first load are left, rising [s]
  /// Largest relative deviation that the fit of a stage's result may have where a later stage builds on it [-].
  double fit_tolerance = 0.03;
  QuasistaticOptions quasistatic;
  DynamicOptions dynamic;
};

/// A shear relaxation modulus that was measured, to be compared with that of a stage.
struct Measurement {
  std::string label;
  std::string stage;                       ///< the name of the one that stands for what was measured
  std::variant<PronySeries, Curve> shear;  ///< [Pa]
  std::optional<TimeWindow> times = {};    ///< in which it holds [s]

  /// The times [s] in a window at which it tells the modulus; nothing where the two have none in common.
  [[nodiscard]] std::optional<TimeWindow> known_within(const TimeWindow& window) const;
  /// Measured modulus [Pa] at one of them; between the points of a curve a power of time.
  [[nodiscard]] double at(double time) const;
};

/// A deck with everything resolved, in SI units.
struct Study {
  std::string title;
  std::filesystem::path deck;
  std::string deck_text;
  std::vector<std::filesystem::path> inputs;  ///< the deck, and the data files that it names
  std::vector<std::string> overrides;         ///< `key.path=value`
  std::string hash;                           ///< of what the deck says, overrides included, and the data files
  /// Of each stage the hash of all that its results may depend on: the deck up to this stage, but for title and
  /// measurements, the data files, and the loads that the stage is tested under.
  std::vector<std::string> stage_hashes;
  std::vector<Material> materials;  ///< in the order of the deck
  /// By the names of the materials that have one; their relaxation times are shifted already.
  std::map<std::string, TemperatureShift> temperature_shifts;
  std::vector<Stage> stages;
  Tests tests;
  std::vector<Measurement> measurements;
};

}  // namespace breccia
