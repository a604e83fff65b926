#pragma once

#include <filesystem>
#include <string>

namespace breccia::cli {

/// Asks the desktop to show an address in the browser, from a page in a directory that no other user can read: they see
/// the arguments of every program, in which the address would stand. Does nothing where there is no desktop.
void show_in_browser(const std::string& address, const std::filesystem::path& private_directory);

}  // namespace breccia::cli
