#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "breccia/io/deck_setting.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// A key of a deck that takes several values.
struct SweptKey {
  std::string path;      ///< as in `--set`: `stages.*.packing.seed`
  std::string label;     ///< the last steps of it, as many as tell the keys apart
  bool is_seed = false;  ///< its values are samples of the same
};

/// A deck with one value for each swept key.
struct SweepTask {
  std::string name;                 ///< also that of its directory: `volumetric-averaged_seed-2`
  std::vector<std::string> labels;  ///< of each key with its value: the parts of the name
  std::vector<Scalar> values;       ///< of the keys
  Study study;

  /// Where its results go in a directory: the directory itself without a name.
  [[nodiscard]] std::filesystem::path directory_in(const std::filesystem::path& results) const {
    return name.empty() ? results : results / name;
  }
};

/// All combinations of the values of some keys, the last key running fastest. Without keys it is a single task, which
/// has no name.
struct Sweep {
  std::vector<SweptKey> keys;
  std::vector<SweepTask> tasks;
};

/// Reads a deck with overrides as read_study does, with its `[sweep]` and further keys `key.path=[value, ...]`. Throws
/// InputError with one line for every mistake in any task, and FileError.
Sweep read_sweep(const std::filesystem::path& deck, const std::vector<std::string>& overrides,
                 const std::vector<std::string>& further_keys);

}  // namespace breccia
