#include "breccia/io/text_file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>
#include <xxhash.h>

#include "breccia/error.hpp"

namespace breccia {

namespace {

constexpr auto partial = ".partial";

std::string last_system_error() {
  return std::generic_category().message(errno);
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path path)
    : path_(std::move(path)), temporary_(fmt::format("{}.{}{}", path_.string(), ::getpid(), partial)) {}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)), temporary_(std::exchange(other.temporary_, {})) {}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  if (!temporary_.empty()) std::filesystem::remove(temporary_, ignored);
}

void AtomicFile::commit() {
  std::error_code error;
  std::filesystem::rename(temporary_, path_, error);
  if (error) throw FileError(fmt::format("{}: cannot write: {}", path_.string(), error.message()));
  temporary_.clear();
}

std::string read_text(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) {
    throw FileError(fmt::format("{}: cannot read: it is a directory", path.string()));
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError(fmt::format("{}: cannot read: {}", path.string(), last_system_error()));
  std::string text(std::istreambuf_iterator<char>(file), {});
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

void remove_partial_files(const std::filesystem::path& directory) {
  std::error_code is_missing;
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(directory, is_missing)) {
    if (entry.path().extension() == partial) names.push_back(entry.path().filename().string());
  }
  remove_files(directory, names);
}

std::string content_hash(std::string_view bytes) {
  return fmt::format("{:016x}", XXH64(bytes.data(), bytes.size(), 0));
}

}  // namespace breccia
