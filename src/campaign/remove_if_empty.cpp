#include "remove_if_empty.hpp"

#include <cstddef>
#include <system_error>
#include <utility>

#include "breccia/io/empty_directory.hpp"
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
  std::error_code is_missing;
  // A directory with nothing but a record has no result.
  if (count_entries(directory_) == 1) fs::remove(directory_ / "study.json", is_missing);
  remove_if_empty(directory_);
}

}  // namespace breccia
