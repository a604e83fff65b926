#include "results/checksums.hpp"

#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "checkpoint/checkpoint.hpp"
#include "io/seal.hpp"
#include "io/text_file.hpp"
#include "results/result_files.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

constexpr auto file_of_checksums = "checksums.txt";

/// The text between the hash and the name of a file in a line.
constexpr std::string_view gap = "  ";

/// Whether a file still has this hash.
bool is_unchanged(const fs::path& file, std::string_view hash) {
  std::error_code is_missing;
  return fs::is_regular_file(file, is_missing) && content_hash_of(file) == hash;
}

bool is_whole(const fs::path& checksums) {
  std::error_code is_missing;
  if (!fs::is_regular_file(checksums, is_missing)) return false;
  try {
    require_sealed(checksums);
    return true;
  } catch (const DamagedFile&) {
    return false;
  }
}

/// A file of the results and its hash when the list was written.
struct Checksum {
  std::string hash, name;
};

std::vector<Checksum> lines_of(const fs::path& checksums) {
  std::vector<Checksum> all;
  std::istringstream text(read_text(checksums));
  for (std::string line; std::getline(text, line);) {
    const auto end = line.find(gap);
    if (end == std::string::npos) continue;
    auto name = line.substr(end + gap.size());
    // The list may be from someone else: no file outside of the directory is read because of it.
    if (is_file_of_a_study(name)) all.push_back({line.substr(0, end), std::move(name)});
  }
  return all;
}

}  // namespace

void write_checksums(const fs::path& directory, const std::vector<std::string>& stages) {
  std::string text;
  for (const auto& name : study_files_in(directory, stages)) {
    if (name == file_of_checksums || is_checkpoint_file(name) || !fs::is_regular_file(directory / name)) continue;
    text += fmt::format("{}{}{}\n", content_hash_of(directory / name), gap, name);
  }
  write_text(directory / file_of_checksums, sealed(std::move(text)));
}

std::optional<std::vector<std::string>> damaged_files(const fs::path& directory) {
  const auto checksums = directory / file_of_checksums;
  std::error_code is_missing;
  if (!fs::exists(checksums, is_missing)) return std::nullopt;
  if (!is_whole(checksums)) return std::vector<std::string>{file_of_checksums};
  std::vector<std::string> damaged;
  for (const auto& [hash, name] : lines_of(checksums)) {
    if (!is_unchanged(directory / name, hash)) damaged.push_back(name);
  }
  return damaged;
}

std::vector<std::string> unchanged_files(const fs::path& directory) {
  const auto checksums = directory / file_of_checksums;
  std::vector<std::string> unchanged;
  if (!is_whole(checksums)) return unchanged;
  for (const auto& [hash, name] : lines_of(checksums)) {
    if (is_unchanged(directory / name, hash)) unchanged.push_back(name);
  }
  unchanged.emplace_back(file_of_checksums);
  return unchanged;
}

}  // namespace breccia
