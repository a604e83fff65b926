#include "studio/deck_changes.hpp"

#include <string>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

namespace breccia::studio {
namespace {

constexpr auto deck = R"([materials.glass]
bulk = "30 GPa"

[[stages]]
name   = "a"  # its name
filler = { material = "glass" }

[[stages]]
name   = "b.1"
filler = [{ material = "glass", fraction = 0.1 }]
)";

Json edited(const Json& changes) {
  const Json request = {{"text", deck}, {"name", "my deck.toml"}, {"changes", changes}};
  return edited_deck(Json::parse(request.dump()));  // as it is sent
}

TEST(EditedDeck, MakesSeveralChangesAtOnce) {
  const auto answer = edited({{{"path", {"stages", 0, "filler", "fraction"}}, {"value", "0.3"}},
                              {{"path", {"materials", "glass"}}, {"name", "stone"}},
                              {{"path", {"stages", 0}}, {"exchange", {"stages", 1}}},
                              {{"path", {"materials", "stone", "bulk"}}, {"value", nullptr}}});
  EXPECT_EQ(answer["text"], R"([materials.stone]

[[stages]]
name   = "b.1"
filler = [{ material = "stone", fraction = 0.1 }]

[[stages]]
name   = "a"  # its name
filler = { material = "stone", fraction = 0.3 }
)");
  EXPECT_EQ(answer["tree"]["entries"].size(), 2U);
  EXPECT_TRUE(answer["mistakes"].empty());
  EXPECT_TRUE(answer["command"].is_null());
}

TEST(EditedDeck, HasTheCommandThatDoesTheSame) {
  const auto command = [](const Json& changes) { return edited(changes)["command"]; };
  EXPECT_EQ(command({{{"path", {"stages", 0, "filler", "fraction"}}, {"value", "0.3"}},
                     {{"path", {"materials", "glass", "bulk"}}, {"value", nullptr}}}),
            "breccia run 'my deck.toml' --set stages.a.filler.fraction=0.3 --set materials.glass.bulk=");
  EXPECT_EQ(command({{{"path", {"stages", 1, "filler", 0, "fraction"}}, {"value", "\"5 %\""}}}),
            "breccia run 'my deck.toml' --set 'stages.\"b.1\".filler.0.fraction=\"5 %\"'");
  // An override adds no element to an array.
  EXPECT_TRUE(command({{{"path", {"stages", 1, "filler", 1}}, {"value", "{}"}}}).is_null());
}

TEST(EditedDeck, RefusesWhatIsNoChange) {
  for (const auto* changes : {"null", "[]", "{}", "[1]", "[{}]", R"([{"path": []}])", R"([{"path": ["a"]}])",
                              R"([{"path": ["a"], "value": 1}])", R"([{"path": ["materials", "glass"], "name": 1}])",
                              R"([{"path": ["stages", 0], "exchange": 1}])", R"([{"path": [1.5], "value": "1"}])"}) {
    EXPECT_THROW(edited(Json::parse(changes)), InputError) << changes;
  }
}

}  // namespace
}  // namespace breccia::studio
