#include "breccia/assessment/assess.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "assessment/latin_hypercube.hpp"
#include "assessment/polynomial_chaos.hpp"
#include "assessment/spread.hpp"
#include "io/display.hpp"

namespace breccia {
namespace {

/// The inputs that change the box.
std::vector<UncertainInput> inputs_of_boxes(const std::vector<UncertainInput>& inputs,
                                            const std::vector<bool>& change_the_box) {
  std::vector<UncertainInput> chosen;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (change_the_box[i]) chosen.push_back(inputs[i]);
  }
  return chosen;
}

/// All combinations of the choices of inputs (inputs x combinations); empty where one has a distribution, or where
/// there are more than `most`.
Eigen::MatrixXd all_combinations(const std::vector<UncertainInput>& inputs, std::size_t most) {
  std::size_t count = 1;
  for (const auto& input : inputs) {
    count *= choices_of(input);
    if (count == 0 || count > most) return {};
  }
  Eigen::MatrixXd coordinates(static_cast<Eigen::Index>(inputs.size()), static_cast<Eigen::Index>(count));
  std::size_t stride = 1;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    for (std::size_t c = 0; c < count; ++c) {
      coordinates(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(c)) =
          static_cast<double>(c / stride % choices_of(inputs[i]));
    }
    stride *= choices_of(inputs[i]);
  }
  return coordinates;
}

/// Twice the number of polynomials of degree 2 in distributions, and of degree 1 in choices, ten at least: with fewer
/// boxes their coefficients hang on single boxes.
std::size_t boxes_for(const std::vector<UncertainInput>& inputs) {
  constexpr std::size_t fewest = 10;
  std::size_t linear = 0, distributions = 0;
  for (const auto& input : inputs) {
    const auto choices = choices_of(input);
    linear += choices > 0 ? choices - 1 : 1;
    distributions += choices > 0 ? 0 : 1;
  }
  return std::max(fewest, 2 * (1 + linear) + distributions * (distributions + 1));
}

/// The points at which polynomials are taken for bands (inputs x points), and scores of the error of the model there.
struct PointsOfBands {
  Eigen::MatrixXd coordinates;
  Eigen::RowVectorXd scores_of_error;
};

PointsOfBands points_of_bands(const std::vector<UncertainInput>& inputs) {
  constexpr Eigen::Index count = 10'000;
  constexpr std::uint64_t seed = 3;
  auto with_error = inputs;
  with_error.push_back({"error of the model", "", Distribution(Normal{0.0, 1.0})});
  const auto all = latin_hypercube(with_error, count, seed);
  return {all.topRows(all.rows() - 1), all.bottomRows(1)};
}

/// The curves times a log-normal factor whose 95 % reach to 1 + error (theory, Eq. 86), for the logarithms of curves.
Interval with_error(const Eigen::RowVectorXd& logarithms, const PointsOfBands& points, double error) {
  const double deviation = std::log1p(error) / normal_score(0.975);
  const auto [median, interval] = spread_of(logarithms + deviation * points.scores_of_error);
  return {std::exp(interval.lower), std::exp(interval.upper)};
}

/// Keeps the values of polynomials between those of the samples, which answer all inputs.
void keep_within_samples(Eigen::MatrixXd& values, const Eigen::MatrixXd& samples) {
  for (Eigen::Index output = 0; output < values.rows(); ++output) {
    const double least = samples.row(output).minCoeff(), most = samples.row(output).maxCoeff();
    values.row(output) = values.row(output).cwiseMax(least).cwiseMin(most);
  }
}

AssessedCurve assessed(const std::vector<UncertainInput>& inputs, const AssessmentDesign& design,
                       const SampledCurve& curve, const PointsOfBands& points) {
  const auto samples = followed_samples(design, curve);
  const PolynomialChaos polynomials(inputs, samples);
  AssessedCurve found = {.name = curve.name,
                         .unit = curve.unit,
                         .curve = curve.curve,
                         .at = curve.at,
                         .reference = curve.reference,
                         .errors = curve.errors,
                         .alone = polynomials.first_order(),
                         .total = polynomials.total()};
  auto values = polynomials.at(points.coordinates);
  if (design.boxes.cols() == 1) keep_within_samples(values, samples.values);
  const auto in_unit = [&](double value) { return curve.curve == ObservedCurve::phase ? value : std::exp(value); };
  const auto variances = polynomials.variances();
  for (std::size_t i = 0; i < curve.at.size(); ++i) {
    const auto output = static_cast<Eigen::Index>(i);
    const auto [middle, interval] = spread_of(values.row(output));
    found.median.push_back(in_unit(middle));
    found.of_inputs.push_back({in_unit(interval.lower), in_unit(interval.upper)});
    found.whole.emplace_back();
    if (curve.errors[i]) found.whole.back() = with_error(values.row(output), points, *curve.errors[i]);
    const double missed = polynomials.mean_square_errors()[output];
    found.unexplained.push_back(missed > 0.0 ? missed / (missed + variances[output]) : 0.0);
  }
  return found;
}

/// Whether 95 % of the curves differ by more than 1 % at a place, or phases by more than 0.01 rad.
bool differs(const AssessedCurve& curve, std::size_t index) {
  constexpr double least = 0.01;
  const auto& [lower, upper] = curve.of_inputs[index];
  return curve.curve == ObservedCurve::phase ? upper - lower > least : upper > (1.0 + least) * lower;
}

/// A warning where the polynomials miss more of the variance of a curve than the shares are worth.
std::string warning_on(const AssessedCurve& curve) {
  constexpr double most = 0.1;
  double worst = 0.0;
  std::size_t at = 0;
  for (std::size_t i = 0; i < curve.at.size(); ++i) {
    if (!differs(curve, i) || curve.unexplained[i] <= worst) continue;
    worst = curve.unexplained[i];
    at = i;
  }
  if (worst <= most) return "";
  return fmt::format(
      "{}: polynomials in the inputs do not predict up to {:.0f} % of its variance, at {} (packings scatter, or there "
      "are too few boxes or samples): shares below that mean nothing there",
      curve.name, 100.0 * worst,
      is_over_frequency(curve.curve) ? fmt::format("{:.3g} rad/s", curve.at[at]) : display_time(curve.at[at]));
}

}  // namespace

AssessmentDesign design_samples(const std::vector<UncertainInput>& inputs, const std::vector<bool>& change_the_box,
                                const AssessmentOptions& options) {
  constexpr int fewest_samples = 100;
  if (options.samples < fewest_samples) {
    throw InputError(fmt::format("samples: expected {} or more, got {}", fewest_samples, options.samples));
  }
  if (options.boxes < 0 || options.boxes == 1) {
    throw InputError(
        fmt::format("boxes: expected 2 or more, or 0 for as many as the inputs need, got {}", options.boxes));
  }
  const auto box_inputs = inputs_of_boxes(inputs, change_the_box);
  const auto wanted = options.boxes > 0 ? static_cast<std::size_t>(options.boxes) : boxes_for(box_inputs);
  auto of_boxes = all_combinations(box_inputs, wanted);
  const bool has_all_boxes = !box_inputs.empty() && of_boxes.size() > 0;
  if (box_inputs.empty()) of_boxes = Eigen::MatrixXd(0, 1);
  if (of_boxes.cols() == 0) of_boxes = latin_hypercube(box_inputs, static_cast<Eigen::Index>(wanted), options.seed);
  const auto boxes = of_boxes.cols();
  const bool have_samples = std::ranges::find(change_the_box, false) != change_the_box.end();
  // As many samples in every box. Of boxes that are all there are, a few equal ones let polynomials take each of them.
  constexpr Eigen::Index equal_samples = 4;
  Eigen::Index in_a_box = has_all_boxes ? equal_samples : 1;
  if (have_samples) in_a_box = std::max(in_a_box, (options.samples + boxes - 1) / boxes);
  const auto size = static_cast<Eigen::Index>(inputs.size());
  AssessmentDesign design = {.change_the_box = change_the_box,
                             .boxes = Eigen::MatrixXd::Zero(size, boxes),
                             .coordinates = latin_hypercube(inputs, in_a_box * boxes, options.seed + 1),
                             .box_of = {},
                             .has_all_boxes = has_all_boxes};
  Eigen::Index row = 0;
  for (Eigen::Index input = 0; input < size; ++input) {
    if (change_the_box[static_cast<std::size_t>(input)]) design.boxes.row(input) = of_boxes.row(row++);
  }
  for (Eigen::Index sample = 0; sample < design.coordinates.cols(); ++sample) {
    const auto box = sample % boxes;
    design.box_of.push_back(static_cast<std::size_t>(box));
    for (Eigen::Index input = 0; input < size; ++input) {
      if (change_the_box[static_cast<std::size_t>(input)]) {
        design.coordinates(input, sample) = design.boxes(input, box);
      }
    }
  }
  return design;
}

bool has_shares(const AssessedCurve& curve, std::size_t index) {
  constexpr double most = 0.5;
  return differs(curve, index) && curve.unexplained[index] <= most;
}

std::vector<double> interactions_of(const AssessedCurve& curve) {
  std::vector<double> shares;
  for (Eigen::Index i = 0; i < curve.alone.cols(); ++i) {
    const double alone = curve.alone.col(i).sum();
    shares.push_back(alone > 0.0 || curve.total.col(i).sum() > 0.0 ? std::max(1.0 - alone, 0.0) : 0.0);
  }
  return shares;
}

Assessment assess(const std::vector<UncertainInput>& inputs, const AssessmentDesign& design,
                  const std::vector<SampledCurve>& curves) {
  const auto points = points_of_bands(inputs);
  Assessment assessment = {.inputs = inputs,
                           .curves = {},
                           .samples = design.box_of.size(),
                           .boxes = static_cast<std::size_t>(design.boxes.cols()),
                           .warnings = {}};
  if (const auto boundary = curves.front().boundary; boundary != Boundary::periodic) {
    assessment.warnings.push_back(
        fmt::format("the curves are the apparent moduli of the box under the boundary {}", name_of(boundary)));
  }
  for (const auto& curve : curves) {
    assessment.curves.push_back(assessed(inputs, design, curve, points));
    if (auto warning = warning_on(assessment.curves.back()); !warning.empty()) {
      assessment.warnings.push_back(std::move(warning));
    }
  }
  return assessment;
}

}  // namespace breccia
