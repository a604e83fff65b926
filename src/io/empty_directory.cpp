#include "io/empty_directory.hpp"

#include <system_error>

#include <unistd.h>

namespace breccia {

bool is_missing_or_empty(const std::filesystem::path& directory) noexcept {
  std::error_code error;
  if (!std::filesystem::exists(directory, error)) return !error;
  return std::filesystem::is_directory(directory, error) && std::filesystem::is_empty(directory, error) && !error;
}

void remove_if_empty(const std::filesystem::path& directory) noexcept {
  // Unlike std::filesystem::remove this refuses files and symbolic links.
  static_cast<void>(::rmdir(directory.c_str()));
}

void remove_if_empty(std::span<const std::filesystem::path> directories) noexcept {
  for (const auto& directory : directories) remove_if_empty(directory);
}

}  // namespace breccia
