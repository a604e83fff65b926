#pragma once

#include <filesystem>
#include <functional>
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

/// The names that results have in their directory.
struct ResultNames {
  std::string record;  ///< name of the file that identifies the results
  /// Returns whether this is the relative name of one of the files of the results.
  std::function<bool(std::string_view)> has = {};
};

/// Replaces files of a directory by the files of its subdirectory `unfinished`. `old_files` are relative to the
/// directory; missing ones are ignored. The old record is removed first, the new one is moved last. If the process is
/// killed meanwhile, finish_replacement() can complete the work from a list in the directory. Throws FileError before
/// any change if there is no new record, a new file would replace a file that is not one of `old_files`, or there is a
/// symbolic link in the path of a file; throws FileError also if a file cannot be removed or moved. The caller must
/// hold the DirectoryLock.
void replace_results(const std::filesystem::path& directory, std::span<const std::string> old_files,
                     const ResultNames& names);

/// Completes a replacement that was interrupted; does nothing if there is none. Removes and moves only files with names
/// of the results, and none behind a symbolic link. Throws FileError before any change where there are
/// mistakes_of_replacement(). The caller must hold the DirectoryLock.
void finish_replacement(const std::filesystem::path& directory, const ResultNames& names);

/// The reasons, one line each, why a replacement must not be completed: it was not begun by these results, or a
/// symbolic link below the directory leads elsewhere. Empty if there is no replacement.
std::vector<std::string> mistakes_of_replacement(const std::filesystem::path& directory, const ResultNames& names);

/// The files that an interrupted replacement still removes from the directory or moves into it, relative to it.
std::vector<std::string> files_of_replacement(const std::filesystem::path& directory, const ResultNames& names);

/// One line for each symbolic link that the relative names have in their paths below a directory. A directory of
/// results may be a link itself, but links below it may have been made by someone else.
std::vector<std::string> mistakes_of_links(const std::filesystem::path& directory, std::span<const std::string> names);

/// The directory of results whose `unfinished` is this directory or contains it; nothing for all other directories. Its
/// DirectoryLock covers `unfinished`, too.
std::optional<std::filesystem::path> results_with_unfinished(const std::filesystem::path& directory);

/// Whether this is the name of a list that a replacement writes to `unfinished`.
bool is_replacement_list(std::string_view name);

/// Whether the directory has a replacement that was begun and is not complete. Throws FileError.
bool is_being_replaced(const std::filesystem::path& directory);

/// The files in `unfinished`, relative to it, without the lists of a replacement and half-written files
/// (is_partial_name). Changes nothing.
std::vector<std::string> unfinished_files(const std::filesystem::path& directory);

}  // namespace breccia
