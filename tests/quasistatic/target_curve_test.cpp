// Tests of the accuracy in time of a composite that relaxes by orders of magnitude with the only relaxation time of its
// binder.

#include "quasistatic/reduced/target_curve.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "breccia/viscoelasticity/interconversion.hpp"

#include "quasistatic/composites.hpp"
#include "quasistatic/reduced/carson_path.hpp"
#include "quasistatic/reduced/sampling.hpp"

namespace breccia {
namespace {

constexpr TimeWindow ten_relaxation_times = {1e-3, 0.1};

/// Modulus [Pa] of the model composite under tractions after ten relaxation times of its binder.
class RelaxedComposite : public testing::Test {
 protected:
  [[nodiscard]] ReducedResponse sampled(double tolerance, bool has_target) const {
    SamplingOptions options;
    options.tolerance = tolerance;
    return sampled(options, has_target);
  }
  [[nodiscard]] ReducedResponse sampled(const SamplingOptions& options, bool has_target) const {
    constexpr std::array loads = {Load::shear};
    auto path = matrix_path(0, carson_path(binder_, ten_relaxation_times));
    if (has_target) path.target = target_;
    return sample_responses(composite_, loads, path, options).responses.front();
  }
  [[nodiscard]] double modulus_of(const ReducedResponse& response) const {
    return relaxation_modulus(creep_compliance(response, binder_)).at(ten_relaxation_times.end);
  }

  QuasistaticProblem<2> composite_ = test::model_composite(12, Volumetric::averaged, Boundary::traction);
  Material binder_ = composite_.materials.front();
  TargetCurve target_ = {{binder_}, ten_relaxation_times};
};

TEST_F(RelaxedComposite, IsAccurateInTimeWithATarget) {
  constexpr double tolerance = 1e-4;
  const double exact = modulus_of(sampled(1e-9, false));
  // At Laplace variables both bases meet the tolerance. Here less than a hundredth of the unrelaxed modulus remains.
  EXPECT_GT(std::abs(modulus_of(sampled(tolerance, false)) / exact - 1.0), 100.0 * tolerance);
  EXPECT_NEAR(modulus_of(sampled(tolerance, true)) / exact, 1.0, 10.0 * tolerance);
}

// With no more snapshots than the tolerance takes at Laplace variables, the target is not a reason to fail.
TEST_F(RelaxedComposite, EndsWithAsManySnapshotsAsAllowed) {
  constexpr double tolerance = 1e-4;
  const auto without = sampled(tolerance, false);
  SamplingOptions options;
  options.tolerance = tolerance;
  options.most_snapshots = static_cast<int>(without.snapshots.size());
  EXPECT_EQ(modulus_of(sampled(options, true)), modulus_of(without));
  ++options.most_snapshots;
  EXPECT_EQ(sampled(options, true).snapshots.size(), without.snapshots.size() + 1);
}

TEST_F(RelaxedComposite, ChangesWithTheLastVectorByAboutItsError) {
  const auto response = sampled(1e-4, false);
  const double error = std::abs(modulus_of(response) / modulus_of(sampled(1e-9, false)) - 1.0);
  EXPECT_GT(change_by_last_vector(response, target_), 0.5 * error);
  EXPECT_LT(change_by_last_vector(sampled(1e-9, false), target_), 1e-4);
}

}  // namespace
}  // namespace breccia
