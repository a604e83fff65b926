#pragma once

#include <string>

namespace breccia::cli {

/// A temperature other than that of a run.
struct AskedTemperature {
  double kelvin;
  std::string name;       ///< "-40 degC"
  std::string directory;  ///< "respond-minus40degC"
};

/// Reads "-40 degC". Throws InputError.
AskedTemperature read_temperature(const std::string& text);

}  // namespace breccia::cli
