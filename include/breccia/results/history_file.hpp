#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// `<load>-<boundary>-dynamic-<cells>-<number>.h5`, the name of the file of a history; number is that of its time
/// domain, from 1.
std::string history_file(std::string_view load, std::string_view boundary, int cells, std::size_t number);

/// Is this the name of such a file?
bool is_history(std::string_view name);

/// Writes the history of one time domain to the directory of its stage (docs/results.md).
void write_history(const std::filesystem::path& directory, const Study& study, const Stage& stage, const TestId& test,
                   std::size_t number, const TimeDomain& domain);

/// Writes the histories of all dynamic tests of a stage.
void write_histories(const std::filesystem::path& directory, const Study& study, const Stage& stage,
                     const std::vector<TestResult>& tests);

/// A history as it was written.
struct StoredHistory {
  std::string deck_hash;
  std::vector<double> times;   ///< since the middle of the ramp [s]
  std::vector<double> values;  ///< modulus [Pa], or compliance under a traction boundary [1/Pa]
};

/// Throws FileError when the file cannot be read or is not as write_history writes it.
StoredHistory read_history(const std::filesystem::path& file);

/// A history with few samples that looks the same on a linear and on a logarithmic axis of time: the smallest and the
/// largest value of each short part of the time.
StoredHistory outline_of(const StoredHistory& history);

}  // namespace breccia
