#pragma once

#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "results/composite.hpp"

namespace breccia {

/// Two temperatures [K], rising.
struct TemperatureRange {
  double begin = 0.0;
  double end = 0.0;
};

/// The dynamic moduli of a composite at one temperature.
struct IsochronalSample {
  double temperature = 0.0;                          ///< [K]
  double log10_shift_factor = 0.0;                   ///< log10 a_T from the temperature of the study [-]
  std::complex<double> shear;                        ///< G' + i G'' [Pa]
  std::optional<std::complex<double>> young = {};    ///< E' + i E'' [Pa], where there was a bulk test
  std::optional<std::complex<double>> poisson = {};  ///< complex Poisson's ratio [-], where there was a bulk test
};

/// The temperatures at which the reduced angular frequency a_T omega is among the frequencies 1/t of the times of the
/// study. Throws InputError where the composite has no shift law, or where no temperature at which the law holds has
/// such a frequency.
TemperatureRange temperatures_covered(const Composite& composite, double omega);

/// The moduli at an angular frequency omega [rad/s] over the temperature, as an analyser (DMA) shows them: M*(omega, T)
/// = M*(a_T omega, T_0), where T_0 is the temperature of the study (theory, Eq. 28b). The samples are `step` [K] apart,
/// by default at the covered temperatures within 100 K of T_0, or at all covered temperatures where none is as close.
/// Throws InputError with all mistakes, also for temperatures that are not covered.
std::vector<IsochronalSample> isochronal_curve(const Composite& composite, double omega,
                                               const std::optional<TemperatureRange>& temperatures, double step);

/// The samples as a table, with comments on their origin.
std::string table_of(const std::vector<IsochronalSample>& samples, const Composite& composite, double omega);

}  // namespace breccia
