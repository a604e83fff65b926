#pragma once

#include <filesystem>

namespace breccia {

/// Removes a directory at the end of a run if it is empty.
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

/// Removes a directory at the end of a run if nothing is in it, or only the record of a study without any packing.
class RemoveWithoutResult {
 public:
  explicit RemoveWithoutResult(std::filesystem::path directory);
  RemoveWithoutResult(const RemoveWithoutResult&) = delete;
  RemoveWithoutResult& operator=(const RemoveWithoutResult&) = delete;
  RemoveWithoutResult(RemoveWithoutResult&&) = delete;
  RemoveWithoutResult& operator=(RemoveWithoutResult&&) = delete;
  ~RemoveWithoutResult();

 private:
  std::filesystem::path directory_;
};

}  // namespace breccia
