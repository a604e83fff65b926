#include "breccia/assessment/find_input.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <variant>

#include "assessment/latin_hypercube.hpp"
#include "assessment/polynomial_model.hpp"
#include "assessment/spread.hpp"

namespace breccia {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Scores of an input from one end of its range to the other, at equal shares of its distribution.
Eigen::VectorXd searched_scores(const Distribution& known, const Eigen::RowVectorXd& sampled) {
  constexpr Eigen::Index count = 65;
  const bool has_ends = std::holds_alternative<Uniform>(known) || std::holds_alternative<LogUniform>(known);
  const double last = has_ends ? normal_share(most_score) : normal_share(sampled.cwiseAbs().maxCoeff());
  Eigen::VectorXd scores = Eigen::VectorXd::LinSpaced(count, 1.0 - last, last);
  for (double& score : scores) score = normal_score(score);
  return scores;
}

/// How far a composite is from what is wanted: the logarithm of the ratio to a modulus, the difference from a phase.
class Gap {
 public:
  Gap(const PredictiveModel& model, std::size_t sought)
      : model_(model), wanted_(model.observations().front()), sought_(static_cast<Eigen::Index>(sought)) {}

  /// The gap with a score of the sought input, beside those of the others.
  [[nodiscard]] double at(Eigen::VectorXd scores, double score) const {
    constexpr double least = 1e-30;
    scores[sought_] = score;
    const double value = model_.predictions(scores)[0];
    return is_phase() ? value - wanted_.value : std::log(std::max(value / wanted_.value, least));
  }
  [[nodiscard]] Eigen::VectorXd along(const Eigen::VectorXd& grid, const Eigen::VectorXd& scores) const {
    Eigen::VectorXd gaps(grid.size());
    for (Eigen::Index i = 0; i < grid.size(); ++i) gaps[i] = at(scores, grid[i]);
    return gaps;
  }
  /// The value of the composite at a gap.
  [[nodiscard]] double value(double gap) const {
    return is_phase() ? wanted_.value + gap : wanted_.value * std::exp(gap);
  }
  /// The score of the input between two whose gaps have different signs, by bisection.
  [[nodiscard]] double root(const Eigen::VectorXd& scores, double low, double high) const {
    constexpr int halvings = 50;
    const bool rises = at(scores, low) < 0.0;
    for (int i = 0; i < halvings; ++i) {
      const double middle = 0.5 * (low + high);
      ((at(scores, middle) < 0.0) == rises ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

 private:
  [[nodiscard]] bool is_phase() const { return wanted_.curve == ObservedCurve::phase; }

  const PredictiveModel& model_;
  const Observation& wanted_;
  Eigen::Index sought_;
};

/// Whether the sign of a gap changes between a place of a grid and the next one.
bool changes_sign(const Eigen::VectorXd& gaps, Eigen::Index place) {
  return (gaps[place] < 0.0) != (gaps[place + 1] < 0.0);
}

/// The score nearest to another at which gaps along a grid change their sign; where they do not, infinite beyond that
/// end of the grid at which the gap is smaller.
double nearest_root(const Eigen::VectorXd& grid, const Eigen::VectorXd& gaps, double score) {
  const auto last = gaps.size() - 1;
  double nearest = std::abs(gaps[last]) < std::abs(gaps[0]) ? infinity : -infinity;
  for (Eigen::Index i = 0; i < last; ++i) {
    if (!changes_sign(gaps, i)) continue;
    const double root = std::lerp(grid[i], grid[i + 1], gaps[i] / (gaps[i] - gaps[i + 1]));
    if (std::isinf(nearest) || std::abs(root - score) < std::abs(nearest - score)) nearest = root;
  }
  return nearest;
}

/// Scores of everything that is uncertain (scores x draws), and in the last row those of the noise of what is wanted.
Eigen::MatrixXd drawn_scores(Eigen::Index size) {
  constexpr Eigen::Index draws = 1000;
  constexpr std::uint64_t seed = 5;
  const std::vector<UncertainInput> scores(static_cast<std::size_t>(size + 1),
                                           {"score", "", Distribution(Normal{0.0, 1.0})});
  return latin_hypercube(scores, draws, seed);
}

}  // namespace

FoundInput find_input(const std::vector<UncertainInput>& inputs, std::size_t sought, const AssessmentDesign& design,
                      const std::vector<SampledCurve>& curves, const Observation& wanted, double model_deviation) {
  const PolynomialModel model(inputs, design, curves, {wanted}, model_deviation);
  const Gap gap(model, sought);
  const auto& known = std::get<Distribution>(inputs[sought].known);
  const auto grid = searched_scores(known, design.coordinates.row(static_cast<Eigen::Index>(sought)));

  FoundInput found;
  const Eigen::VectorXd medians = Eigen::VectorXd::Zero(model.size());
  const auto gaps = gap.along(grid, medians);
  for (Eigen::Index i = 0; i + 1 < grid.size(); ++i) {
    if (changes_sign(gaps, i)) found.scores.push_back(gap.root(medians, grid[i], grid[i + 1]));
  }

  const auto draws = drawn_scores(model.size());
  const double noise = model.observations().front().deviation;
  Eigen::MatrixXd drawn_gaps(grid.size(), draws.cols());
  for (Eigen::Index draw = 0; draw < draws.cols(); ++draw) {
    drawn_gaps.col(draw) =
        gap.along(grid, draws.col(draw).head(model.size())).array() + noise * draws(model.size(), draw);
  }
  for (Eigen::Index i = 0; i < grid.size(); ++i) {
    const auto ends = spread_of(drawn_gaps.row(i)).interval;
    found.points.push_back({.input = value_at_score(known, grid[i]),
                            .value = gap.value(gaps[i]),
                            .interval = {gap.value(ends.lower), gap.value(ends.upper)}});
  }
  if (found.scores.empty()) return found;

  Eigen::VectorXd roots(draws.cols());
  for (Eigen::Index draw = 0; draw < draws.cols(); ++draw) {
    roots[draw] = nearest_root(grid, drawn_gaps.col(draw), found.scores.front());
  }
  const auto ends = spread_of(roots).interval;
  found.lower = ends.lower;
  found.upper = ends.upper;
  found.without = roots.array().isInf().cast<double>().mean();
  return found;
}

}  // namespace breccia
