#include "assessment/polynomial_chaos.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/QR>

namespace breccia {
namespace {

constexpr int highest_degree = 10;

/// The orthonormal functions of an input at a coordinate, from the constant to the last. Each is one of the functions
/// of an input by its degree; the contrasts of choices are all of degree 1.
struct FunctionsAt {
  double coordinate;

  /// Hermite's polynomials of a score, He_k / sqrt(k!).
  std::vector<double> operator()(const Normal& /*known*/) const { return hermite(); }
  std::vector<double> operator()(const LogNormal& /*known*/) const { return hermite(); }
  /// Legendre's polynomials of a share, sqrt(2 k + 1) P_k.
  std::vector<double> operator()(const Uniform& /*known*/) const { return legendre(); }
  std::vector<double> operator()(const LogUniform& /*known*/) const { return legendre(); }
  /// Distributions are variants themselves.
  std::vector<double> operator()(const Distribution& known) const { return std::visit(*this, known); }
  /// Helmert's contrasts: the k-th compares choice k with the mean of those before it.
  std::vector<double> operator()(const Choices& known) const {
    const auto count = static_cast<double>(known.values.size());
    std::vector<double> values = {1.0};
    for (double k = 1.0; k < count; ++k) {
      const double scale = std::sqrt(count / (k * (k + 1.0)));
      values.push_back(coordinate < k ? -scale : coordinate == k ? k * scale : 0.0);
    }
    return values;
  }

 private:
  [[nodiscard]] std::vector<double> hermite() const {
    std::vector<double> values = {1.0, coordinate};
    for (int k = 1; k < highest_degree; ++k) {
      const auto last = static_cast<std::size_t>(k);
      values.push_back((coordinate * values[last] - std::sqrt(k) * values[last - 1]) / std::sqrt(k + 1.0));
    }
    return values;
  }
  [[nodiscard]] std::vector<double> legendre() const {
    const double x = 2.0 * normal_share(coordinate) - 1.0;
    std::vector<double> values = {1.0, x};
    for (int k = 1; k < highest_degree; ++k) {
      const auto last = static_cast<std::size_t>(k);
      values.push_back(((2.0 * k + 1.0) * x * values[last] - k * values[last - 1]) / (k + 1.0));
    }
    for (int k = 0; k <= highest_degree; ++k) values[static_cast<std::size_t>(k)] *= std::sqrt(2.0 * k + 1.0);
    return values;
  }
};

/// The number of functions of an input of a degree above 0.
int functions_of_degree(const UncertainInput& input, int degree) {
  const auto choices = static_cast<int>(choices_of(input));
  if (choices == 0) return 1;
  return degree == 1 ? choices - 1 : 0;
}

/// Least squares with the error of predicting each group from all others.
struct CrossValidatedFit {
  Eigen::MatrixXd coefficients;        ///< terms x outputs
  Eigen::VectorXd mean_square_errors;  ///< of the outputs
};

/// The deviations of a group from the fit to all others, for its residuals and its part Q of an orthonormal basis;
/// nothing where the group alone determines a term. A group larger than the basis takes the smaller of two equal
/// systems, (1 - Q Q')^-1 = 1 + Q (1 - Q' Q)^-1 Q'.
std::optional<Eigen::MatrixXd> deviations_from_others(const Eigen::MatrixXd& basis, const Eigen::MatrixXd& residuals) {
  constexpr double least = 1e-6;
  const bool is_large = basis.rows() > basis.cols();
  const auto size = std::min(basis.rows(), basis.cols());
  const Eigen::MatrixXd product =
      is_large ? Eigen::MatrixXd(basis.transpose() * basis) : Eigen::MatrixXd(basis * basis.transpose());
  const Eigen::LDLT<Eigen::MatrixXd> others(Eigen::MatrixXd::Identity(size, size) - product);
  if (others.vectorD().minCoeff() < least) return std::nullopt;
  if (!is_large) return others.solve(residuals);
  return residuals + basis * others.solve(basis.transpose() * residuals);
}

/// With the residual r of all samples and the part Q of an orthonormal basis that belongs to a group, the deviations of
/// the group from the fit to all others are (1 - Q Q')^-1 r.
CrossValidatedFit fit(const Eigen::MatrixXd& functions, const SampledOutputs& samples) {
  const Eigen::MatrixXd values = samples.values.transpose();
  const Eigen::HouseholderQR<Eigen::MatrixXd> factors(functions);
  CrossValidatedFit found;
  found.coefficients = factors.solve(values);
  const Eigen::MatrixXd basis = factors.householderQ() * Eigen::MatrixXd::Identity(functions.rows(), functions.cols());
  const Eigen::MatrixXd residuals = values - functions * found.coefficients;
  std::map<std::size_t, std::vector<Eigen::Index>> groups;
  for (Eigen::Index i = 0; i < functions.rows(); ++i) groups[samples.groups[static_cast<std::size_t>(i)]].push_back(i);
  found.mean_square_errors = Eigen::VectorXd::Zero(values.cols());
  for (const auto& [group, rows] : groups) {
    const auto deviations = deviations_from_others(basis(rows, Eigen::all), residuals(rows, Eigen::all));
    if (!deviations) {
      found.mean_square_errors.setConstant(std::numeric_limits<double>::infinity());
      return found;
    }
    found.mean_square_errors += deviations->cwiseAbs2().colwise().sum().transpose();
  }
  found.mean_square_errors /= static_cast<double>(functions.rows());
  return found;
}

/// How well a fit predicts all outputs: the sum of their mean square errors, each over the variance of the samples.
double whole_error(const CrossValidatedFit& found, const Eigen::MatrixXd& values) {
  double sum = 0.0;
  for (Eigen::Index output = 0; output < values.rows(); ++output) {
    const double variance = (values.row(output).array() - values.row(output).mean()).square().mean();
    if (variance > 0.0) sum += found.mean_square_errors[output] / variance;
  }
  return sum;
}

}  // namespace

SampledOutputs followed_samples(const AssessmentDesign& design, const SampledCurve& curve) {
  const bool is_phase = curve.curve == ObservedCurve::phase;
  SampledOutputs samples = {.coordinates = design.coordinates,
                            .values = is_phase ? curve.values : Eigen::MatrixXd(curve.values.array().log()),
                            .groups = design.box_of,
                            .are_of_group = design.change_the_box};
  if (design.boxes.cols() > 1 && !design.has_all_boxes) return samples;
  // Without an error that samples share, or other boxes that could have one, each is a group of its own.
  for (std::size_t i = 0; i < samples.groups.size(); ++i) samples.groups[i] = i;
  samples.are_of_group.assign(samples.are_of_group.size(), false);
  return samples;
}

PolynomialChaos::PolynomialChaos(std::vector<UncertainInput> inputs, const SampledOutputs& samples)
    : inputs_(std::move(inputs)) {
  const auto count = static_cast<std::size_t>(samples.values.cols());
  const std::set<std::size_t> groups(samples.groups.begin(), samples.groups.end());
  const bool has_group_inputs = std::ranges::find(samples.are_of_group, true) != samples.are_of_group.end();
  double best = std::numeric_limits<double>::infinity();
  for (int degree = 0; degree <= highest_degree; ++degree) {
    for (int of_group = 0; of_group <= (has_group_inputs ? degree : 0); ++of_group) {
      auto terms = terms_up_to(degree, has_group_inputs ? of_group : degree, samples.are_of_group, count / 2);
      if (terms.empty()) continue;
      // The parts of the terms in the inputs of groups are determined by the groups alone.
      std::set<Term> parts;
      for (auto part : terms) {
        for (std::size_t i = 0; i < part.size(); ++i) part[i] = samples.are_of_group[i] ? part[i] : 0;
        parts.insert(std::move(part));
      }
      if (has_group_inputs && 3 * parts.size() > 2 * groups.size()) continue;
      auto found = fit(functions_at(terms, samples.coordinates), samples);
      const double error = whole_error(found, samples.values);
      if (!terms_.empty() && !(error < best)) continue;
      best = error;
      degree_ = degree;
      terms_ = std::move(terms);
      coefficients_ = std::move(found.coefficients);
      mean_square_errors_ = std::move(found.mean_square_errors);
    }
  }
}

std::vector<PolynomialChaos::Term> PolynomialChaos::terms_up_to(int degree, int degree_of_group,
                                                                const std::vector<bool>& are_of_group,
                                                                std::size_t most) const {
  struct Partial {
    Term term;
    int left, left_of_group;
  };
  std::vector<Partial> all = {{{}, degree, degree_of_group}};
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    std::vector<Partial> longer;
    for (const auto& one : all) {
      const int highest = are_of_group[i] ? std::min(one.left, one.left_of_group) : one.left;
      int function = 0;
      for (int k = 0; k <= highest; ++k) {
        const int functions = k == 0 ? 1 : functions_of_degree(inputs_[i], k);
        for (int f = 0; f < functions; ++f) {
          auto& next = longer.emplace_back(one);
          next.term.push_back(function++);
          next.left -= k;
          if (are_of_group[i]) next.left_of_group -= k;
        }
      }
    }
    all = std::move(longer);
    // Further inputs only add terms.
    if (all.size() > most) return {};
  }
  std::vector<Term> terms;
  terms.reserve(all.size());
  for (auto& one : all) terms.push_back(std::move(one.term));
  return terms;
}

Eigen::MatrixXd PolynomialChaos::functions_at(const std::vector<Term>& terms,
                                              const Eigen::MatrixXd& coordinates) const {
  Eigen::MatrixXd functions = Eigen::MatrixXd::Ones(coordinates.cols(), static_cast<Eigen::Index>(terms.size()));
  for (std::size_t input = 0; input < inputs_.size(); ++input) {
    for (Eigen::Index point = 0; point < coordinates.cols(); ++point) {
      const auto own =
          std::visit(FunctionsAt{coordinates(static_cast<Eigen::Index>(input), point)}, inputs_[input].known);
      for (std::size_t term = 0; term < terms.size(); ++term) {
        functions(point, static_cast<Eigen::Index>(term)) *= own[static_cast<std::size_t>(terms[term][input])];
      }
    }
  }
  return functions;
}

Eigen::MatrixXd PolynomialChaos::at(const Eigen::MatrixXd& coordinates) const {
  return (functions_at(terms_, coordinates) * coefficients_).transpose();
}

Eigen::VectorXd PolynomialChaos::variances() const {
  // The first term is the constant.
  return coefficients_.bottomRows(coefficients_.rows() - 1).cwiseAbs2().colwise().sum().transpose();
}

template <class Accepts>
Eigen::RowVectorXd PolynomialChaos::share_of(const Accepts& accepts) const {
  Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(coefficients_.cols());
  for (std::size_t term = 0; term < terms_.size(); ++term) {
    if (accepts(terms_[term])) sum += coefficients_.row(static_cast<Eigen::Index>(term)).cwiseAbs2();
  }
  // An output that no input changes has the variance of its rounding errors.
  constexpr double rounding = 1e-20;
  const Eigen::RowVectorXd whole = variances().transpose();
  const Eigen::RowVectorXd least = rounding * coefficients_.row(0).cwiseAbs2();
  return (whole.array() > least.array()).select(sum.cwiseQuotient(whole), 0.0);
}

Eigen::MatrixXd PolynomialChaos::first_order() const {
  Eigen::MatrixXd shares(static_cast<Eigen::Index>(inputs_.size()), coefficients_.cols());
  for (std::size_t input = 0; input < inputs_.size(); ++input) {
    const auto is_alone = [input](const Term& term) {
      for (std::size_t i = 0; i < term.size(); ++i) {
        if ((term[i] != 0) != (i == input)) return false;
      }
      return true;
    };
    shares.row(static_cast<Eigen::Index>(input)) = share_of(is_alone);
  }
  return shares;
}

Eigen::MatrixXd PolynomialChaos::total() const {
  Eigen::MatrixXd shares(static_cast<Eigen::Index>(inputs_.size()), coefficients_.cols());
  for (std::size_t input = 0; input < inputs_.size(); ++input) {
    shares.row(static_cast<Eigen::Index>(input)) = share_of([input](const Term& term) { return term[input] != 0; });
  }
  return shares;
}

}  // namespace breccia
