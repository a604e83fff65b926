#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "breccia/assessment/observation.hpp"
#include "breccia/tables/modulus_kind.hpp"

#include "io/collected_mistakes.hpp"

namespace breccia {

/// Measured values of a composite.
struct AskedData {
  std::size_t composite = 0;  ///< index of the composite
  std::filesystem::path file;
};

/// Measured values as a user gives them.
struct AskedObservations {
  std::vector<AskedData> data = {};
  ModulusKind modulus = ModulusKind::unspecified;  ///< kind of modulus, where a file does not say it
  std::optional<double> noise = {};                ///< standard deviation of the data [-]; nothing: as they scatter
};

/// Reads the files. Adds a note where the kind of modulus is not plain, and collects the mistakes of all files.
std::vector<Observation> read_observations(const AskedObservations& asked, std::vector<std::string>& notes,
                                           CollectedMistakes& mistakes);

}  // namespace breccia
