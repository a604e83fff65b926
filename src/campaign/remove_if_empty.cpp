#include "campaign/remove_if_empty.hpp"

#include <cstddef>
#include <exception>
#include <system_error>
#include <utility>

#include "io/empty_directory.hpp"
#include "parallel/session.hpp"
#include "results/study_record.hpp"

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

/// Whether the directory has nothing but the record of a study of which nothing is packed. A record that cannot be read
/// is not known to be one.
bool has_only_a_record(const fs::path& directory) noexcept {
  if (count_entries(directory) != 1) return false;
  try {
    const auto record = read_study_record(directory);
    return record.is_ours && record.stages_packed.empty();
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace

RemoveIfEmpty::RemoveIfEmpty(fs::path directory) : directory_(std::move(directory)) {}

RemoveIfEmpty::~RemoveIfEmpty() {
  if (parallel::rank() == 0) remove_if_empty(directory_);
}

RemoveWithoutResult::RemoveWithoutResult(fs::path directory) : directory_(std::move(directory)) {}

RemoveWithoutResult::~RemoveWithoutResult() {
  if (parallel::rank() != 0) return;
  std::error_code is_missing;
  if (has_only_a_record(directory_)) fs::remove(directory_ / "study.json", is_missing);
  remove_if_empty(directory_);
}

}  // namespace breccia
