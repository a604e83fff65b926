#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace breccia {

/// Subdirectory of a results directory to which a run writes results that will replace earlier ones. When the new
/// results are complete, the earlier files are removed and the new files are moved to the results directory. So a run
/// that fails, is killed or fills the disk leaves the earlier results unchanged.
inline constexpr std::string_view unfinished_directory = "unfinished";

/// Replaces files of a directory by all files of its subdirectory `unfinished`. `old_files` are relative to the
/// directory; missing ones are ignored. `record` is the file that identifies the results: the old one is removed first,
/// the new one is moved last. If the process is killed meanwhile, finish_replacement() can complete the work from the
/// list that remains. Throws FileError before any change if there is no new record or a new file would replace a file
/// that is not one of `old_files`; throws FileError also if a file cannot be removed or moved. The caller must hold the
/// DirectoryLock.
void replace_results(const std::filesystem::path& directory, std::span<const std::string> old_files,
                     const std::string& record);

/// Completes a replacement that was interrupted; does nothing if there is none. The caller must hold the DirectoryLock.
/// Throws FileError.
void finish_replacement(const std::filesystem::path& directory);

/// The directory of results whose `unfinished` is this directory or contains it; nothing for all others. Its
/// DirectoryLock covers `unfinished`, too.
std::optional<std::filesystem::path> results_with_unfinished(const std::filesystem::path& directory);

/// Whether this is the name of a list that a replacement leaves in `unfinished`.
bool is_replacement_list(std::string_view name);

/// Whether the directory has a replacement that was begun and is not complete. Throws FileError.
bool is_being_replaced(const std::filesystem::path& directory);

/// The files in `unfinished`, relative to it, without the lists of a replacement and half-written files
/// (is_partial_name). Changes nothing.
std::vector<std::string> unfinished_files(const std::filesystem::path& directory);

}  // namespace breccia
