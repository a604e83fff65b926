#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/homogenisation/responder.hpp"
#include "breccia/words.hpp"

namespace breccia {

/// The modulus of an isotropic composite that was measured.
enum class ObservedModulus {
  shear,  ///< G
  young,  ///< E
  bulk,   ///< K
  p_wave  ///< K + 4 G / 3, of a longitudinal wave
};

template <>
inline constexpr auto words<ObservedModulus> = std::to_array<Word<ObservedModulus>>({{"shear", ObservedModulus::shear},
                                                                                     {"young", ObservedModulus::young},
                                                                                     {"bulk", ObservedModulus::bulk},
                                                                                     {"p-wave",
                                                                                      ObservedModulus::p_wave}});

/// What was measured of a modulus.
enum class ObservedCurve {
  relaxation,     ///< the relaxation modulus at a time [Pa]
  creep,          ///< the creep compliance at a time [1/Pa]
  constant_rate,  ///< stress over strain at a time under a constant strain rate [Pa]
  storage,        ///< the storage modulus at an angular frequency [Pa]
  loss,           ///< the loss modulus at an angular frequency [Pa]
  absolute,       ///< the absolute value of the complex modulus at an angular frequency [Pa]
  phase           ///< the phase of the complex modulus at an angular frequency [rad]
};

template <>
inline constexpr auto words<ObservedCurve> =
    std::to_array<Word<ObservedCurve>>({{"relaxation", ObservedCurve::relaxation},
                                        {"creep", ObservedCurve::creep},
                                        {"constant-rate", ObservedCurve::constant_rate},
                                        {"storage", ObservedCurve::storage},
                                        {"loss", ObservedCurve::loss},
                                        {"absolute", ObservedCurve::absolute},
                                        {"phase", ObservedCurve::phase}});

/// Whether a curve is one over the angular frequency, and not over time.
bool is_over_frequency(ObservedCurve curve);

/// A measured value of a composite.
struct Observation {
  std::size_t composite = 0;  ///< index of the composite
  ObservedModulus modulus = ObservedModulus::shear;
  ObservedCurve curve = ObservedCurve::relaxation;
  double at = 0.0;  ///< time [s] or angular frequency [rad/s]
  /// Temperature [K]; nothing for that of the study.
  std::optional<double> temperature = {};
  double value = 0.0;  ///< in the unit of the curve, positive
  /// Standard deviation of the measurement, relative to the value [-]; of a phase [rad].
  double deviation = 0.0;
};

/// A composite that was measured: a stage of a solved study.
struct ObservedComposite {
  std::string name;
  Responder responder;
  std::string stage;
  Boundary boundary = Boundary::periodic;
  /// Relative standard deviation of the factor by which the composite differs from its model at all times, from grid
  /// and sample [-]; 0 where the model is taken as exact.
  double model_deviation = 0.0;
};

}  // namespace breccia
