#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/conflicting_results.hpp"
#include "io/directory_lock.hpp"
#include "io/replacement.hpp"

namespace breccia {

/// The command and the source of results that a single command computes at once, such as `fit`.
struct ResultsOrigin {
  std::string command;             ///< "fit", for example: the record of the results is then `fit.json`
  std::string source;              ///< a description of the source, such as the name of a file
  std::string identity;            ///< text that distinguishes sources, such as a hash
  std::vector<std::string> files;  ///< names of all files that the command may write
  bool overwrite = false;          ///< whether results from another source may be replaced
};

/// Writes the results of a command (ResultsOrigin) to a directory. The files are written to place(); commit() moves
/// them into the directory and removes the earlier results of the command. Without commit() no file is left. The
/// directory is locked during the lifetime of this object.
class WholeResults {
 public:
  /// Throws ConflictingResults where the directory is in `unfinished` or has the results of a study or a sweep, files
  /// of these names that Breccia did not write, or results from another source that are not to be overwritten;
  /// DirectoryInUse where another process writes to it; FileError where a file cannot be read or written.
  WholeResults(std::filesystem::path directory, ResultsOrigin origin);
  WholeResults(const WholeResults&) = delete;
  WholeResults& operator=(const WholeResults&) = delete;
  WholeResults(WholeResults&&) = delete;
  WholeResults& operator=(WholeResults&&) = delete;
  ~WholeResults();

  /// The directory to write the files to.
  [[nodiscard]] const std::filesystem::path& place() const noexcept { return place_; }

  /// Moves the files into the directory of the results. Throws FileError.
  void commit();

 private:
  [[nodiscard]] std::string record_name() const { return origin_.command + ".json"; }
  [[nodiscard]] bool is_own_file(std::string_view name) const;
  [[nodiscard]] ResultNames names() const;
  /// Refuses symbolic links below the directory, through which files elsewhere would be replaced.
  void refuse_links() const;
  void refuse_others() const;
  void refuse_directories() const;
  void refuse_foreign_unfinished() const;
  void write_record() const;
  /// Removes the files of this command, and their directory if it is empty then.
  void remove_place() const noexcept;

  DirectoryLock lock_;
  std::filesystem::path directory_;
  ResultsOrigin origin_;
  std::filesystem::path place_;
};

}  // namespace breccia
