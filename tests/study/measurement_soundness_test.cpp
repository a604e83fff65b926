// Tests of the mistakes in measurements that a program makes.

#include "study/expected_mistakes.hpp"
#include "study/two_stages.hpp"

namespace breccia {
namespace {

using test::expect_each;
using test::mistakes_of;
using testing::HasSubstr;
using testing::Not;

Study with_measurement() {
  auto study = test::two_stages();
  study.measurements = {
      {.label = "a", .stage = "fine", .modulus = Curve{{1e-3, 2e6}, {1.0, 1e6}}, .times = TimeWindow{1e-3, 0.1}},
      {.label = "b", .stage = "coarse", .modulus = PronySeries(1e6)}};
  return study;
}

TEST(RequireSound, LetsMeasurementsPass) {
  EXPECT_NO_THROW(require_sound(with_measurement()));
}

TEST(RequireSound, NamesEachMistakeOfMeasurements) {
  const auto with_curve = [](const Curve& curve) {
    return [curve](Study& study) { study.measurements[0].modulus = curve; };
  };
  expect_each({{[](Study& study) { study.measurements[1].label = "a"; }, "measurement a: another measurement"},
               {[](Study& study) { study.measurements[1].label = ""; }, "expected a name"},
               {[](Study& study) { study.measurements[1].label = "b\nc"; }, "expected a name without line breaks"},
               {[](Study& study) { study.measurements[1].stage = "C"; }, "measurement b: there is no stage \"C\""},
               {[](Study& study) { study.measurements[1].modulus = PronySeries(); },
                "measurement b: unrelaxed modulus: expected a positive pressure"},
               {[](Study& study) {
                  study.measurements[0].times = TimeWindow{0.1, 0.1};
                },
                "measurement a: expected two rising positive times"},
               {with_curve({{1.0, 1e6}}), "measurement a: expected at least 2 points of the curve"},
               {with_curve({{1.0, 1e6}, {1.0, 1e6}}), "measurement a: expected rising positive times of the curve"},
               {with_curve({{0.0, 1e6}, {1.0, 1e6}}), "measurement a: expected rising positive times of the curve"},
               {with_curve({{1.0, 1e6}, {2.0, 0.0}}), "measurement a: expected positive moduli of the curve"}},
              with_measurement());
  auto study = with_measurement();
  study.tests.loads = {Load::bulk};
  EXPECT_THAT(mistakes_of(study), HasSubstr("measurement b: there is no test in shear that could be compared"));
  study.measurements[1].kind = ModulusKind::young;
  EXPECT_THAT(mistakes_of(study), Not(HasSubstr("measurement b"))) << "both loads are added";
  study.measurements[1].kind = ModulusKind::other;
  EXPECT_THAT(mistakes_of(study), HasSubstr("measurement b: expected a shear, Young's or bulk modulus"));
}

}  // namespace
}  // namespace breccia
