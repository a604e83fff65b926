#include "studio/folder.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "deckfile/deck.hpp"
#include "io/file_mistakes.hpp"
#include "io/text_encoding.hpp"
#include "io/text_file.hpp"

namespace breccia::studio {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view deck_suffix = ".toml";

/// Whether a part of a path is one that the studio shows: neither hidden nor a step up, nor like an option of a
/// command.
bool is_open_part(std::string_view part) {
  return !part.empty() && part.front() != '.' && part.front() != '-' &&
         std::ranges::none_of(part, [](unsigned char byte) { return byte < 0x20 || byte == 0x7f; });
}

void require_deck_name(std::string_view name) {
  if (is_file_name(name) && name.ends_with(deck_suffix)) return;
  throw InputError(fmt::format(R"({}: expected the name of a deck, such as "asphalt.toml")", shown_value(name)));
}

/// The title of a deck; its name if it has none or cannot be read.
std::string title_of(const fs::path& path) {
  try {
    const Deck deck(path);
    const auto title = deck.root().optional_text("title");
    if (title && !title->empty()) return *title;
  } catch (const Error&) {
  }
  return path.stem().string();
}

bool has_suffix(std::string_view name, const std::vector<std::string>& suffixes) {
  return std::ranges::any_of(suffixes, [&](const std::string& suffix) { return name.ends_with(suffix); });
}

/// Whether a path lies in a directory; both are canonical.
bool is_inside(const fs::path& path, const fs::path& directory) {
  return std::ranges::mismatch(directory, path).in1 == directory.end();
}

}  // namespace

const std::vector<std::string> table_suffixes = {".csv", ".txt", ".dat", ".tsv", ".xlsx"};
const std::vector<std::string> picture_suffixes = {".png", ".tif", ".tiff", ".npy", ".h5", ".vti"};

bool is_file_name(std::string_view name) {
  constexpr std::size_t longest = 200;
  return is_open_part(name) && name.size() <= longest && name.find('/') == std::string_view::npos &&
         name.find('\\') == std::string_view::npos;
}

Folder::Folder(const fs::path& path) {
  std::error_code failure;
  path_ = fs::canonical(path, failure);
  if (failure || !fs::is_directory(path_)) throw InputError(fmt::format("{}: no such directory", path.string()));
}

std::vector<ListedDeck> Folder::decks() const {
  std::vector<ListedDeck> decks;
  for (auto& name : files({std::string(deck_suffix)})) {
    auto title = title_of(path_ / name);
    decks.push_back({std::move(name), std::move(title)});
  }
  return decks;
}

std::vector<std::string> Folder::files(const std::vector<std::string>& suffixes) const {
  std::vector<std::string> names;
  std::error_code failure;
  for (const auto& entry : fs::directory_iterator(path_, failure)) {
    auto name = entry.path().filename().string();
    if (!is_file_name(name) || !has_suffix(name, suffixes)) continue;
    try {
      (void)file(name);
      names.push_back(std::move(name));
    } catch (const InputError&) {
      // Not a file, or a link to one outside of the folder.
    }
  }
  std::ranges::sort(names);
  return names;
}

fs::path Folder::file(std::string_view name) const {
  const fs::path relative(name);
  const bool is_open = !name.empty() && relative.is_relative() &&
                       std::ranges::all_of(relative, [](const fs::path& part) { return is_open_part(part.string()); });
  std::error_code failure;
  auto path = is_open ? fs::canonical(path_ / relative, failure) : fs::path();
  const auto results = fs::canonical(path_ / "results", failure);
  const bool is_allowed = is_inside(path, path_) || (!results.empty() && is_inside(path, results));
  if (path.empty() || !is_allowed || !fs::is_regular_file(path, failure)) {
    throw InputError(fmt::format("{}: no such file in {}", shown_value(name), path_.string()));
  }
  return path;
}

DeckText Folder::deck(std::string_view name) const {
  require_deck_name(name);
  auto text = read_text(file(name));
  detail::require_utf8(name, text);
  auto version = content_hash(text);
  return {std::string(name), std::move(text), std::move(version)};
}

DeckText Folder::save_deck(const DeckText& deck) {
  const std::lock_guard lock(mutex_);
  auto present = this->deck(deck.name);
  if (present.text == deck.text) return present;
  if (present.version != deck.version) {
    throw ChangedDeck(
        fmt::format("{}: the file has changed since it was read, by an editor or in another window", deck.name),
        present.version);
  }
  const auto path = file(deck.name);
  const auto permissions = fs::status(path).permissions();
  const auto write = [&](const fs::path& to, const std::string& text) {
    write_text(to, text);
    fs::permissions(to, permissions);
  };
  if (!kept_.contains(path)) write(path.string() + "~", present.text);
  kept_.insert(path);
  write(path, deck.text);
  return {deck.name, deck.text, content_hash(deck.text)};
}

void Folder::require_new_deck(const std::string& name) const {
  require_deck_name(name);
  if (fs::exists(fs::symlink_status(path_ / name))) {
    throw Conflict(fmt::format("{}: the file exists and is not overwritten; choose another name", name));
  }
}

DeckText Folder::add_deck(const std::string& name, const std::string& text) {
  const std::lock_guard lock(mutex_);
  require_new_deck(name);
  write_text(path_ / name, text);
  kept_.insert(path_ / name);
  return deck(name);
}

void Folder::add_data(const std::string& name, std::string_view bytes) {
  if (!is_file_name(name) || !(has_suffix(name, table_suffixes) || has_suffix(name, picture_suffixes))) {
    throw InputError(fmt::format("{}: expected a table ({}) or a picture ({})", shown_value(name),
                                 fmt::join(table_suffixes, ", "), fmt::join(picture_suffixes, ", ")));
  }
  const std::lock_guard lock(mutex_);
  const auto path = path_ / name;
  if (fs::exists(fs::symlink_status(path))) {
    if (read_text(file(name)) == bytes) return;
    throw Conflict(fmt::format("{}: another file of this name is in the folder; rename one of them", name));
  }
  write_text(path, bytes);
}

}  // namespace breccia::studio
