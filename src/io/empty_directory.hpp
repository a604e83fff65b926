#pragma once

#include <filesystem>
#include <span>

namespace breccia {

/// Whether the path does not exist or is an empty directory.
bool is_missing_or_empty(const std::filesystem::path& directory) noexcept;

/// Removes a directory if it is empty. Keeps a symbolic link to a directory, and ignores a failure to remove.
void remove_if_empty(const std::filesystem::path& directory) noexcept;

/// Removes those of several directories that are empty, in their order.
void remove_if_empty(std::span<const std::filesystem::path> directories) noexcept;

}  // namespace breccia
