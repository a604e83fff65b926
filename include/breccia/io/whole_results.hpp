#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "breccia/error.hpp"
#include "breccia/io/directory_lock.hpp"

namespace breccia {

/// A directory that results are to be written to holds something else. The message has the problem and what helps.
class ForeignResults : public InputError {
 public:
  /// What helps: another directory, or ResultsOrigin::overwrite too.
  enum class Remedy { another_directory, overwriting };

  ForeignResults(const std::string& problem, Remedy remedy);
  [[nodiscard]] const std::string& problem() const noexcept { return problem_; }
  [[nodiscard]] Remedy remedy() const noexcept { return remedy_; }

 private:
  std::string problem_;
  Remedy remedy_;
};

/// Results that a command makes in one go, with a record of what they come from.
struct ResultsOrigin {
  std::string command;             ///< "fit": the record is `fit.json`
  std::string source;              ///< what they come from, in words: the name of a file, say
  std::string identity;            ///< what tells one source from another
  std::vector<std::string> files;  ///< names of all files that the command may write
  bool overwrite = false;          ///< may results from another source be replaced?
};

/// Results of a command on their way to a directory. They are written to `place` and put into the directory by commit,
/// in the place of what the command has written there before; without commit nothing of them is left. The directory is
/// locked meanwhile.
class WholeResults {
 public:
  /// Throws ForeignResults where the directory holds the results of a study or a sweep, files of these names that
  /// Breccia did not write, or results from another source that are not to be overwritten, and DirectoryInUse where
  /// another process writes to it. Throws FileError.
  WholeResults(std::filesystem::path directory, ResultsOrigin origin);
  WholeResults(const WholeResults&) = delete;
  WholeResults& operator=(const WholeResults&) = delete;
  WholeResults(WholeResults&&) = delete;
  WholeResults& operator=(WholeResults&&) = delete;
  ~WholeResults();

  /// Where the files are to be written.
  [[nodiscard]] const std::filesystem::path& place() const noexcept { return place_; }

  /// Throws FileError.
  void commit();

 private:
  [[nodiscard]] std::string record_name() const { return origin_.command + ".json"; }
  void refuse_others() const;
  void refuse_directories() const;
  void refuse_foreign_unfinished() const;
  void write_record() const;

  DirectoryLock lock_;
  std::filesystem::path directory_;
  ResultsOrigin origin_;
  std::filesystem::path place_;
};

}  // namespace breccia
