#include "study/identity.hpp"

#include <functional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/two_stages.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

using Change = std::function<void(Study&)>;

/// A study as a deck reader returns it.
Study study_of_a_deck() {
  auto study = test::two_stages();
  study.provenance = {.deck = "deck.toml",
                      .deck_text = "title = ...",
                      .inputs = {"deck.toml"},
                      .overrides = {"stages.0.cells=12"},
                      .hash = "0123456789abcdef",
                      .stage_hashes = {"1", "2"},
                      .content = content_of(study)};
  return study;
}

TEST(ContentOf, EveryChangeOfWhatIsAskedMakesAnother) {
  const std::vector<Change> changes = {
      [](Study&) {},
      [](Study& study) { study.title = "another"; },
      [](Study& study) { study.materials.pop_back(); },
      [](Study& study) {
        study.materials[0].shift = {WilliamsLandelFerry{6.5, 120.0, 293.15}, 300.0};
      },
      [](Study& study) { study.stages.pop_back(); },
      [](Study& study) { study.stages[0].name = "another"; },
      [](Study& study) { study.stages[0].cells = 24; },
      [](Study& study) { study.stages[0].coarser_cells = {6}; },
      [](Study& study) { study.stages[0].side *= 1.0 + 1e-15; },
      [](Study& study) {
        std::get<Material>(study.stages[0].matrix).shear = PronySeries(1e4, {{0.02, 0.5e6}});
      },
      [](Study& study) { study.stages[1].matrix = test::binder; },
      [](Study& study) { study.stages[0].fillers[0].sizes = SingleSize{1e-3}; },
      [](Study& study) { study.stages[0].fillers[0].sizes = ListedSizes{{2e-3}}; },
      [](Study& study) {
        study.stages[0].fillers[0].sizes = FullerSizes{1e-3, 0.5};
      },
      [](Study& study) {
        study.stages[0].fillers[0].sizes = FullerSizes{1e-3, 0.45};
      },
      [](Study& study) {
        study.stages[0].fillers[0].sizes = RosinRammlerSizes{1e-3, 0.5};
      },
      [](Study& study) {
        study.stages[0].fillers[0].sizes = QuantileSizes{1e-3, 2e-3, 3e-3};
      },
      [](Study& study) {
        study.stages[0].fillers[0].sizes = QuantileSizes{1e-3, 2e-3, 4e-3};
      },
      [](Study& study) { study.stages[0].fillers[0].fraction = 0.3; },
      [](Study& study) {
        study.stages[0].packing = RegularPacking{1, 4};
      },
      [](Study& study) {
        study.stages[0].packing = LubachevskyStillingerPacking<2>{Walls::hard, 1};
      },
      [](Study& study) {
        study.stages[0].packing = LubachevskyStillingerPacking<2>{Walls::hard, 2};
      },
      [](Study& study) {
        study.stages[0].packing = ExplicitPacking<2>{"", std::vector{Disc{{1e-3, 1e-3}, 1e-3}}};
      },
      [](Study& study) { study.stages[0].packing = RandomSequentialPacking<2>{}; },
      [](Study& study) {
        study.stages[0].fillers[0].shape = FillerShape{EllipticOutline{1.5}, {}};
      },
      [](Study& study) {
        study.stages[0].fillers[0].shape = FillerShape{EllipticOutline{2.0}, {}};
      },
      [](Study& study) {
        study.stages[0].fillers[0].shape = FillerShape{EllipticOutline{2.0}, 0.1};
      },
      [](Study& study) {
        study.stages[0].fillers[0].shape = FillerShape{PolygonalOutline{"", {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}}, {}};
      },
      [](Study& study) {
        study.stages[0].packing =
            ExplicitPacking<2>{"", std::vector{Particle{Ellipse{{2e-3, 1e-3}}, Pose({2e-3, 2e-3}, 0.0)}}};
      },
      [](Study& study) { study.materials[0].thermal_expansion = 1e-5; },
      [](Study& study) { study.tests.last_time *= 2.0; },
      [](Study& study) { study.tests.loads = {Load::bulk}; },
      [](Study& study) { study.tests.quasistatic.sampling.tolerance = 1e-4; },
      [](Study& study) { study.tests.dynamic.mass_scaling_factors = {1.0}; },
      [](Study& study) { study.measurements = {{.label = "a", .stage = "fine", .modulus = PronySeries(1e6)}}; },
      [](Study& study) {
        study.measurements = {{.label = "a", .stage = "fine", .modulus = PronySeries(1e6), .kind = ModulusKind::young}};
      },
  };
  std::set<std::string> contents;
  for (const auto& change : changes) {
    auto study = test::two_stages();
    change(study);
    contents.insert(content_of(study));
  }
  EXPECT_EQ(contents.size(), changes.size());
}

// No result depends on threads and warnings.
TEST(ContentOf, LeavesAsideThreadsAndWarnings) {
  auto study = test::two_stages();
  study.tests.quasistatic.linear.threads = 3;
  study.provenance.warnings["fine"] = {"doubtful"};
  study.provenance.hash = "0123456789abcdef";
  EXPECT_EQ(content_of(study), content_of(test::two_stages()));
}

TEST(ContentOf, LeavesAsideFromWhichFileValuesCome) {
  auto study = test::two_stages(), moved = study;
  study.stages[0].fillers[0].sizes = TabulatedSizes{"sizes.csv", {1e-3, 2e-3}, {0.0, 1.0}};
  moved.stages[0].fillers[0].sizes = TabulatedSizes{"elsewhere/sizes.csv", {1e-3, 2e-3}, {0.0, 1.0}};
  EXPECT_EQ(content_of(moved), content_of(study));
  moved.stages[0].fillers[0].sizes = TabulatedSizes{"sizes.csv", {1e-3, 3e-3}, {0.0, 1.0}};
  EXPECT_NE(content_of(moved), content_of(study));
}

TEST(ProvenanceOf, AStudyAsItsDeckGivesItHasThatOfTheDeck) {
  const auto provenance = provenance_of(study_of_a_deck());
  EXPECT_EQ(provenance.deck, "deck.toml");
  EXPECT_EQ(provenance.hash, "0123456789abcdef");
  EXPECT_THAT(provenance.stage_hashes, ElementsAre("1", "2"));
}

TEST(ProvenanceOf, AChangedStudyLosesThatOfItsDeckButForTheFilesItWasReadFrom) {
  auto study = study_of_a_deck();
  study.stages[0].cells = 24;
  const auto provenance = provenance_of(study);
  EXPECT_EQ(provenance.hash, content_of(study));
  EXPECT_THAT(provenance.deck_text, IsEmpty());
  EXPECT_THAT(provenance.overrides, IsEmpty());
  EXPECT_THAT(provenance.stage_hashes, IsEmpty());
  EXPECT_THAT(provenance.inputs, ElementsAre("deck.toml"));
  study.stages[0].cells = 12;
  EXPECT_EQ(provenance_of(study).hash, "0123456789abcdef");
}

// A hash that somebody wrote by hand does not identify the content.
TEST(ProvenanceOf, AStudyPutTogetherInMemoryIsKnownByItsContent) {
  auto study = test::two_stages();
  study.provenance.hash = "0123456789abcdef";
  EXPECT_EQ(provenance_of(study).hash, content_of(study));
}

}  // namespace
}  // namespace breccia
