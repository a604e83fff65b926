#pragma once

#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "decks.hpp"

namespace breccia::test {

/// Decks of one stage.
class DeckStages : public testing::Test {
 protected:
  /// A deck with one stage of 6 mm, given by these lines.
  [[nodiscard]] static std::string deck(std::string_view lines) {
    return join(materials, "[[stages]]\nname = \"a\"\nmatrix = \"binder\"\nbox = \"6 mm\"\n", lines, tests);
  }
  [[nodiscard]] Stage stage(std::string_view lines) const { return directory.study(deck(lines)).stages.at(0); }
  [[nodiscard]] Filler filler(std::string_view lines) const { return stage(join("cells = 60\n", lines)).fillers.at(0); }
  [[nodiscard]] std::string mistakes(std::string_view lines) const { return directory.mistakes(deck(lines)); }
  /// The mistakes in a stage of given discs with these keys of the packing.
  [[nodiscard]] std::string mistakes_with(std::string_view packing_keys) const {
    return mistakes(join("cells = 60\nfiller = { material = \"hmx\" }\npacking = { method = ", packing_keys, " }\n"));
  }
  /// The mistakes in a stage with these keys of the filler and of the packing.
  [[nodiscard]] std::string mistakes(std::string_view filler_keys, std::string_view packing_keys) const {
    return mistakes(join("cells = 60\nfiller = { material = \"hmx\", ", filler_keys,
                         " }\npacking = { method = ", packing_keys, " }\n"));
  }

  DeckDirectory directory;
};

inline constexpr auto random_packing = "\"lubachevsky-stillinger\"";
inline constexpr auto regular_packing = "\"regular\", columns = 2, rows = 2";

}  // namespace breccia::test
