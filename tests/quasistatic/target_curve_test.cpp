// The accuracy in time of a composite that relaxes by orders of magnitude with the only time of its binder.

#include "breccia/quasistatic/target_curve.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "breccia/quasistatic/carson_path.hpp"
#include "breccia/quasistatic/sampling.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "quasistatic/composites.hpp"

namespace breccia {
namespace {

constexpr TimeWindow ten_relaxation_times = {1e-3, 0.1};

/// Modulus [Pa] of the model composite under tractions after ten relaxation times of its binder.
class RelaxedComposite : public testing::Test {
 protected:
  [[nodiscard]] ReducedResponse sampled(double tolerance, bool has_target) const {
    constexpr std::array loads = {Load::shear};
    auto path = matrix_path(0, carson_path(binder_, ten_relaxation_times));
    if (has_target) path.target = target_;
    SamplingOptions options;
    options.tolerance = tolerance;
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
  // At Laplace variables both meet the tolerance. Less than a hundredth of the unrelaxed modulus is left here.
  EXPECT_GT(std::abs(modulus_of(sampled(tolerance, false)) / exact - 1.0), 100.0 * tolerance);
  EXPECT_NEAR(modulus_of(sampled(tolerance, true)) / exact, 1.0, 10.0 * tolerance);
}

TEST_F(RelaxedComposite, ChangesWithTheLastVectorByAboutItsError) {
  const auto response = sampled(1e-4, false);
  const double error = std::abs(modulus_of(response) / modulus_of(sampled(1e-9, false)) - 1.0);
  EXPECT_GT(change_by_last_vector(response, target_), 0.5 * error);
  EXPECT_LT(change_by_last_vector(sampled(1e-9, false), target_), 1e-4);
}

}  // namespace
}  // namespace breccia
