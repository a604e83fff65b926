#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "studio/folder.hpp"

namespace breccia::studio {

/// A deck that came with the program.
struct ExampleDeck {
  std::string name = {};  ///< path below the examples, "materials/concrete/concrete.toml"
  std::string title = {};
  std::string about = {};  ///< the comment with which it begins
};

/// The decks that came with the program, with the composites that were measured first.
std::vector<ExampleDeck> example_decks(const std::filesystem::path& examples);

/// Adds a copy of an example to a folder, with the files that it names, which the copy names by where they are now.
/// Throws InputError if there is no such example, Conflict if a file of one of these names is in the folder already and
/// has another content.
DeckText copy_example(const std::filesystem::path& examples, const std::string& example, Folder& folder,
                      const std::string& name);

}  // namespace breccia::studio
