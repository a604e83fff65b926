#include "breccia/study/varied_material.hpp"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/study/soundness.hpp"

#include "messages.hpp"
#include "study/identity.hpp"
#include "study/two_stages.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

const VariedMaterial varied_glass = {"glass", ModulusInterval{1e9, 10e9}, {}};

TEST(ChoicesOfVaried, GoFromStiffToSoftOverEveryInterval) {
  const auto choices = choices_of_varied({{"glass", ModulusInterval{1e9, 10e9}, ModulusInterval{5e9, 20e9}}},
                                         {test::binder, test::glass});
  ASSERT_THAT(choices, SizeIs(4 * 2)) << "three steps in a decade of shear, both ends of bulk";
  for (const auto& choice : choices) {
    ASSERT_THAT(choice, SizeIs(1));
    EXPECT_EQ(choice.front().name, "glass");
    EXPECT_EQ(choice.front().density, test::glass.density);
  }
  EXPECT_EQ(choices.front().front().shear.equilibrium(), 10e9);
  EXPECT_EQ(choices.front().front().bulk.equilibrium(), 20e9);
  EXPECT_EQ(choices.back().front().shear.equilibrium(), 1e9);
  EXPECT_EQ(choices.back().front().bulk.equilibrium(), 5e9);
}

TEST(ChoicesOfVaried, KeepTheModulusWithoutAnInterval) {
  for (const auto& choice : choices_of_varied({varied_glass}, {test::glass})) {
    EXPECT_EQ(choice.front().bulk.equilibrium(), test::glass.bulk.equilibrium());
  }
}

TEST(ChoicesOfVaried, OfNoMaterialIsOneThatChangesNothing) {
  EXPECT_THAT(choices_of_varied({}, {test::glass}), ElementsAre(IsEmpty()));
  EXPECT_THAT(choices_of_varied({varied_glass}, {test::binder}), ElementsAre(IsEmpty()));
}

TEST(ChoicesOfVaried, OfTwoMaterialsAreAllPairs) {
  auto sand = test::glass;
  sand.name = "sand";
  const auto choices = choices_of_varied({varied_glass, {"sand", ModulusInterval{1e9, 10e9}, {}}}, {test::glass, sand});
  EXPECT_THAT(choices, SizeIs(16));
  EXPECT_TRUE(std::ranges::all_of(choices, [](const auto& choice) { return choice.size() == 2; }));
}

TEST(WithMaterials, ReplacesThoseOfTheSameName) {
  auto stage = test::two_stages().stages.front();
  stage.fillers.front().coating = Coating{test::binder, 1e-3};
  auto stiffer = test::binder;
  stiffer.shear = PronySeries(1e7);
  const auto changed = with_materials(stage, {stiffer});
  EXPECT_EQ(std::get<Material>(changed.matrix), stiffer);
  EXPECT_EQ(changed.fillers.front().coating->material, stiffer);
  EXPECT_EQ(changed.fillers.front().material, test::glass);
}

TEST(VariedMaterials, AreMistakesWhereTheyCannotVary) {
  auto study = test::two_stages();
  const auto mistakes_of = [&study](std::vector<VariedMaterial> varied) {
    study.tests.varied = std::move(varied);
    return test::message_of<InputError>([&] { require_sound(study); });
  };
  study.tests.varied = {varied_glass};
  EXPECT_NO_THROW(require_sound(study));
  EXPECT_THAT(mistakes_of({{"glas", ModulusInterval{1e9, 10e9}, {}}}),
              HasSubstr("no stage has a material \"glas\", did you mean \"glass\"?"));
  EXPECT_THAT(mistakes_of({{"binder", ModulusInterval{1e3, 1e6}, {}}}), HasSubstr("binder relaxes"));
  EXPECT_THAT(mistakes_of({{"glass", {}, {}}}), HasSubstr("expected shear or bulk"));
  EXPECT_THAT(mistakes_of({{"glass", ModulusInterval{1e9, 2e9}, ModulusInterval{0.0, 1e10}}}),
              AllOf(HasSubstr("the shear modulus of the material, 5 GPa, is not among 1 GPa to 2 GPa"),
                    HasSubstr("expected two rising positive bulk moduli")));
  EXPECT_THAT(mistakes_of({varied_glass, varied_glass}), HasSubstr("it is given twice"));
}

// A study without varied materials keeps the hash that it had in versions without them.
TEST(VariedMaterials, AreContentOfAStudyOnlyWhereThereAreSome) {
  auto study = test::two_stages();
  const auto plain = content_of(study);
  study.tests.varied = {varied_glass};
  const auto varied = content_of(study);
  study.tests.varied.front().shear->most = 20e9;
  EXPECT_NE(varied, plain);
  EXPECT_NE(content_of(study), varied);
}

}  // namespace
}  // namespace breccia
