#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "breccia/campaign/run.hpp"

#include "campaign/complete_run.hpp"
#include "campaign/earlier_results.hpp"
#include "io/directory_lock.hpp"

namespace breccia {

/// The work of one run or packing on the directory of a study's results: it locks the directory, decides whether
/// earlier results are kept, resumed or replaced, and replaces them when the new ones are complete. If there are
/// earlier results to keep until then, the new ones are written to the subdirectory `unfinished`. The earlier records
/// are read once.
///
/// Where several processes share the study, all of them call these functions, and a failure of one process is thrown on
/// all of them.
class ResultTransaction {
 public:
  /// Locks the directory, unless it is missing or empty, and reads the earlier results. Changes nothing. Throws
  /// DirectoryInUse where another process writes to it, and FileError. The study must outlive this object.
  ResultTransaction(const Study& study, std::filesystem::path directory, RunOptions options);
  ResultTransaction(const ResultTransaction&) = delete;
  ResultTransaction& operator=(const ResultTransaction&) = delete;
  ResultTransaction(ResultTransaction&&) = delete;
  ResultTransaction& operator=(ResultTransaction&&) = delete;
  /// Removes directories in which the run has left no result.
  ~ResultTransaction();

  [[nodiscard]] const Study& study() const noexcept { return *earlier_.study; }
  [[nodiscard]] const Provenance& provenance() const noexcept { return earlier_.provenance; }
  [[nodiscard]] const RunOptions& options() const noexcept { return options_; }
  [[nodiscard]] const std::filesystem::path& directory() const noexcept { return earlier_.directory; }

  /// Returns the run that has left complete results of this study, its data files and this version of Breccia, if there
  /// is one; no run needs to compute them again. If that run was killed after its last test, the function first
  /// completes its work: it puts the results in their place, writes the page and the checksums, and removes checkpoints
  /// and half-written files. Results of which a file other than the page is missing or has changed since
  /// (results/checksums.hpp) are not taken; the page is written anew. If the checksums themselves are missing, they are
  /// written anew where the other files can be read. Throws FileError.
  [[nodiscard]] CompleteRun take_over();

  /// Chooses the place of the results. Throws ConflictingResults with the conflicts_with() the earlier results before
  /// any change; then completes a replacement that was interrupted. A run that starts anew removes the files of an
  /// earlier one that has finished nothing. Throws DirectoryInUse and FileError.
  void begin_run();
  /// As begin_run(), but for packing without tests, which never removes finished tests of the same study.
  void begin_packing();

  /// The directory to which the results are written from begin_run() or begin_packing() to commit().
  [[nodiscard]] const std::filesystem::path& place() const noexcept { return place_; }
  /// Whether the work is resumed from the results and checkpoints of an earlier run in place().
  [[nodiscard]] bool resumes() const noexcept { return resumes_; }
  /// Whether the earlier results in place() are kept and have finished tests.
  [[nodiscard]] bool keeps_tests() const noexcept { return keeps_tests_; }

  /// Replaces earlier results by the new ones, unless these were written to their directory. Throws FileError.
  void commit();

 private:
  void open();
  void begin(const std::function<bool()>& is_resumed);
  CompleteRun taken_over();
  [[nodiscard]] CompleteRun taken_over_unchecked() const;
  void complete_replacement();
  void keep_earlier();
  void make_way();
  void replace_earlier() const;
  void remove_unfinished() const;

  RunOptions options_;
  std::optional<DirectoryLock> lock_;  ///< the lock is held by the first process alone
  EarlierResults earlier_;             ///< the results are read by the first process alone
  std::filesystem::path place_;
  bool resumes_ = false, keeps_tests_ = false;
};

}  // namespace breccia
