#pragma once

#include <filesystem>
#include <span>

namespace breccia {

/// Is nothing at this path, or a directory with nothing in it?
bool is_missing_or_empty(const std::filesystem::path& directory) noexcept;

/// Removes a directory if it is empty. A symbolic link to a directory stays, and what cannot be removed stays.
void remove_if_empty(const std::filesystem::path& directory) noexcept;

/// The same for several directories, in their order.
void remove_if_empty(std::span<const std::filesystem::path> directories) noexcept;

}  // namespace breccia
