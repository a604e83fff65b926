#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "studio/command_runner.hpp"
#include "studio/folder.hpp"
#include "studio/private_directory.hpp"
#include "studio/running_study.hpp"
#include "studio/session_json.hpp"

namespace breccia::studio {

/// Where a session of the studio has what it works with.
struct Places {
  std::filesystem::path program = {};   ///< of `breccia`
  std::filesystem::path examples = {};  ///< the decks that came with it
  std::filesystem::path folder = {};    ///< in which the user works
  std::string opened = {};              ///< name of a deck in the folder that is to be shown; empty: none
  /// Address of results, relative to the page or absolute, below which "files/..." is: "../TOKEN/".
  std::string results_at = {};
};

/// What the page of the studio can ask for: each function takes the JSON object of a request and returns that of its
/// answer (docs/studio.md). All throw InputError for a request that cannot be met. For several threads.
class Session {
 public:
  explicit Session(const Places& places);

  /// The decks, data, examples and results, and the run.
  Json state();
  [[nodiscard]] Json deck(const std::string& name) const;
  /// Adds a copy of an example, or of the deck to begin with. Throws Conflict as Folder::add_deck().
  Json add_deck(const Json& request);
  /// Throws ChangedDeck as Folder::save_deck().
  Json save_deck(const Json& request);
  /// Adds a file of data. Throws Conflict as Folder::add_data().
  Json upload(const std::string& name, std::string_view bytes);

  /// Each of these runs the command of its name to its end; throws Conflict if a later request has taken its place.
  Json check(const Json& request);
  Json pack(const Json& request);
  Json fit(const Json& request);
  Json compare(const Json& request);

  /// The command that start_run() would run.
  Json run_command(const Json& request);
  /// Starts `breccia run`. Throws Conflict if a run is under way.
  Json start_run(const Json& request);
  [[nodiscard]] Json run_status() const;
  Json stop_run();

  /// The absolute path of a file of the folder ("files/...") or of a preview ("preview/..."). Throws InputError if
  /// there is none.
  [[nodiscard]] std::filesystem::path file(std::string_view path) const;

  /// Ends all commands, so that no request waits; a run is asked to stop, and saves what it has.
  void end();

 private:
  /// A run of a deck as it is asked for.
  struct PlannedRun {
    std::string deck = {};
    std::string results = {};
    Command command = {};
  };

  [[nodiscard]] Program program() const;
  [[nodiscard]] PlannedRun planned_run(const Json& request) const;
  /// The addresses of the pictures below a preview, in alphabetical order.
  [[nodiscard]] std::vector<std::string> pictures_below(const std::filesystem::path& place) const;

  Places places_;
  Folder folder_;
  PrivateDirectory previews_;
  Folder preview_files_;
  LatestCommands checks_, packings_, fits_, comparisons_;
  RunningStudy run_;
};

}  // namespace breccia::studio
