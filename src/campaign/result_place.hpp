#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "breccia/study/study.hpp"

#include "campaign/remove_if_empty.hpp"
#include "io/directory_lock.hpp"

namespace breccia {

/// The directory of a study's results, locked by this group of processes, and the place in it where they are written
/// until they are complete. The destructor removes both if they have no result.
class ResultPlace {
 public:
  /// `choose` returns the place, or throws InputError; the first process of a group calls it for all of them.
  ResultPlace(const Study& study, std::filesystem::path directory,
              const std::function<std::filesystem::path()>& choose);

  [[nodiscard]] const std::filesystem::path& directory() const noexcept { return directory_; }
  [[nodiscard]] const std::filesystem::path& place() const noexcept { return place_; }
  /// Replaces earlier results by the new ones, if there are any. Throws FileError.
  void commit() const;

 private:
  const Study& study_;
  std::filesystem::path directory_;
  std::optional<DirectoryLock> lock_;
  std::filesystem::path place_;
  RemoveWithoutResult directory_without_result_, place_without_result_;
};

}  // namespace breccia
