#include "breccia/discretisation/phases.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "messages.hpp"

namespace breccia {
namespace {

const Material binder = {"binder", 1000.0, PronySeries(4e9), PronySeries(1e6)};
const Material glass = {"glass", 2500.0, PronySeries(40e9), PronySeries(30e9)};

TEST(Phases, HaveTheNumbersOfTheirPositions) {
  const Phases phases({"matrix", "coarse", "fine"});
  EXPECT_EQ(phases.size(), 3U);
  EXPECT_EQ(phases.index_of("matrix"), 0);
  EXPECT_EQ(phases.index_of("coarse"), 1);
  EXPECT_EQ(phases.index_of("fine"), 2);
}

TEST(Phases, PutMaterialsInTheirOrder) {
  // The order is neither that of the alphabet nor that of the map, and two phases have one material.
  const Phases phases({"matrix", "fine", "coarse"});
  const auto materials = phases.materials({{"fine", glass}, {"coarse", glass}, {"matrix", binder}});
  EXPECT_EQ(materials, (std::vector<Material>{binder, glass, glass}));
}

TEST(Phases, RefuseANameThatNoneHas) {
  const Phases phases({"matrix", "filler"});
  EXPECT_EQ(test::message_of<InputError>([&] { static_cast<void>(phases.index_of("fillr")); }),
            "phases: no phase is called \"fillr\"; the phases are: matrix, filler");
  EXPECT_THROW(static_cast<void>(phases.index_of("")), InputError);
}

TEST(Phases, RefuseMaterialsThatAreNotThoseOfThePhases) {
  const Phases phases({"matrix", "filler"});
  EXPECT_EQ(test::message_of<InputError>([&] {
              static_cast<void>(phases.materials({{"matrix", binder}}));
            }),
            "phases: expected a material for the phase filler");
  EXPECT_EQ(test::message_of<InputError>([&] {
              static_cast<void>(phases.materials({{"matrix", binder}, {"filler", glass}, {"coating", glass}}));
            }),
            "phases: no phase is called \"coating\"; the phases are: matrix, filler");
}

TEST(Phases, RefuseNamesThatTellNoPhasesApart) {
  EXPECT_EQ(test::message_of<InputError>([] {
              static_cast<void>(Phases({"matrix", "filler", "filler"}));
            }),
            "phases: two phases are called \"filler\"");
  EXPECT_THROW(static_cast<void>(Phases({"matrix", ""})), InputError);
}

TEST(Phases, AreAtMostAsManyAsThereAreNumbers) {
  std::vector<std::string> names;
  names.reserve(no_phase);
  for (int i = 0; i < no_phase; ++i) names.push_back(std::to_string(i));
  EXPECT_EQ(Phases(names).index_of("65534"), no_phase - 1);
  names.emplace_back("one too many");
  EXPECT_EQ(test::message_of<InputError>([&] { static_cast<void>(Phases(names)); }),
            "phases: expected at most 65535, got 65536");
}

}  // namespace
}  // namespace breccia
