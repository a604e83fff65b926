#include "io/seal.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <fstream>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <xxhash.h>

#include "breccia/error.hpp"

#include "io/text_file.hpp"

namespace breccia {
namespace {

/// The beginning of the line. An HDF5 file can be sealed, too, since HDF5 ignores bytes beyond the end that its header
/// gives.
constexpr std::string_view mark = "\nbreccia seal, xxh64 of all above: ";
constexpr std::size_t hash_digits = 16;
constexpr std::size_t seal_length = mark.size() + hash_digits + 1;

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view what) {
  throw FileError(fmt::format("{}: {}", path.string(), what));
}

[[noreturn]] void fail_as_damaged(const std::filesystem::path& path, std::string_view how) {
  throw DamagedFile(fmt::format("{}: {}", path.string(), how));
}

[[noreturn]] void fail_by_system(const std::filesystem::path& path, std::string_view action) {
  fail(path, fmt::format("cannot {}: {}", action, std::generic_category().message(errno)));
}

/// Hash of the first bytes of a file.
std::string hash_of(const std::filesystem::path& path, std::uintmax_t bytes) {
  const std::unique_ptr<XXH64_state_t, decltype(&XXH64_freeState)> state(XXH64_createState(), XXH64_freeState);
  if (!state) throw std::bad_alloc();
  XXH64_reset(state.get(), 0);
  std::ifstream file(path, std::ios::binary);
  constexpr std::size_t portion = std::size_t{1} << 20U;
  std::vector<char> buffer(portion);
  while (bytes > 0) {
    const auto wanted = std::min<std::uintmax_t>(bytes, portion);
    if (!file.read(buffer.data(), static_cast<std::streamsize>(wanted))) fail_by_system(path, "read");
    XXH64_update(state.get(), buffer.data(), wanted);
    bytes -= wanted;
  }
  return fmt::format("{:0{}x}", XXH64_digest(state.get()), hash_digits);
}

std::uintmax_t size_of(const std::filesystem::path& path) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  if (error) fail(path, fmt::format("cannot read: {}", error.message()));
  return size;
}

/// The last bytes of a file, as many as a seal has; empty if the file has fewer.
std::string end_of(const std::filesystem::path& path) {
  const auto size = size_of(path);
  if (size < seal_length) return {};
  std::ifstream file(path, std::ios::binary);
  std::string end(seal_length, ' ');
  file.seekg(static_cast<std::streamoff>(size - seal_length));
  if (!file.read(end.data(), static_cast<std::streamsize>(end.size()))) fail_by_system(path, "read");
  return end;
}

bool is_seal(std::string_view end) {
  return end.starts_with(mark) && end.ends_with('\n');
}

}  // namespace

std::string content_hash_of(const std::filesystem::path& path) {
  return hash_of(path, size_of(path));
}

void seal(const std::filesystem::path& path) {
  const auto hash = content_hash_of(path);
  std::ofstream file(path, std::ios::binary | std::ios::app);
  file << mark << hash << '\n';
  file.close();
  if (!file) fail_by_system(path, "write");
}

std::string sealed(std::string text) {
  const auto hash = content_hash(text);
  return text.append(mark).append(hash).append("\n");
}

bool is_sealed(const std::filesystem::path& path) {
  return is_seal(end_of(path));
}

void require_sealed(const std::filesystem::path& path) {
  const auto end = end_of(path);
  if (!is_seal(end)) fail_as_damaged(path, "torn, or no checkpoint of Breccia");
  if (end.substr(mark.size(), hash_digits) != hash_of(path, size_of(path) - seal_length))
    fail_as_damaged(path, "damaged: wrong checksum");
}

}  // namespace breccia
