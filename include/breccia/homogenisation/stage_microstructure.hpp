#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "breccia/microstructure/packing.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

class Checkpoint;

/// The particles of a stage, and how well they are what the deck asks for.
struct StageMicrostructure {
  Microstructure<2> microstructure;
  double fraction = 0.0;                 ///< area of the particles per area of the box [-]
  double interface_per_area = 0.0;       ///< S/A [1/m]
  double wall_gap = 0.0;                 ///< smallest between a particle and a hard wall [m]; infinite without either
  double gap = 0.0;                      ///< smallest between surfaces [m]; infinite without two particles
  std::optional<double> size_deviation;  ///< largest between the size distributions drawn and asked for, by area [-]
  std::uint64_t events = 0;              ///< of the packing
  double seconds = 0.0;                  ///< wall time of the packing
};

/// Told now and then how far a packing has come.
using PackingFollower = std::function<void(const PackingProgress&)>;

/// Packs, arranges or takes over the particles of a stage. With a checkpoint it goes on from there, leaves its state
/// there, and in the end its result.
/// Throws InputError when the particles cannot be where the deck puts them, NumericalError when the packing is
/// impossible, Interrupted when the checkpoint says that the run is to end.
StageMicrostructure make_microstructure(const Stage& stage, const PackingFollower& follow = {},
                                        Checkpoint* checkpoint = nullptr);

}  // namespace breccia
