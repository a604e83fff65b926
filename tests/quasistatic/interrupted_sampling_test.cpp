#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "checkpoint/checkpoint.hpp"
#include "quasistatic/composites.hpp"
#include "quasistatic/reduced/carson_path.hpp"
#include "quasistatic/reduced/sampling.hpp"
#include "quasistatic/sphere_packings.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

/// Samples in runs that are ended again and again in the midst of their solutions, each after more looks than the one
/// before, so that it ends.
template <int dim>
SampledResponses<dim> sampled_bit_by_bit(const QuasistaticProblem<dim>& problem, const TrainingPath& path,
                                         int& interruptions) {
  const test::TemporaryDirectory directory;
  constexpr double never = std::numeric_limits<double>::infinity(), growth = 1.3;
  for (double most_looks = 0.0;; most_looks = std::max(3.0, growth * most_looks)) {
    int looks = 0;
    Checkpoint checkpoint(directory.path() / "sampling.checkpoint.h5", {"hash", "version"},
                          {.interval = never, .stop = [&] { return ++looks > most_looks; }});
    EXPECT_TRUE(checkpoint.look_for_earlier().empty());
    try {
      return sample_responses(problem, test::shear_and_bulk, path, {}, {}, &checkpoint);
    } catch (const Interrupted&) {
      ++interruptions;
    }
  }
}

template <int dim>
void expect_the_bits_of_one_run(const QuasistaticProblem<dim>& problem) {
  constexpr PhaseIndex matrix = 0;
  const auto path = matrix_path(matrix, carson_path(problem.materials.front(), test::relaxation_window));
  const auto whole = sample_responses(problem, test::shear_and_bulk, path);
  int interruptions = 0;
  const auto resumed = sampled_bit_by_bit(problem, path, interruptions);
  EXPECT_GT(interruptions, 3);
  for (std::size_t load = 0; load < whole.responses.size(); ++load) {
    const auto &one = whole.responses[load], &other = resumed.responses[load];
    ASSERT_EQ(one.snapshots.size(), other.snapshots.size());
    for (std::size_t i = 0; i < one.snapshots.size(); ++i) {
      EXPECT_EQ(one.snapshots[i].error_before, other.snapshots[i].error_before);
    }
    EXPECT_EQ(one.constant, other.constant);
    EXPECT_EQ(one.residual_products, other.residual_products);
    EXPECT_EQ(one.residual_scale, other.residual_scale);
  }
  EXPECT_EQ(whole.effort.unknowns, resumed.effort.unknowns);
  EXPECT_EQ(whole.effort.is_direct, resumed.effort.is_direct);
  EXPECT_EQ(whole.effort.solves, resumed.effort.solves);
  EXPECT_EQ(whole.effort.factorisations, resumed.effort.factorisations);
  EXPECT_EQ(whole.effort.iterations, resumed.effort.iterations);
  EXPECT_EQ(whole.effort.largest_residual, resumed.effort.largest_residual);
}

TEST(InterruptedSampling, GivesTheBitsOfOneRunInSquares) {
  auto problem = test::random_composite(24, 3, Boundary::displacement);
  for (const auto method : {LinearMethod::direct, LinearMethod::iterative}) {
    problem.linear.method = method;
    expect_the_bits_of_one_run(problem);
  }
}

TEST(InterruptedSampling, GivesTheBitsOfOneRunInCubes) {
  const auto box = test::cubic_array("bcc", 0.05);
  auto with_flow = test::spheres_with_gaps(box, 8, 1e3);
  with_flow.materials.front().shear = PronySeries(1.0, {{1e-5, 9.0}});
  with_flow.linear.method = LinearMethod::iterative;
  expect_the_bits_of_one_run(with_flow);
  auto in_series = with_flow;
  in_series.discretisation = discretise_mixed(box, 8, 0, std::vector<PhaseIndex>{1, 1}, 2);
  expect_the_bits_of_one_run(in_series);
}

// Without a checkpoint the observer is called in the iterations, and an exception that it throws ends the solution.
TEST(InterruptedSampling, AnObserverEndsASolution) {
  auto problem = test::random_composite(24, 3, Boundary::displacement);
  for (const auto method : {LinearMethod::direct, LinearMethod::iterative}) {
    problem.linear.method = method;
    const auto path = matrix_path(0, carson_path(problem.materials.front(), test::relaxation_window));
    const ProgressObserver ending = [](const Progress& now) {
      if (now.details.find("iteration") != std::string::npos) throw Interrupted("enough");
    };
    EXPECT_THROW(sample_responses(problem, test::shear_and_bulk, path, {}, ending), Interrupted);
  }
}

}  // namespace
}  // namespace breccia
