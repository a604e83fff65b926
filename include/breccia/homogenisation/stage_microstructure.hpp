#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "breccia/homogenisation/filler_statistics.hpp"
#include "breccia/microstructure/ellipsoid_box.hpp"
#include "breccia/microstructure/laguerre_sites.hpp"
#include "breccia/microstructure/packing.hpp"
#include "breccia/microstructure/particle_box.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

class Checkpoint;

/// Diameters [m] of discs of the areas of grains, or of cells, below which a share of their whole area is; in three
/// dimensions of balls of their volumes, and a share of the whole volume.
struct SizesByArea {
  double of_a_tenth = 0.0;
  double of_half = 0.0;
};

/// Grains that fill the box of a stage, parted by films of the matrix.
struct StageGrains {
  LaguerreSites<2> sites;  ///< in three dimensions the box alone
  double film = 0.0;       ///< thickness [m]
  std::size_t count = 0;   ///< grains that the films leave
  SizesByArea cells = {};  ///< grains with half of the films around them
  SizesByArea sizes = {};  ///< of the grains that the films leave
  /// Length of the films shorter than five times their thickness over that of all films [-]; 0 in three dimensions.
  double short_films = 0.0;
  std::optional<LaguerreSites<3>> sites_in_space = {};  ///< in a box of three dimensions

  /// Number of cells, with those of which the films leave nothing.
  [[nodiscard]] std::size_t cell_count() const {
    return sites_in_space ? sites_in_space->sites.size() : sites.sites.size();
  }
};

/// The particles or grains of a stage with their statistics. Pixels are those of its image (Stage::image).
struct StageMicrostructure {
  /// Without particles where there are grains, pixels, or others than discs.
  Microstructure<2> microstructure;
  std::optional<Microstructure<3>> spheres = {};  ///< in a box of three dimensions with nothing else
  std::optional<StageGrains> grains = {};         ///< in place of particles
  std::optional<ParticleBox> shaped = {};         ///< particles of which not all are discs, with their coatings
  std::optional<EllipsoidBox> ellipsoids = {};    ///< particles of which not all are spheres, with their coatings
  double fraction = 0.0;            ///< area of the particles per area of the box, or volume per volume [-]
  double interface_per_area = 0.0;  ///< length of the interface per area of the box, or area per volume [1/m]
  double wall_gap = 0.0;            ///< smallest gap of a coated particle to a hard wall [m]; infinite without either
  double gap = 0.0;                 ///< smallest gap between two coated particles, or film between grains [m]; infinite
                                    ///< without two particles
  std::vector<FillerStatistics> fillers = {};  ///< in the order of the stage
  std::uint64_t events = 0;                    ///< number of events of the packing
  double seconds = 0.0;                        ///< wall time of the packing [s]

  /// Number of particles, or of grains.
  [[nodiscard]] std::size_t particles() const;
  /// Diameter [m] of equal balls with the same volume and the same interface per volume of the box; infinite without
  /// an interface. Of a box of three dimensions.
  [[nodiscard]] double mean_diameter() const;
  /// Largest difference of the drawn and the wanted size distribution of a filler [-]; nothing where none was drawn.
  [[nodiscard]] std::optional<double> size_deviation() const;
};

/// Is called repeatedly with the progress of a packing.
using PackingFollower = std::function<void(const PackingProgress&)>;

/// Makes the microstructure of a stage: packs the particles of all its fillers together, arranges them regularly, or
/// takes them from its list or its image. With a checkpoint, an earlier state is resumed, and the state and finally the
/// result are saved; a random sequential packing, which takes seconds, begins anew and comes to the same bits. Throws
/// InputError when the sizes are invalid, or when particles of a list or a regular array overlap or leave the box;
/// NumericalError when the packing is impossible; Interrupted when the run shall end (CheckpointSchedule::stop).
StageMicrostructure make_microstructure(const Stage& stage, const PackingFollower& follow = {},
                                        Checkpoint* checkpoint = nullptr);

}  // namespace breccia
