#include "quasistatic/reduced/condensed_vectors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "checkpoint/checkpoint.hpp"
#include "composites.hpp"
#include "discretisation/mixed_cells.hpp"
#include "quasistatic/operator/vector_values.hpp"
#include "quasistatic/reduced/cell_composite.hpp"
#include "temporary_directory.hpp"

namespace breccia::quasistatic {
namespace {

const std::vector<Material> materials = {{"soft", 1.0, PronySeries(3.0), PronySeries(1.0)},
                                         {"hard", 1.0, PronySeries(40.0), PronySeries(30.0)}};

QuasistaticProblem<3> sphere(Boundary boundary) {
  const Microstructure<3> box = {1.0, Walls::hard, {{{0.47, 0.52, 0.55}, 0.6}}};
  constexpr std::array<PhaseIndex, 1> of_sphere = {1};
  return {.discretisation = discretise_mixed(box, 6, 0, of_sphere, 2), .materials = materials, .boundary = boundary};
}

std::vector<double> values_of(Vec vector) {
  PetscInt size = 0;
  check(VecGetLocalSize(vector, &size), "reading the size of a vector");
  const ReadValues values(vector);
  return {values.data(), values.data() + size};
}

std::vector<double> strains_of(const Displacement& displacement) {
  return values_of(displacement.phase_strains());
}

double largest_difference(const std::vector<double>& some, const std::vector<double>& others) {
  double largest = 0.0;
  for (std::size_t i = 0; i < some.size(); ++i) largest = std::max(largest, std::abs(some[i] - others.at(i)));
  return largest;
}

/// A sphere under one boundary condition, and three vectors: the uniform strain, and sums of a solution and of the
/// earlier vectors, stored with and without the strains of their phases.
class CondensedSphere {
 public:
  explicit CondensedSphere(Boundary boundary)
      : composite_(sphere(boundary), std::vector<VaryingPhase>{{0, "soft"}}),
        condensed_(composite_.no_vectors(load)),
        empty_(composite_.no_vectors(load)) {
    CellSolver<3> solver(composite_, {.method = LinearMethod::direct});
    add(composite_.uniform_strain(load), {});
    for (const auto& parameters : std::vector<std::vector<double>>{{0.1, 2.0}, {5.0, 9.0}}) {
      solver.prepare(parameters);
      auto vector = solver.solve(load, composite_.zero());
      vector.scale(1.7);
      Eigen::VectorXd of_earlier(static_cast<Eigen::Index>(whole_.size()));
      of_earlier.setLinSpaced(-1.3, 0.4);
      whole_.add_to(vector, of_earlier);
      add(std::move(vector), {parameters, of_earlier});
    }
  }

  [[nodiscard]] const CellComposite<3>& composite() const { return composite_; }
  [[nodiscard]] const StoredVectors<Displacement>& whole() const { return whole_; }
  [[nodiscard]] const CondensedVectors& condensed() const { return condensed_; }
  [[nodiscard]] CondensedVectors& empty() { return empty_; }

  static constexpr auto load = Load::shear_zx;

 private:
  void add(Displacement vector, const VectorOrigin& origin) {
    condensed_.add(vector.copy(), origin);
    whole_.add(std::move(vector), origin);
  }

  CellComposite<3> composite_;
  StoredVectors<Displacement> whole_;
  CondensedVectors condensed_, empty_;
};

TEST(CondensedVectors, HaveTheStrainsOfPhasesThatTheyDoNotKeep) {
  for (const auto boundary : test::boundaries) {
    const CondensedSphere sphere(boundary);
    ASSERT_EQ(sphere.condensed().size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto found = sphere.condensed().at(i);
      const auto expected = strains_of(sphere.whole().at(i));
      ASSERT_GT(expected.size(), 18U);
      EXPECT_LT(largest_difference(strains_of(found), expected), 1e-11) << i;
      EXPECT_EQ(found.macroscopic(), sphere.whole().at(i).macroscopic());
    }
  }
}

TEST(CondensedVectors, DoTheWorkOfWholeOnes) {
  for (const auto boundary : test::boundaries) {
    const CondensedSphere sphere(boundary);
    const std::vector<double> parameters = {0.7, 4.0};
    const auto forces = sphere.composite().forces(parameters, CondensedSphere::load, sphere.whole().at(2));
    const auto found = sphere.condensed().works(forces), expected = sphere.whole().works(forces);
    EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 1e-11 * expected.cwiseAbs().maxCoeff());
    const Eigen::VectorXd weights{{2.0, -0.5, 3.0}};
    auto sum = sphere.composite().zero(), whole_sum = sphere.composite().zero();
    sphere.condensed().add_to(sum, weights);
    sphere.whole().add_to(whole_sum, weights);
    EXPECT_NEAR(work(forces, sum), work(forces, whole_sum), 1e-11 * std::abs(work(forces, whole_sum)));
  }
}

// A solution that nearly equals another one, like those of close snapshots: the remainder after orthogonalisation is
// normalised.
TEST(CondensedVectors, HoldWhereTheyAreNearlyDependent) {
  constexpr double apart = 1e-6;
  const CellComposite<3> composite(sphere(Boundary::periodic), std::vector<VaryingPhase>{{0, "soft"}});
  constexpr auto load = CondensedSphere::load;
  CellSolver<3> solver(composite, {.method = LinearMethod::direct, .tolerance = 1e-14});
  auto condensed = composite.no_vectors(load);
  StoredVectors<Displacement> whole;
  for (const double shear : {2.0, 2.0 * (1.0 + apart), 2.0 * (1.0 + 2.0 * apart)}) {
    const std::vector<double> parameters = {shear, 4.0};
    solver.prepare(parameters);
    auto vector = solver.solve(load, composite.zero());
    Eigen::VectorXd of_earlier = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(whole.size()));
    if (whole.size() > 0) {
      of_earlier[0] = -1.0 / apart;
      vector.scale(1.0 / apart);
      vector.add(of_earlier[0], whole.at(0));
    }
    condensed.add(vector.copy(), {parameters, of_earlier});
    whole.add(std::move(vector), {parameters, of_earlier});
  }
  // The remaining strains have lost as many digits.
  constexpr double rounding = 1e-15 / apart;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const auto expected = strains_of(whole.at(i));
    const double largest = std::abs(*std::ranges::max_element(expected, {}, [](double x) { return std::abs(x); }));
    EXPECT_LT(largest_difference(strains_of(condensed.at(i)), expected), 100.0 * rounding * largest) << i;
  }
  const auto forces = composite.forces(std::vector<double>{0.7, 4.0}, load, whole.at(0));
  const auto found = condensed.works(forces), expected = whole.works(forces);
  EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 100.0 * rounding * expected.cwiseAbs().maxCoeff());
}

TEST(CondensedVectors, RefuseAStateThatTheyCannotHaveSaved) {
  const test::TemporaryDirectory directory;
  CondensedSphere sphere(Boundary::periodic);
  const auto zero = [&] { return sphere.composite().zero(); };
  const auto path = directory.path() / "state.h5";
  const auto save = [&](const std::vector<double>& of_earlier, const std::vector<double>& parameters) {
    StateWriter writer(path, {"deck", "version"});
    writer.write("/basis/vectors", std::int64_t{1});
    quasistatic::save(writer, "/basis/vector/0", sphere.whole().at(0));
    writer.write("/basis/vector/0/of_earlier", of_earlier);
    writer.write("/basis/vector/0/parameters", parameters);
    writer.commit();
  };
  save({}, {2.0, 4.0});
  EXPECT_NO_THROW(sphere.empty().restore(StateReader(path), "/basis", zero));
  save({1.0}, {2.0, 4.0});
  EXPECT_THROW(sphere.empty().restore(StateReader(path), "/basis", zero), FileError) << "there are none before it";
  save({}, {2.0});
  EXPECT_THROW(sphere.empty().restore(StateReader(path), "/basis", zero), FileError) << "two moduli vary";
}

TEST(CondensedVectors, KeepTheirBitsInAState) {
  const test::TemporaryDirectory directory;
  CondensedSphere sphere(Boundary::periodic);
  StateWriter writer(directory.path() / "state.h5", {"deck", "version"});
  sphere.condensed().save(writer, "/basis");
  writer.commit();
  sphere.empty().restore(StateReader(directory.path() / "state.h5"), "/basis",
                         [&] { return sphere.composite().zero(); });
  ASSERT_EQ(sphere.empty().size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(strains_of(sphere.empty().at(i)), strains_of(sphere.condensed().at(i))) << i;
    EXPECT_EQ(values_of(sphere.empty().at(i).fluctuation()), values_of(sphere.condensed().at(i).fluctuation())) << i;
  }
}

}  // namespace
}  // namespace breccia::quasistatic
