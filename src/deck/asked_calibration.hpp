#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "breccia/assessment/calibrate.hpp"
#include "breccia/homogenisation/responder.hpp"

#include "deck/asked_observations.hpp"

namespace breccia {

/// A calibration as a user asks for it.
struct AskedCalibration {
  /// The composites by their names, as far as they are known: no more than their reduced responses.
  std::vector<std::pair<std::string, Responder>> composites = {};
  AskedObservations measured = {};
  std::vector<std::string> unknowns = {};  ///< as read_unknown() takes them
  std::string stage = {};                  ///< the stage that was measured; empty: the last one
  std::optional<double> model_error = {};  ///< error of the moduli of the run [-]; nothing: as it states
  int samples = 0;                         ///< CalibrationOptions::samples
};

/// A calibration, and what it was made from.
struct FoundCalibration {
  std::vector<ObservedComposite> composites = {};
  std::vector<Observation> observations = {};
  Noise noise = Noise::relative;
  Calibration result = {};
  std::vector<std::string> notes = {};  ///< how data and runs were understood, where that is not plain
};

/// Reads the data and the unknowns, and finds the unknowns. An error of the model, stated or given, is taken as twice
/// its standard deviation. Throws InputError, with a line for each mistake in all files and unknowns, and as
/// calibrate().
FoundCalibration calibrate(const AskedCalibration& asked);

}  // namespace breccia
