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

namespace breccia {
namespace {

std::vector<UncertainInput> inputs_that(bool change, const std::vector<bool>& change_the_box,
                                        const std::vector<UncertainInput>& inputs) {
  std::vector<UncertainInput> chosen;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (change_the_box[i] == change) chosen.push_back(inputs[i]);
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

/// Twice the number of polynomials of degree 2 in so many inputs, ten at least: with fewer boxes their coefficients
/// hang on single boxes.
std::size_t boxes_for(std::size_t inputs) {
  constexpr std::size_t fewest = 10;
  return std::max(fewest, (inputs + 1) * (inputs + 2));
}

/// The coordinates of boxes by those inputs that change them.
Eigen::MatrixXd boxes_of(const std::vector<UncertainInput>& inputs, const AssessmentOptions& options) {
  if (inputs.empty()) return Eigen::MatrixXd(0, 1);
  const auto count = options.boxes > 0 ? static_cast<std::size_t>(options.boxes) : boxes_for(inputs.size());
  auto all = all_combinations(inputs, count);
  return all.size() > 0 ? all : latin_hypercube(inputs, static_cast<Eigen::Index>(count), options.seed);
}

/// An interval of a modulus about its median with an error [-] added, of independent causes (theory, Eq. 86).
Interval widened(const Interval& interval, double median, double error) {
  const auto beyond = [error](double ratio) { return std::exp(std::hypot(std::log(ratio), std::log1p(error))); };
  return {median / beyond(median / interval.lower), median * beyond(interval.upper / median)};
}

AssessedCurve assessed(const std::vector<UncertainInput>& inputs, const AssessmentDesign& design,
                       const SampledCurve& curve, const Eigen::MatrixXd& points) {
  const PolynomialChaos polynomials(inputs, followed_samples(design, curve));
  AssessedCurve found = {.name = curve.name,
                         .unit = curve.unit,
                         .at = curve.at,
                         .reference = curve.reference,
                         .errors = curve.errors,
                         .alone = polynomials.first_order(),
                         .total = polynomials.total()};
  const auto values = polynomials.at(points);
  const auto in_unit = [&](double value) { return curve.curve == ObservedCurve::phase ? value : std::exp(value); };
  const auto variances = polynomials.variances();
  for (std::size_t i = 0; i < curve.at.size(); ++i) {
    const auto output = static_cast<Eigen::Index>(i);
    const auto [middle, interval] = spread_of(values.row(output));
    found.median.push_back(in_unit(middle));
    found.of_inputs.push_back({in_unit(interval.lower), in_unit(interval.upper)});
    found.whole.emplace_back();
    if (curve.errors[i]) found.whole.back() = widened(found.of_inputs.back(), found.median.back(), *curve.errors[i]);
    const double missed = polynomials.mean_square_errors()[output];
    found.unexplained.push_back(missed > 0.0 ? missed / (missed + variances[output]) : 0.0);
  }
  return found;
}

/// A warning where the polynomials miss more of the variance of a curve than the shares are worth.
std::string warning_on(const AssessedCurve& curve) {
  constexpr double most = 0.1;
  const double worst = std::ranges::max(curve.unexplained);
  if (worst <= most) return "";
  return fmt::format(
      "{}: polynomials in the inputs do not predict up to {:.0f} % of its variance (packings scatter, or there are too "
      "few boxes or samples): shares below that mean nothing",
      curve.name, 100.0 * worst);
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
  const auto of_boxes = boxes_of(inputs_that(true, change_the_box, inputs), options);
  const auto boxes = of_boxes.cols();
  const bool have_samples = std::ranges::find(change_the_box, false) != change_the_box.end();
  // As many samples in every box.
  const Eigen::Index in_a_box = have_samples ? (options.samples + boxes - 1) / boxes : 1;
  const auto size = static_cast<Eigen::Index>(inputs.size());
  AssessmentDesign design = {.change_the_box = change_the_box,
                             .boxes = Eigen::MatrixXd::Zero(size, boxes),
                             .coordinates = latin_hypercube(inputs, in_a_box * boxes, options.seed + 1),
                             .box_of = {}};
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

Assessment assess(const std::vector<UncertainInput>& inputs, const AssessmentDesign& design,
                  const std::vector<SampledCurve>& curves) {
  constexpr Eigen::Index points_of_bands = 10'000;
  constexpr std::uint64_t seed_of_bands = 3;
  const auto points = latin_hypercube(inputs, points_of_bands, seed_of_bands);
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
