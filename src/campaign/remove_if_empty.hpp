#pragma once

#include <filesystem>

namespace breccia {

/// Removes a directory at the end of a run if the run has left no result in it.
class RemoveIfEmpty {
 public:
  explicit RemoveIfEmpty(std::filesystem::path directory);
  RemoveIfEmpty(const RemoveIfEmpty&) = delete;
  RemoveIfEmpty& operator=(const RemoveIfEmpty&) = delete;
  RemoveIfEmpty(RemoveIfEmpty&&) = delete;
  RemoveIfEmpty& operator=(RemoveIfEmpty&&) = delete;
  ~RemoveIfEmpty();

 private:
  std::filesystem::path directory_;
};

}  // namespace breccia
