#include "homogenisation/varying_moduli.hpp"

#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "one_vector_response.hpp"
#include "quasistatic/reduced/carson_path.hpp"
#include "study/two_stages.hpp"

namespace breccia {
namespace {

using testing::IsEmpty;
using testing::Lt;

/// A reduced test whose modulus is a linear function of the moduli of its matrix.
TestResult linear_test(Load load, const test::LinearComposite& composite, int cells = 12,
                       Boundary boundary = Boundary::displacement) {
  TestResult test{.id = {.load = load, .boundary = boundary, .grid = TestGrid(cells)}};
  QuasistaticRecord record;
  record.reduced = test::one_vector_response(load, boundary, composite, {});
  test.record = std::move(record);
  return test;
}

class VaryingModuli : public testing::Test {
 protected:
  VaryingModuli() { fine.name = "fine"; }

  /// Moduli of the matrix, the first of the phases.
  [[nodiscard]] static std::vector<Moduli> of_matrix(const std::vector<std::vector<Moduli>>& path) {
    std::vector<Moduli> moduli;
    moduli.reserve(path.size());
    for (const auto& point : path) moduli.push_back(point.front());
    return moduli;
  }
  [[nodiscard]] std::vector<Moduli> of_coarse(Boundary boundary = Boundary::displacement) const {
    return of_matrix(varying_moduli(study, study.stages[1], {fine}, boundary));
  }
  [[nodiscard]] std::vector<Moduli> path_of_binder() const {
    return relaxation_path(test::binder, {study.tests.first_time, study.tests.last_time});
  }

  Study study = test::two_stages();
  StageResult fine;
};

TEST_F(VaryingModuli, OfAMaterialAreItsRelaxation) {
  const auto moduli = of_matrix(varying_moduli(study, study.stages[0], {}, Boundary::displacement));
  ASSERT_GT(moduli.size(), 2U);
  EXPECT_EQ(moduli.front().shear, test::binder.shear.unrelaxed());
  EXPECT_EQ(moduli.back().shear, test::binder.shear.equilibrium());
  EXPECT_EQ(moduli.back().bulk, 1e9);
}

// The composite has G' = 3 + 2 G and K' + G'/3 = 1 + 0.8 K + G.
TEST_F(VaryingModuli, OfAStageAreThoseOfItsCompositeAlongThePathOfTheBinder) {
  fine.tests = {linear_test(Load::shear, {3.0, 2.0, 0.0}), linear_test(Load::bulk, {1.0, 1.0, 0.8})};
  const auto moduli = of_coarse(), path = path_of_binder();
  ASSERT_EQ(moduli.size(), path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double shear = 3.0 + 2.0 * path[i].shear;
    EXPECT_NEAR(moduli[i].shear / shear, 1.0, 1e-12) << i;
    EXPECT_NEAR(moduli[i].bulk / (1.0 + 0.8 * path[i].bulk + path[i].shear - shear / 3.0), 1.0, 1e-12) << i;
  }
}

// The filler of the fine stage relaxes by half at 1 us, that of the coarse stage at 1 h. G' = 3 + 2 G + 4 G_filler.
TEST_F(VaryingModuli, OfAStageWithFillersThatRelaxAreTakenAtOneLaplaceVariable) {
  const auto relaxing = [](const char* name, double time) {
    return Material{name, 1000.0, PronySeries(9e9), PronySeries(1e9, {{time, 1e9}})};
  };
  study.stages[0].fillers[0].material = relaxing("fine filler", 1e-6);
  study.stages[1].fillers[0].material = relaxing("coarse filler", 3600.0);
  fine.tests = {linear_test(Load::shear, {3.0, 2.0, 0.0}), linear_test(Load::bulk, {1.0, 1.0, 0.8})};
  const auto one = [](double x) -> Eigen::MatrixXd { return Eigen::MatrixXd::Constant(1, 1, x); };
  for (auto& test : fine.tests) {
    auto& parts = std::get<QuasistaticRecord>(test.record).reduced->parts;
    parts.push_back({{"filler", ElasticModulus::shear}, one(4.0)});
    parts.push_back({{"filler", ElasticModulus::bulk}, one(0.0)});
  }
  const auto moduli = varying_moduli(study, study.stages[1], {fine}, Boundary::displacement);
  const std::vector materials = {test::binder, study.stages[0].fillers[0].material,
                                 study.stages[1].fillers[0].material};
  const auto path = relaxation_path(materials, {study.tests.first_time, study.tests.last_time});
  ASSERT_EQ(moduli.size(), path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    const auto& [binder, fine_filler, coarse_filler] =
        std::tie(path[i].moduli[0], path[i].moduli[1], path[i].moduli[2]);
    ASSERT_EQ(moduli[i].size(), 2U) << "matrix and filler";
    EXPECT_NEAR(moduli[i][0].shear / (3.0 + 2.0 * binder.shear + 4.0 * fine_filler.shear), 1.0, 1e-12) << i;
    EXPECT_EQ(moduli[i][1].shear, coarse_filler.shear) << i;
  }
  EXPECT_EQ(moduli.front()[1].shear, 2e9);
  EXPECT_EQ(moduli.back()[1].shear, 1e9);
}

// The modulus is (2 + 2 h / h(12 cells)) G, so that the limit of vanishing cells is 2 G.
TEST_F(VaryingModuli, OfSeveralGridsAreTheLimit) {
  study.tests.mixing = Mixing::points;
  study.stages[0].coarser_cells = {6};
  fine.tests = {linear_test(Load::shear, {0.0, 6.0, 0.0}, 6), linear_test(Load::bulk, {0.0, 4.0, 1.0}, 6),
                linear_test(Load::shear, {0.0, 4.0, 0.0}, 12), linear_test(Load::bulk, {0.0, 3.0, 1.0}, 12)};
  const auto moduli = of_coarse(), path = path_of_binder();
  ASSERT_EQ(moduli.size(), path.size());
  EXPECT_NEAR(moduli.front().shear / (2.0 * path.front().shear), 1.0, 1e-12);
  EXPECT_NEAR(moduli.back().shear / (2.0 * path.back().shear), 1.0, 1e-12);
}

TEST_F(VaryingModuli, OfSeveralGridsWithMixedCellsAreThoseOfTheFinest) {
  study.tests.mixing = Mixing::series;
  study.stages[0].coarser_cells = {6};
  fine.tests = {linear_test(Load::shear, {0.0, 6.0, 0.0}, 6), linear_test(Load::bulk, {0.0, 4.0, 1.0}, 6),
                linear_test(Load::shear, {0.0, 4.0, 0.0}, 12), linear_test(Load::bulk, {0.0, 3.0, 1.0}, 12)};
  const auto moduli = of_coarse(), path = path_of_binder();
  ASSERT_EQ(moduli.size(), path.size());
  EXPECT_NEAR(moduli.back().shear / (4.0 * path.back().shear), 1.0, 1e-12);
}

// The modulus G' = G - 0.1 MPa is not that of a solid where G is below 0.1 MPa.
TEST_F(VaryingModuli, EndWhereTheStageIsNoSolid) {
  fine.tests = {linear_test(Load::shear, {-1e5, 1.0, 0.0}), linear_test(Load::bulk, {0.0, 0.0, 1.0})};
  const auto moduli = of_coarse();
  ASSERT_FALSE(moduli.empty());
  EXPECT_THAT(moduli.size(), Lt(path_of_binder().size()));
  for (const auto& at : moduli) EXPECT_GT(at.shear, 0.0);
}

// The modulus G' rises where G falls.
TEST_F(VaryingModuli, EndWhereTheyCeaseToFall) {
  fine.tests = {linear_test(Load::shear, {1e7, -1.0, 0.0}), linear_test(Load::bulk, {0.0, 0.0, 1.0})};
  EXPECT_EQ(of_coarse().size(), 1U);
}

TEST_F(VaryingModuli, AreNotKnownWithoutBothResponsesUnderTheBoundary) {
  fine.tests = {linear_test(Load::shear, {3.0, 2.0, 0.0})};
  EXPECT_THAT(of_coarse(), IsEmpty()) << "no bulk test";
  fine.tests.push_back(linear_test(Load::bulk, {1.0, 1.0, 0.8}));
  EXPECT_THAT(of_coarse(Boundary::traction), IsEmpty());
  fine.tests[1].record = QuasistaticRecord{};
  EXPECT_THAT(of_coarse(), IsEmpty()) << "stepped through time";
  EXPECT_THAT(varying_moduli(study, study.stages[1], {}, Boundary::displacement), IsEmpty()) << "no result";
}

}  // namespace
}  // namespace breccia
