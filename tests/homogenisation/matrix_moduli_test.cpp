#include "homogenisation/matrix_moduli.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/quasistatic/carson_path.hpp"

#include "one_vector_response.hpp"
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
  record.response.reduced = test::one_vector_response(load, boundary, composite, {});
  test.record = std::move(record);
  return test;
}

class MatrixModuli : public testing::Test {
 protected:
  MatrixModuli() { fine.name = "fine"; }

  [[nodiscard]] std::vector<Moduli> of_coarse(Boundary boundary = Boundary::displacement) const {
    return matrix_moduli(study, study.stages[1], {fine}, boundary);
  }
  [[nodiscard]] std::vector<Moduli> path_of_binder() const {
    return relaxation_path(test::binder, {study.tests.first_time, study.tests.last_time});
  }

  Study study = test::two_stages();
  StageResult fine;
};

TEST_F(MatrixModuli, OfAMaterialAreItsRelaxation) {
  const auto moduli = matrix_moduli(study, study.stages[0], {}, Boundary::displacement);
  ASSERT_GT(moduli.size(), 2U);
  EXPECT_EQ(moduli.front().shear, test::binder.shear.unrelaxed());
  EXPECT_EQ(moduli.back().shear, test::binder.shear.equilibrium());
  EXPECT_EQ(moduli.back().bulk, 1e9);
}

// G' = 3 + 2 G and K' + G'/3 = 1 + 0.8 K + G.
TEST_F(MatrixModuli, OfAStageAreThoseOfItsCompositeAlongThePathOfTheBinder) {
  fine.tests = {linear_test(Load::shear, {3.0, 2.0, 0.0}), linear_test(Load::bulk, {1.0, 1.0, 0.8})};
  const auto moduli = of_coarse(), path = path_of_binder();
  ASSERT_EQ(moduli.size(), path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double shear = 3.0 + 2.0 * path[i].shear;
    EXPECT_NEAR(moduli[i].shear / shear, 1.0, 1e-12) << i;
    EXPECT_NEAR(moduli[i].bulk / (1.0 + 0.8 * path[i].bulk + path[i].shear - shear / 3.0), 1.0, 1e-12) << i;
  }
}

// With 2 + 2 h / h(12 cells) times G the limit of vanishing cells is 2 G.
TEST_F(MatrixModuli, OfSeveralGridsAreTheLimit) {
  study.tests.mixing = Mixing::points;
  study.stages[0].coarser_cells = {6};
  fine.tests = {linear_test(Load::shear, {0.0, 6.0, 0.0}, 6), linear_test(Load::bulk, {0.0, 4.0, 1.0}, 6),
                linear_test(Load::shear, {0.0, 4.0, 0.0}, 12), linear_test(Load::bulk, {0.0, 3.0, 1.0}, 12)};
  const auto moduli = of_coarse(), path = path_of_binder();
  ASSERT_EQ(moduli.size(), path.size());
  EXPECT_NEAR(moduli.front().shear / (2.0 * path.front().shear), 1.0, 1e-12);
  EXPECT_NEAR(moduli.back().shear / (2.0 * path.back().shear), 1.0, 1e-12);
}

TEST_F(MatrixModuli, OfSeveralGridsWithMixedCellsAreThoseOfTheFinest) {
  study.tests.mixing = Mixing::series;
  study.stages[0].coarser_cells = {6};
  fine.tests = {linear_test(Load::shear, {0.0, 6.0, 0.0}, 6), linear_test(Load::bulk, {0.0, 4.0, 1.0}, 6),
                linear_test(Load::shear, {0.0, 4.0, 0.0}, 12), linear_test(Load::bulk, {0.0, 3.0, 1.0}, 12)};
  const auto moduli = of_coarse(), path = path_of_binder();
  ASSERT_EQ(moduli.size(), path.size());
  EXPECT_NEAR(moduli.back().shear / (4.0 * path.back().shear), 1.0, 1e-12);
}

// G' = G - 0.1 MPa is no solid any more where G is below.
TEST_F(MatrixModuli, EndWhereTheStageIsNoSolid) {
  fine.tests = {linear_test(Load::shear, {-1e5, 1.0, 0.0}), linear_test(Load::bulk, {0.0, 0.0, 1.0})};
  const auto moduli = of_coarse();
  ASSERT_FALSE(moduli.empty());
  EXPECT_THAT(moduli.size(), Lt(path_of_binder().size()));
  for (const auto& at : moduli) EXPECT_GT(at.shear, 0.0);
}

// G' rises where G falls.
TEST_F(MatrixModuli, EndWhereTheyCeaseToFall) {
  fine.tests = {linear_test(Load::shear, {1e7, -1.0, 0.0}), linear_test(Load::bulk, {0.0, 0.0, 1.0})};
  EXPECT_EQ(of_coarse().size(), 1U);
}

TEST_F(MatrixModuli, AreNotKnownWithoutBothResponsesUnderTheBoundary) {
  fine.tests = {linear_test(Load::shear, {3.0, 2.0, 0.0})};
  EXPECT_THAT(of_coarse(), IsEmpty()) << "no bulk test";
  fine.tests.push_back(linear_test(Load::bulk, {1.0, 1.0, 0.8}));
  EXPECT_THAT(of_coarse(Boundary::traction), IsEmpty());
  fine.tests[1].record = QuasistaticRecord{};
  EXPECT_THAT(of_coarse(), IsEmpty()) << "stepped through time";
  EXPECT_THAT(matrix_moduli(study, study.stages[1], {}, Boundary::displacement), IsEmpty()) << "no result";
}

}  // namespace
}  // namespace breccia
