#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace breccia {

/// Results that take the place of earlier ones are written beside them, to this subdirectory of theirs. Only when they
/// are whole are the earlier files removed and the new ones moved into their place. So a run that fails, is killed or
/// fills the disk leaves the earlier results as they were.
inline constexpr std::string_view unfinished_directory = "unfinished";

/// Replaces files of a directory by all files of its subdirectory `unfinished`. `old_files` are named relative to the
/// directory; those that are missing do not matter. `record` is the file by which the results are known: the old one is
/// removed first, the new one is moved last. A process that is killed on the way leaves a list from which
/// finish_replacement goes on. Throws FileError, with nothing touched, where there is no new record, or a new file
/// would replace one that is not among the old ones; and where a file cannot be removed or moved. Only the holder of a
/// DirectoryLock may call it.
void replace_results(const std::filesystem::path& directory, std::span<const std::string> old_files,
                     const std::string& record);

/// Brings a replacement to its end that was cut off; does nothing where there is none. Only the holder of a
/// DirectoryLock may call it. Throws FileError.
void finish_replacement(const std::filesystem::path& directory);

/// Has a replacement begun that has not come to its end?
bool is_being_replaced(const std::filesystem::path& directory);

/// The files in `unfinished`, relative to it, but for the lists of a replacement and half-written files
/// (is_partial_name). Touches nothing.
std::vector<std::string> unfinished_files(const std::filesystem::path& directory);

}  // namespace breccia
