#include "quasistatic/operator/displacement.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "checkpoint/state.hpp"
#include "quasistatic/operator/displacement_state.hpp"
#include "quasistatic/operator/elastic_operator.hpp"
#include "quasistatic/operator/square_forces.hpp"
#include "quasistatic/operator/vector_values.hpp"
#include "temporary_directory.hpp"

namespace breccia::quasistatic {
namespace {

class Displacements : public testing::Test {
 protected:
  /// Displacement of the 3 x 2 nodes of two cells, with the fluctuation 1, 2, ... times a factor.
  [[nodiscard]] Displacement rising(double macroscopic, double factor) const {
    auto displacement = elastic_operator_.zero();
    displacement.set_macroscopic(macroscopic);
    double* values = nullptr;
    check(VecGetArray(displacement.fluctuation(), &values), "writing");
    for (int i = 0; i < 12; ++i) values[i] = factor * (i + 1);
    check(VecRestoreArray(displacement.fluctuation(), &values), "writing");
    return displacement;
  }
  [[nodiscard]] static std::vector<double> values(const Displacement& displacement) {
    const double* values = nullptr;
    check(VecGetArrayRead(displacement.fluctuation(), &values), "reading");
    std::vector<double> copy(values, values + 12);
    check(VecRestoreArrayRead(displacement.fluctuation(), &values), "reading");
    return copy;
  }

  ElasticOperator<2> elastic_operator_{Discretisation<2>(Grid<2>{{2, 1}, 1.0}), Volumetric::averaged,
                                       Boundary::traction};
};

TEST_F(Displacements, AddAndScaleBothParts) {
  auto sum = rising(2.0, 1.0);
  sum.add(-3.0, rising(0.5, 2.0));
  EXPECT_EQ(sum.macroscopic(), 0.5);
  EXPECT_EQ(values(sum), values(rising(0.0, -5.0)));
  sum.scale(-2.0);
  EXPECT_EQ(sum.macroscopic(), -1.0);
  EXPECT_EQ(values(sum), values(rising(0.0, 10.0)));
  sum.set_zero();
  EXPECT_EQ(sum.macroscopic(), 0.0);
  EXPECT_EQ(values(sum), std::vector<double>(12, 0.0));
}

TEST_F(Displacements, AreCopiedByValue) {
  const auto original = rising(2.0, 1.0);
  auto copy = original.copy();
  copy.scale(7.0);
  EXPECT_EQ(original.macroscopic(), 2.0);
  EXPECT_EQ(values(original), values(rising(0.0, 1.0)));
  EXPECT_EQ(original.zero().macroscopic(), 0.0);
  EXPECT_EQ(values(original.zero()), std::vector<double>(12, 0.0));
}

TEST_F(Displacements, ForcesDoWorkOnBothParts) {
  // 1 + 4 + 9 + ... + 144 = 650
  EXPECT_EQ(work(rising(3.0, 2.0), rising(-4.0, 1.0)), 2.0 * 650.0 - 12.0);
}

TEST_F(Displacements, KeepTheirBitsInAState) {
  const test::TemporaryDirectory directory;
  const auto path = directory.path() / "state.h5";
  const auto saved = rising(0.1, 1.0 / 3.0);
  StateWriter writer(path, {"deck", "version"});
  save(writer, "/displacement", saved);
  writer.commit();
  const StateReader reader(path);
  auto restored = elastic_operator_.zero();
  restore(reader, "/displacement", restored);
  EXPECT_EQ(restored.macroscopic(), 0.1);
  EXPECT_EQ(values(restored), values(saved));

  const ElasticOperator<2> larger(Discretisation<2>(Grid<2>{{3, 1}, 1.0}), Volumetric::averaged, Boundary::traction);
  auto too_large = larger.zero();
  EXPECT_THROW(restore(reader, "/displacement", too_large), FileError);
}

TEST_F(Displacements, KeepTheStrainsOfPhasesInAState) {
  const test::TemporaryDirectory directory;
  Discretisation<2> box(Grid<2>{{2, 1}, 1.0});
  box.fill({1, 0}, box.add_mixture({{0, 0.25}, {1, 0.75}}, 2));
  const ElasticOperator<2> mixed(box, Volumetric::averaged, Boundary::displacement);
  const auto strains_of = [](const Displacement& displacement) {
    const ReadValues read(displacement.phase_strains());
    return std::vector<double>(read.data(), read.data() + CellShape<2>::modes);
  };
  const auto saved = mixed.uniform_strain(Load::shear);
  StateWriter writer(directory.path() / "state.h5", {"deck", "version"});
  save(writer, "/displacement", saved);
  writer.commit();
  auto restored = mixed.zero();
  restore(StateReader(directory.path() / "state.h5"), "/displacement", restored);
  EXPECT_EQ(strains_of(restored), strains_of(saved));
  EXPECT_NE(strains_of(saved), strains_of(mixed.zero()));
  // Two phases that strain alike are in parallel: the work of their forces is the arithmetic mean of the moduli.
  const std::vector<Moduli> moduli = {{.bulk = 5.0, .shear = 1.0}, {.bulk = 9.0, .shear = 3.0}};
  EXPECT_NEAR(work(forces_under(mixed, moduli, saved, unit_strain<2>(Load::shear)), saved),
              1.0 + 0.25 * 1.0 + 0.75 * 3.0, 1e-14);
}

}  // namespace
}  // namespace breccia::quasistatic
