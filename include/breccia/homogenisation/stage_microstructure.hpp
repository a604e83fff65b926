#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "breccia/microstructure/packing.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

class Checkpoint;

/// The particles of a stage with their statistics.
struct StageMicrostructure {
  Microstructure<2> microstructure;
  double fraction = 0.0;                 ///< area of the particles per area of the box [-]
  double interface_per_area = 0.0;       ///< length of the interface per area of the box, S/A [1/m]
  double wall_gap = 0.0;                 ///< smallest gap of a particle to a hard wall [m]; infinite without either
  double gap = 0.0;                      ///< smallest gap between two particles [m]; infinite without two particles
  std::optional<double> size_deviation;  ///< largest difference of the drawn and the wanted size distribution [-]
  std::uint64_t events = 0;              ///< number of events of the packing
  double seconds = 0.0;                  ///< wall time of the packing [s]
};

/// Is called repeatedly with the progress of a packing.
using PackingFollower = std::function<void(const PackingProgress&)>;

/// Makes the microstructure of a stage: packs its particles, arranges them regularly, or takes them from its list. With
/// a checkpoint, an earlier state is resumed, and the state and finally the result are saved.
/// Throws InputError when the sizes are invalid, or when particles of a list or a regular array overlap or leave the
/// box; NumericalError when the packing is impossible; Interrupted when the run shall end (CheckpointSchedule::stop).
StageMicrostructure make_microstructure(const Stage& stage, const PackingFollower& follow = {},
                                        Checkpoint* checkpoint = nullptr);

}  // namespace breccia
