#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "breccia/homogenisation/box.hpp"
#include "breccia/homogenisation/filler_statistics.hpp"
#include "breccia/microstructure/packing.hpp"
#include "breccia/nested_variant.hpp"
#include "breccia/progress.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

class Checkpoint;

/// The box of a stage with its content, and statistics of the content.
struct StageMicrostructure {
  std::variant<Box<2>, Box<3>> box = {};
  double fraction = 0.0;            ///< area of the particles per area of the box, or volume per volume [-]
  double interface_per_area = 0.0;  ///< length of the interface per area of the box, or area per volume [1/m]
  double wall_gap = 0.0;            ///< smallest gap of a coated particle to a hard wall [m]; infinite without either
  double gap = 0.0;                 ///< smallest gap between two coated particles, or film between grains [m]; infinite
                                    ///< without two particles
  std::vector<FillerStatistics> fillers = {};  ///< statistics of the fillers, in the order of the stage
  /// The square of the sum of the particles' volumes over the sum of their squares (areas in two dimensions): the
  /// number of equal particles, less where some are far larger than others; 0 for an image.
  double effective_particles = 0.0;
  std::uint64_t events = 0;  ///< number of events of the packing
  double seconds = 0.0;      ///< wall time of the packing [s]

  /// The content of the box, if it is of this type, such as Microstructure<2>; nullptr otherwise.
  template <class Content>
  [[nodiscard]] const Content* content() const {
    return find_alternative<Content>(box);
  }
  /// The statistics of the grains that fill the box; nullptr for any other content.
  [[nodiscard]] const GrainStatistics* grains() const;
  /// Number of particles, or of grains that the films leave; 0 for an image.
  [[nodiscard]] std::size_t particles() const;
  /// Diameter [m] of equal balls with the same volume and the same interface per volume of the box, or of equal discs
  /// in two dimensions; infinite without an interface.
  [[nodiscard]] double mean_diameter() const;
  /// Largest difference between the drawn and the wanted size distribution of a filler [-]; nothing where no sizes were
  /// drawn.
  [[nodiscard]] std::optional<double> size_deviation() const;
};

/// Makes the microstructure of a stage: packs the particles of all its fillers together, arranges them regularly, or
/// takes them from its list or its image. With a checkpoint, an earlier state is resumed, and the state and finally the
/// result are saved; a random sequential packing, which takes seconds, begins anew, with bitwise identical results.
/// Throws InputError when the sizes are invalid, or when particles of a list or a regular array overlap or leave the
/// box; NumericalError when the packing is impossible; Interrupted when the run shall end (CheckpointSchedule::stop).
StageMicrostructure make_microstructure(const Stage& stage, const ProgressObserver& follow = {},
                                        Checkpoint* checkpoint = nullptr);

}  // namespace breccia
