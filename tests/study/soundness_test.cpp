#include "breccia/study/soundness.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "messages.hpp"
#include "study/two_stages.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string mistakes_of(const Study& study) {
  return test::message_of<InputError>([&] { require_sound(study); });
}

TEST(RequireSound, LetsAStudyPass) {
  EXPECT_NO_THROW(require_sound(test::two_stages()));
}

TEST(RequireSound, NamesEveryMistakeAtOnce) {
  auto study = test::two_stages();
  study.stages[0].matrix = EarlierStage{"coarse"};
  study.stages[1].name = "";
  study.stages[1].side = -1.0;
  study.stages[1].coarser_cells = {24};
  study.stages[1].filler->material.density = std::numeric_limits<double>::quiet_NaN();
  study.tests.boundaries.clear();
  study.tests.last_time = study.tests.first_time;
  EXPECT_THAT(mistakes_of(study),
              AllOf(HasSubstr("fine: no earlier stage \"coarse\" for its matrix"), HasSubstr("a stage without a name"),
                    HasSubstr("expected a side of the box above zero"), HasSubstr("rising from grid to grid"),
                    HasSubstr("filler: expected a density above zero"), HasSubstr("expected a boundary condition"),
                    HasSubstr("expected first_time < last_time")));
}

TEST(RequireSound, RefusesTwoStagesOfOneName) {
  auto study = test::two_stages();
  study.stages[1].name = "fine";
  EXPECT_THAT(mistakes_of(study), HasSubstr("fine: two stages have this name"));
}

TEST(RequireSound, RefusesAFillerThatItsPackingCannotTake) {
  auto study = test::two_stages();
  auto& filler = *study.stages[0].filler;
  filler.packing = LubachevskyStillingerPacking{};
  filler.gap = -1e-6;
  EXPECT_THAT(mistakes_of(study), AllOf(HasSubstr("fine, filler: expected a fraction between 0 and 1"),
                                        HasSubstr("fine, filler: expected a gap of zero or more")));
  filler.sizes.reset();
  EXPECT_THAT(mistakes_of(study), HasSubstr("fine, filler: expected sizes"));
  filler.packing = RegularPacking{2, 2};
  filler.sizes = ListedSizes{{1e-3, 2e-3}};
  EXPECT_THAT(mistakes_of(study), HasSubstr("fine, filler: expected a single size for a regular packing"));
}

TEST(RequireSound, RandomPackingsOfListedSizesNeedNoFraction) {
  auto study = test::two_stages();
  study.stages[0].filler->packing = LubachevskyStillingerPacking{};
  study.stages[0].filler->sizes = ListedSizes{{1e-3, 2e-3}};
  EXPECT_NO_THROW(require_sound(study));
}

TEST(RequireSound, RefusesAStudyWithoutStages) {
  EXPECT_THAT(mistakes_of({}), HasSubstr("a study without a stage"));
}

}  // namespace
}  // namespace breccia
