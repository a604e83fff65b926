#include "remove_if_empty.hpp"

#include <cstddef>
#include <system_error>
#include <utility>

#include "breccia/parallel/session.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

/// The number of entries of a directory; 0 where it cannot be read.
std::size_t count_entries(const fs::path& directory) noexcept {
  std::size_t count = 0;
  std::error_code error;
  for (fs::directory_iterator entry(directory, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    ++count;
  }
  return error ? 0 : count;
}

}  // namespace

RemoveIfEmpty::RemoveIfEmpty(fs::path directory) : directory_(std::move(directory)) {}

RemoveIfEmpty::~RemoveIfEmpty() {
  if (parallel::rank() != 0) return;
  std::error_code is_not_empty;
  // A record alone tells of no result.
  if (count_entries(directory_) == 1) fs::remove(directory_ / "study.json", is_not_empty);
  fs::remove(directory_, is_not_empty);
}

}  // namespace breccia
