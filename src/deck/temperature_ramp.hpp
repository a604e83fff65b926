#pragma once

#include <filesystem>
#include <span>

#include "deck/fit_data.hpp"

namespace breccia {

/// Frequency sweeps of a measurement in which the temperature rises (or falls) while the frequencies alternate. The
/// sweeps are at whole multiples of 1, 2, 5, 10 or 20 degrees Celsius, at most 50 of them, in the range of temperatures
/// that all frequencies have in common. The logarithms of the moduli of a frequency are interpolated linearly between
/// its temperatures, where these are at most 6 K apart; of rows at one temperature the first counts. All arrays have a
/// value for each row, in the order of the file: temperatures [K], angular frequencies [rad/s], storage and loss moduli
/// [Pa], all positive. Frequencies within 2 % of each other count as one, their mean; a frequency with a single row is
/// left out. Throws InputError, with the path of the file, if the temperature of a frequency rises and falls, or if
/// fewer than two frequencies have fewer than two temperatures in common.
DynamicData sweeps_of_ramp(const std::filesystem::path& path, std::span<const double> temperatures,
                           std::span<const double> frequencies, std::span<const double> storage,
                           std::span<const double> loss);

}  // namespace breccia
