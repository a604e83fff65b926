#include "studio/folder.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "deckfile/deck.hpp"
#include "io/file_mistakes.hpp"
#include "io/text_file.hpp"

namespace breccia::studio {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view deck_suffix = ".toml";

/// Whether a part of a path is one that the studio shows: neither hidden nor a step up.
bool is_open_part(std::string_view part) {
  return !part.empty() && part.front() != '.' &&
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

}  // namespace

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
    const bool has_suffix =
        std::ranges::any_of(suffixes, [&](const std::string& suffix) { return name.ends_with(suffix); });
    if (has_suffix && is_file_name(name) && entry.is_regular_file(failure)) names.push_back(std::move(name));
  }
  std::ranges::sort(names);
  return names;
}

fs::path Folder::file(std::string_view name) const {
  const fs::path relative(name);
  const bool is_open = !name.empty() && relative.is_relative() &&
                       std::ranges::all_of(relative, [](const fs::path& part) { return is_open_part(part.string()); });
  std::error_code failure;
  const auto path = is_open ? fs::canonical(path_ / relative, failure) : fs::path();
  const bool is_inside = std::ranges::mismatch(path_, path).in1 == path_.end();
  if (!is_open || failure || !is_inside || !fs::is_regular_file(path, failure)) {
    throw InputError(fmt::format("{}: no such file in {}", shown_value(name), path_.string()));
  }
  return path;
}

DeckText Folder::deck(std::string_view name) const {
  require_deck_name(name);
  auto text = read_text(file(name));
  auto version = content_hash(text);
  return {std::string(name), std::move(text), std::move(version)};
}

DeckText Folder::save_deck(const DeckText& deck) {
  const std::lock_guard lock(mutex_);
  const auto present = this->deck(deck.name);
  if (present.text == deck.text) return present;
  if (present.version != deck.version) {
    throw ChangedDeck(
        fmt::format("{}: the file has changed since it was read, by an editor or in another window", deck.name),
        present.version);
  }
  const auto path = file(deck.name);
  if (kept_.insert(deck.name).second) write_text(path.string() + "~", present.text);
  write_text(path, deck.text);
  return {deck.name, deck.text, content_hash(deck.text)};
}

DeckText Folder::add_deck(const std::string& name, const std::string& text) {
  require_deck_name(name);
  const std::lock_guard lock(mutex_);
  if (fs::exists(fs::symlink_status(path_ / name))) {
    throw Conflict(fmt::format("{}: the file exists and is not overwritten; choose another name", name));
  }
  write_text(path_ / name, text);
  kept_.insert(name);
  return deck(name);
}

void Folder::add_data(const std::string& name, std::string_view bytes) {
  if (!is_file_name(name) || name.ends_with(deck_suffix)) {
    throw InputError(fmt::format(R"({}: expected the name of a file of data, such as "dma.csv")", shown_value(name)));
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
