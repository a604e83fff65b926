#include "homogenisation/respond/coverage_refusal.hpp"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/homogenisation/responder.hpp"

#include "messages.hpp"
#include "one_vector_response.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

/// A response sampled from 1 to 100 MPa in shear and at 2 GPa in bulk, which is usable 5 % and 10 % beyond.
ReducedResponse sampled(Boundary boundary) {
  return test::one_vector_response(Load::shear, boundary, {3.0, 2.0, 0.0},
                                   {{{{.bulk = 2e9, .shear = 1e8}}, 0.0}, {{{.bulk = 2e9, .shear = 1e6}}, 0.0}});
}

StageResponses stored() {
  StageResponses stored;
  stored.stage = "A";
  stored.matrix = Material{"binder", 1000.0, PronySeries(2e9), PronySeries(1e7)};
  stored.side = 1.0;
  stored.times = {1e-3, 1e6};
  stored.entries = {{TestGrid(12), sampled(Boundary::displacement)}, {TestGrid(12), sampled(Boundary::traction)}};
  return stored;
}

Responder with_matrix(const Material& matrix) {
  return Responder({stored()}).with({{"matrix", matrix}});
}

/// A material whose Carson modulus at s = 1/t is 1 GPa / (1 + t / 1 s).
Material maxwell() {
  return {"gel", 1000.0, PronySeries(2e9), PronySeries(0.0, {{1.0, 1e9}})};
}

MatrixUnder everywhere(const Material& material) {
  return [&material](Boundary) -> const Material& { return material; };
}

// The modulus is 105 MPa at 8.52 s and 0.95 MPa at 1051.6 s. The times are checked with 48 to a decade, and rounded
// inwards.
TEST(CoverageRefusal, TellsWhatIsShownWhatWasSampledAndWhatIsCovered) {
  const auto gel = maxwell();
  EXPECT_EQ(test::message_of<InputError>([&] { static_cast<void>(with_matrix(gel).respond()); }),
            "stage A: from 1 ms to 1 Ms gel shows a shear modulus from 1 kPa to 999 MPa; the responses hold from "
            "950 kPa to 105 MPa\n"
            "a new study with this material as its matrix covers all of it\n"
            "covered from 8.7 s to 1 ks");
}

TEST(CoverageRefusal, NamesTimesThatAreAnswered) {
  const auto gel = maxwell();
  const auto stage = with_matrix(gel).within({8.7, 1000.0}).respond().front();
  ASSERT_EQ(stage.tests.size(), 2U);
  // A composite with the modulus 3 + 2 G.
  for (const auto& [time, modulus] : stage.tests[0].modulus) {
    EXPECT_NEAR(modulus / (3.0 + 2.0 * gel.shear.at(time)), 1.0, 1e-9) << time;
  }
}

TEST(CoverageRefusal, IsOfTheBulkModulusWhereTheShearModulusIsCovered) {
  auto material = maxwell();
  material.shear = PronySeries(1e7);
  for (const double bulk : {1.81e9, 2.19e9}) {
    material.bulk = PronySeries(bulk);
    EXPECT_NO_THROW(require_coverage(stored(), everywhere(material), {1.0, 10.0})) << bulk;
  }
  for (const double bulk : {1.79e9, 2.21e9}) {
    material.bulk = PronySeries(bulk);
    const auto refusal = [&] { require_coverage(stored(), everywhere(material), {1.0, 10.0}); };
    EXPECT_THAT(test::message_of<NotCovered>(refusal), AllOf(HasSubstr("gel shows a bulk modulus of "),
                                                             HasSubstr("the responses hold from 1.8 GPa to 2.2 GPa")));
  }
}

TEST(CoverageRefusal, TellsOfStudiesThatSampledTheirTimesAlone) {
  auto responses = stored();
  responses.range = SampledRange::times;
  const auto gel = maxwell();
  EXPECT_THAT(
      test::message_of<NotCovered>([&] {
        require_coverage(responses, everywhere(gel), {1e-3, 1.0});
      }),
      EndsWith("the study was run with tests.quasistatic.range = \"times\"; with \"matrix\", the default, it covers "
               "its own matrix at every temperature"));
}

// Under one boundary the matrix is covered up to 1 ks, under the other not at all.
TEST(CoverageRefusal, IsOfEachBoundaryWithItsOwnMatrix) {
  const auto gel = maxwell();
  auto stiff = maxwell();
  stiff.name = "stiff";
  stiff.shear = PronySeries(1e12);
  const MatrixUnder matrix = [&](Boundary boundary) -> const Material& {
    return boundary == Boundary::displacement ? gel : stiff;
  };
  try {
    require_coverage(stored(), matrix, {1e-3, 1e6});
    FAIL() << "nothing was thrown";
  } catch (const NotCovered& refusal) {
    EXPECT_THAT(refusal.what(), AllOf(HasSubstr("gel shows"), HasSubstr("\nstage A: from 1 ms to 1 Ms stiff shows")));
    EXPECT_FALSE(refusal.times());
    EXPECT_STREQ(with_covered_times(refusal, refusal.times(), Abscissa::time).what(), refusal.what());
  }
}

TEST(CoverageRefusal, TellsTimesThatTheWholeAttemptCovers) {
  std::vector<TimeWindow> tried;
  const auto attempt = [&](const TimeWindow& window) -> int {
    tried.push_back(window);
    if (window.begin < 2.0) throw NotCovered("the first stage", TimeWindow{2.0, 8.0});
    if (window.end > 7.0) throw NotCovered("the second stage", TimeWindow{3.0, 7.0});
    return 1;
  };
  EXPECT_EQ(test::message_of<InputError>([&] {
              or_refuse_with_covered_times({1.0, 9.0}, Abscissa::time, attempt);
            }),
            "the first stage\ncovered from 3 s to 7 s");
  EXPECT_THAT(tried, ElementsAre(TimeWindow{1.0, 9.0}, TimeWindow{2.0, 8.0}, TimeWindow{3.0, 7.0}));
  EXPECT_EQ(or_refuse_with_covered_times({4.0, 5.0}, Abscissa::time, attempt), 1);
}

TEST(CoverageRefusal, TellsNoTimesWhereNoneAreLeft) {
  const auto refused = [](const TimeWindow&) -> int { throw NotCovered("no", std::nullopt); };
  EXPECT_EQ(test::message_of<InputError>([&] {
              or_refuse_with_covered_times({1.0, 9.0}, Abscissa::time, refused);
            }),
            "no");
  const auto fails = [](const TimeWindow& window) -> int {
    if (window.begin < 2.0) throw NotCovered("no", TimeWindow{2.0, 8.0});
    throw NumericalError("the fit is bad");
  };
  EXPECT_EQ(test::message_of<InputError>([&] {
              or_refuse_with_covered_times({1.0, 9.0}, Abscissa::time, fails);
            }),
            "no");
}

}  // namespace
}  // namespace breccia
