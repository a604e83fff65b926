#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// The name of the file with the history of a time domain: `<load>-<boundary>-dynamic-<cells>-<number>.h5`. Time
/// domains are numbered from 1.
std::string history_file(std::string_view load, std::string_view boundary, int cells, std::size_t number);

/// Whether this is the name of a file with a history.
bool is_history(std::string_view name);

/// Writes the history of one time domain to the directory of its stage (docs/results.md). Throws FileError.
void write_history(const std::filesystem::path& directory, const Study& study, const Stage& stage, const TestId& test,
                   std::size_t number, const TimeDomain& domain);

/// Writes the histories of all dynamic tests of a stage. Throws FileError.
void write_histories(const std::filesystem::path& directory, const Study& study, const Stage& stage,
                     const std::vector<TestResult>& tests);

/// A history from a file.
struct StoredHistory {
  std::string deck_hash;
  std::vector<double> times;   ///< times since the middle of the ramp [s]
  std::vector<double> values;  ///< modulus [Pa], or compliance under a traction boundary [1/Pa]
};

/// Reads a history. Throws FileError when the file cannot be read or does not have the format of write_history().
StoredHistory read_history(const std::filesystem::path& file);

/// A history with fewer samples that looks the same on a linear and on a logarithmic time axis: the smallest and the
/// largest value in each of many short intervals of time.
StoredHistory outline_of(const StoredHistory& history);

}  // namespace breccia
