#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "breccia/error.hpp"

namespace breccia::studio {

/// Error that something else has taken place meanwhile: a file is there already, a run is under way.
class Conflict : public Error {
 public:
  explicit Conflict(const std::string& message) : Error(ExitCode::bad_input, message) {}
};

/// Error that a deck has changed since it was read.
class ChangedDeck : public Conflict {
 public:
  /// `version` is that of the text that is there now.
  ChangedDeck(const std::string& message, std::string version) : Conflict(message), version_(std::move(version)) {}
  [[nodiscard]] const std::string& version() const noexcept { return version_; }

 private:
  std::string version_;
};

/// A deck as the page has it.
struct DeckText {
  std::string name = {};
  std::string text = {};
  std::string version = {};  ///< hash of the text, by which a change by someone else is noticed
};

/// The name of a file, with the title of the deck in it.
struct ListedDeck {
  std::string name = {};
  std::string title = {};
};

/// The folder in which the studio works: its decks, the data that they name, and the results. Nothing outside of it is
/// read or written, but for results where `results` is a link, and nothing whose name begins with a dot or, as an
/// option does, with a dash. For several threads.
class Folder {
 public:
  /// Throws InputError if there is no such directory.
  explicit Folder(const std::filesystem::path& path);

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

  /// The decks of the folder, in alphabetical order.
  [[nodiscard]] std::vector<ListedDeck> decks() const;
  /// The names of the files that end in one of these, in alphabetical order.
  [[nodiscard]] std::vector<std::string> files(const std::vector<std::string>& suffixes) const;

  /// The absolute path of an existing file below the folder, by its relative name with slashes. Throws InputError for
  /// any other name, also for one that leads out of the folder by a symbolic link.
  [[nodiscard]] std::filesystem::path file(std::string_view name) const;

  /// Throws InputError if the name is not that of a deck directly in the folder, or there is none, or it is not UTF-8.
  [[nodiscard]] DeckText deck(std::string_view name) const;
  /// Writes a deck that was read with this version. The text that was there first in this session is kept as NAME~.
  /// Throws ChangedDeck if it has changed since.
  DeckText save_deck(const DeckText& deck);
  /// Throws InputError if a new deck cannot have this name, Conflict if a file has it.
  void require_new_deck(const std::string& name) const;
  /// Writes a deck that is not there yet. Throws as require_new_deck().
  DeckText add_deck(const std::string& name, const std::string& text);
  /// Writes a table or a picture that is not there yet, or has the same content. Throws Conflict if it has another one.
  void add_data(const std::string& name, std::string_view bytes);

 private:
  std::filesystem::path path_;
  std::mutex mutex_;                           ///< one change at a time
  std::set<std::filesystem::path> kept_ = {};  ///< decks whose first text is kept
};

/// How the names of tables of data end.
extern const std::vector<std::string> table_suffixes;
/// How the names of pictures of microstructures end.
extern const std::vector<std::string> picture_suffixes;

/// Whether a name can be one of a file directly in the folder.
bool is_file_name(std::string_view name);

}  // namespace breccia::studio
