#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "breccia/deckfile/deck_setting.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// A key of a deck that takes several values.
struct SweptKey {
  std::string path;      ///< path of the key, as in `--set`: `stages.*.packing.seed`
  std::string label;     ///< the last steps of the path, as many as are needed to distinguish the keys
  bool is_seed = false;  ///< true for seeds, whose values give samples of the same microstructure
};

/// A deck with one value for each swept key.
struct SweepTask {
  std::string name;                 ///< name of the task and of its directory: `volumetric-averaged_seed-2`
  std::vector<std::string> labels;  ///< parts of the name, one for each key, which contain its value
  std::vector<Scalar> values;       ///< values of the swept keys, one for each key
  Study study;

  /// The directory of the task's results within that of the sweep; the same directory for a task without a name.
  [[nodiscard]] std::filesystem::path directory_in(const std::filesystem::path& results) const {
    return name.empty() ? results : results / name;
  }
};

/// All combinations of the values of the swept keys, the last key running fastest. A sweep without keys has one task,
/// without a name.
struct Sweep {
  std::vector<SweptKey> keys;
  std::vector<SweepTask> tasks;
  std::vector<std::string> overrides = {};  ///< overrides of all tasks, `key.path=value`, without the swept values
};

}  // namespace breccia
