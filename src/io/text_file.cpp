#include "io/text_file.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <limits>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <xxhash.h>

#include "breccia/error.hpp"

#include "io/file_status.hpp"
#include "io/partial_name.hpp"

namespace breccia {
namespace {

std::string last_system_error() {
  return std::generic_category().message(errno);
}

/// Flushes a file or directory to the disk, so that after a power cut no name exists without its content.
void wait_for_disk(const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);  // NOLINT(cppcoreguidelines-pro-type-vararg)
  // Some file systems have no fsync for directories.
  const bool is_done = file >= 0 && (::fsync(file) == 0 || errno == EINVAL);
  const auto reason = last_system_error();
  if (file >= 0) ::close(file);
  if (!is_done) throw FileError(fmt::format("{}: cannot write: {}", path.string(), reason));
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path path)
    : path_(std::move(path)), temporary_(partial_name(path_.string(), ::getpid())) {}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)), temporary_(std::exchange(other.temporary_, {})) {}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  if (!temporary_.empty()) std::filesystem::remove(temporary_, ignored);
}

void AtomicFile::commit() {
  wait_for_disk(temporary_);
  std::error_code error;
  std::filesystem::rename(temporary_, path_, error);
  if (error) throw FileError(fmt::format("{}: cannot write: {}", path_.string(), error.message()));
  temporary_.clear();
  wait_for_disk(path_.has_parent_path() ? path_.parent_path() : std::filesystem::path("."));
}

std::string read_text(const std::filesystem::path& path) {
  if (std::filesystem::is_regular_file(status_of(path))) {
    return read_beginning(path, std::numeric_limits<std::size_t>::max());
  }
  // A pipe has no size, and a device such as /dev/zero no end.
  constexpr std::size_t most = std::size_t{1} << 28;
  auto text = read_beginning(path, most);
  if (text.size() == most) {
    throw FileError(
        fmt::format("{}: cannot read: it is no regular file, and does not end within 268 MB", path.string()));
  }
  return text;
}

std::string read_beginning(const std::filesystem::path& path, std::size_t most) {
  if (std::filesystem::is_directory(status_of(path))) {
    throw FileError(fmt::format("{}: cannot read: it is a directory", path.string()));
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError(fmt::format("{}: cannot read: {}", path.string(), last_system_error()));
  std::string text;
  std::array<char, 65536> piece{};
  while (file && text.size() < most) {
    file.read(piece.data(), static_cast<std::streamsize>(std::min(piece.size(), most - text.size())));
    text.append(piece.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (file.bad()) throw FileError(fmt::format("{}: cannot read: {}", path.string(), last_system_error()));
  return text;
}

void write_text(const std::filesystem::path& path, std::string_view text) {
  AtomicFile file(path);
  std::ofstream stream(file.temporary(), std::ios::binary);
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  stream.close();
  if (!stream) throw FileError(fmt::format("{}: cannot write: {}", path.string(), last_system_error()));
  file.commit();
}

void copy_result(const std::filesystem::path& from, const std::filesystem::path& to) {
  AtomicFile file(to);
  std::error_code error;
  std::filesystem::copy_file(from, file.temporary(), error);
  if (error) {
    throw FileError(fmt::format("{}: cannot copy it to {}: {}", from.string(), to.string(), error.message()));
  }
  file.commit();
}

void make_directory(const std::filesystem::path& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) throw FileError(fmt::format("{}: cannot make this directory: {}", directory.string(), error.message()));
}

void refuse_to_replace(const std::filesystem::path& directory, std::span<const std::string> names,
                       std::span<const std::filesystem::path> inputs) {
  std::string mistakes;
  for (const auto& name : names) {
    for (const auto& input : inputs) {
      std::error_code is_missing;
      if (!std::filesystem::equivalent(directory / name, input, is_missing)) continue;
      mistakes += fmt::format("{}{}: the results would replace this file, from which they come; take another directory",
                              mistakes.empty() ? "" : "\n", (directory / name).string());
    }
  }
  if (!mistakes.empty()) throw InputError(mistakes);
}

void remove_files(const std::filesystem::path& directory, std::span<const std::string> names) {
  for (const auto& name : names) {
    std::error_code error;
    std::filesystem::remove(directory / name, error);
    if (error) {
      throw FileError(fmt::format("{}: cannot remove this file: {}", (directory / name).string(), error.message()));
    }
  }
}

void remove_partial_files(const std::filesystem::path& directory,
                          const std::function<bool(std::string_view)>& is_known) {
  std::error_code is_missing;
  std::vector<std::string> names;
  std::filesystem::directory_iterator entry(directory, is_missing);
  for (; !is_missing && entry != std::filesystem::directory_iterator(); entry.increment(is_missing)) {
    auto name = entry->path().filename().string();
    const auto whole = whole_name(name);
    if (whole.empty() || !is_known(whole)) continue;
    // A link with such a name would cause a file elsewhere to be written.
    if (!std::filesystem::is_directory(entry->symlink_status(is_missing))) names.push_back(std::move(name));
  }
  remove_files(directory, names);
}

std::string content_hash(std::string_view bytes) {
  return fmt::format("{:016x}", XXH64(bytes.data(), bytes.size(), 0));
}

}  // namespace breccia
