#include "breccia/io/empty_directory.hpp"

#include <unistd.h>

namespace breccia {

void remove_if_empty(const std::filesystem::path& directory) noexcept {
  // Unlike std::filesystem::remove this refuses files and symbolic links.
  static_cast<void>(::rmdir(directory.c_str()));
}

void remove_if_empty(std::span<const std::filesystem::path> directories) noexcept {
  for (const auto& directory : directories) remove_if_empty(directory);
}

}  // namespace breccia
