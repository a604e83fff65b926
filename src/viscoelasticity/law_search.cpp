#include "viscoelasticity/law_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "viscoelasticity/fit_quality.hpp"
#include "viscoelasticity/least_squares.hpp"

namespace breccia {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The search for the values of the parameters of a law.
class LawSearch {
 public:
  LawSearch(LawForm form, const LawProblem& problem, const GivenParameters& given)
      : form_(form), problem_(&problem), values_(Eigen::VectorXd::Ones(count())), origins_(parameters().size()) {
    take(given);
    take_time_of_power_law();
    require_data();
    begin();
  }

  /// Searches, and gives parameters their limits as long as the data are met as well without them.
  LawFit result() {
    bool has_converged = search();
    const auto with_all = in_order(form_, values_);
    while (true) {
      const auto simpler = simplest_as_good();
      if (!simpler) break;
      std::tie(values_, origins_, has_converged) = std::tie(simpler->values, simpler->origins, simpler->has_converged);
    }
    if (!has_converged)
      throw NumericalError(fmt::format("the search for the parameters of {} did not converge", name_of(form_)));
    put_in_order();
    const Eigen::MatrixXd derivatives = jacobian(unknowns());
    LawFit fit{.form = form_, .parameters = described(with_all), .series = series_of(law_with(form_, values_))};
    fit.quality = quality_of_fit(problem_->data, deviations(values_), problem_->at, derivatives);
    return fit;
  }

 private:
  [[nodiscard]] std::span<const LawParameter> parameters() const { return parameters_of(form_); }
  [[nodiscard]] const LawParameter& parameter(Eigen::Index i) const {
    return parameters()[static_cast<std::size_t>(i)];
  }
  [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(parameters().size()); }
  [[nodiscard]] ParameterOrigin& origin(Eigen::Index i) { return origins_[static_cast<std::size_t>(i)]; }

  /// Indices of the parameters that are fitted.
  [[nodiscard]] std::vector<Eigen::Index> free_ones() const {
    std::vector<Eigen::Index> free;
    for (Eigen::Index i = 0; i < count(); ++i) {
      if (origins_[static_cast<std::size_t>(i)] == ParameterOrigin::fitted) free.push_back(i);
    }
    return free;
  }

  // The unknowns of the search are the logarithms of positive parameters and, of exponents, ln(n / (1 - n)).
  [[nodiscard]] double unknown_of(Eigen::Index i, double value) const {
    return parameter(i).kind == ParameterKind::exponent ? std::log(value / (1.0 - value)) : std::log(value);
  }
  [[nodiscard]] double value_of(Eigen::Index i, double unknown) const {
    return parameter(i).kind == ParameterKind::exponent ? 1.0 / (1.0 + std::exp(-unknown)) : std::exp(unknown);
  }
  /// Derivative of a value by its unknown.
  [[nodiscard]] double slope_of(Eigen::Index i) const {
    const double value = values_[i];
    return parameter(i).kind == ParameterKind::exponent ? value * (1.0 - value) : value;
  }
  [[nodiscard]] Eigen::VectorXd unknowns() const {
    const auto free = free_ones();
    Eigen::VectorXd x(static_cast<Eigen::Index>(free.size()));
    for (Eigen::Index j = 0; j < x.size(); ++j) {
      const auto i = free[static_cast<std::size_t>(j)];
      x[j] = unknown_of(i, values_[i]);
    }
    return x;
  }
  [[nodiscard]] Eigen::VectorXd values_with(const Eigen::VectorXd& x) const {
    const auto free = free_ones();
    auto values = values_;
    for (Eigen::Index j = 0; j < x.size(); ++j) {
      const auto i = free[static_cast<std::size_t>(j)];
      values[i] = value_of(i, x[j]);
    }
    return values;
  }

  void take(const GivenParameters& given) {
    for (const auto& [key, value] : given) {
      const auto known = std::ranges::find(parameters(), key, &LawParameter::key);
      if (known == parameters().end()) {
        std::vector<std::string_view> keys;
        for (const auto& one : parameters()) keys.push_back(one.key);
        throw InputError(
            fmt::format("{}: not a parameter of {}, which has {}", key, name_of(form_), fmt::join(keys, ", ")));
      }
      const bool is_exponent = known->kind == ParameterKind::exponent;
      const bool is_inside = value > 0.0 && value < (is_exponent ? 1.0 : infinity);
      if (!is_inside && value != known->limit) {
        throw InputError(fmt::format("{}: expected {}, got {:g}", key,
                                     is_exponent ? "a number between 0 and 1" : "a positive number", value));
      }
      const auto i = known - parameters().begin();
      values_[i] = value;
      origin(i) = ParameterOrigin::given;
    }
  }

  /// The compliance depends on creep / time^exponent alone: the time is a power of ten seconds amid the data.
  void take_time_of_power_law() {
    constexpr Eigen::Index creep = 1, time = 2;
    if (form_ != LawForm::power_law_creep) return;
    if (origin(creep) != ParameterOrigin::fitted || origin(time) != ParameterOrigin::fitted) return;
    values_[time] = std::pow(10.0, std::round(0.5 * std::log10(problem_->reach.begin * problem_->reach.end)));
    origin(time) = ParameterOrigin::of_no_effect;
  }

  void require_data() const {
    const auto unknown = static_cast<Eigen::Index>(free_ones().size());
    if (unknown == 0) throw InputError("all parameters of the law are given: nothing is left to be fitted");
    if (problem_->data.size() > unknown) return;
    throw InputError(fmt::format("{} has {} unknowns: expected more data than that, got {}", name_of(form_), unknown,
                                 problem_->data.size()));
  }

  /// Takes the values of the best of several searches, from the best of many starting values.
  void begin() {
    struct Start {
      double misfit;
      Eigen::VectorXd values;
    };
    std::vector<Start> starts;
    const auto free = free_ones();
    for (const auto& some : starting_values(form_, problem_->least, problem_->most, problem_->reach)) {
      auto values = values_;
      for (const auto i : free) values[i] = some[i];
      starts.push_back({relative(problem_->foresee, values).squaredNorm(), values});
    }
    constexpr std::size_t searches = 5;
    const auto tried = std::min(searches, starts.size());
    std::ranges::partial_sort(starts, starts.begin() + static_cast<std::ptrdiff_t>(tried), {}, &Start::misfit);
    Start best = {infinity, starts.front().values};
    for (std::size_t i = 0; i < tried; ++i) {
      values_ = starts[i].values;
      static_cast<void>(search());  // a search that has not converged may go on from the best values
      const double misfit = deviations(values_).squaredNorm();
      if (misfit < best.misfit) best = {misfit, values_};
    }
    values_ = best.values;
  }

  /// Moves the fitted values to the next minimum of the sum of squares; returns whether they arrived there.
  bool search() {
    const NonlinearLeastSquares least_squares = {
        .values = problem_->data.size(),
        .deviations = [this](const Eigen::VectorXd& x, Eigen::VectorXd& f) { f = deviations(values_with(x)); },
        .jacobian = [this](const Eigen::VectorXd& x, Eigen::MatrixXd& derivatives) { derivatives = jacobian(x); }};
    constexpr SearchLimits limits = {.relative_step = 1e-9, .relative_decrease = 1e-12, .most_evaluations = 1000};
    auto x = unknowns();
    const bool has_converged = search_least_squares(least_squares, limits, x);
    values_ = values_with(x);
    return has_converged;
  }

  [[nodiscard]] Eigen::VectorXd deviations(const Eigen::VectorXd& values) const {
    return relative(problem_->predict, values);
  }

  /// Whether a law with these values can be used: a Prony series of few terms follows it over the range of the data.
  [[nodiscard]] bool is_usable(const Eigen::VectorXd& values) const {
    constexpr double least_exponent = 0.02, largest_exponent = 0.95, reach = 1e9;
    for (const auto i : free_ones()) {
      const double value = values[i];
      const auto& [key, kind, limit] = parameter(i);
      if (kind == ParameterKind::exponent && (value < least_exponent || value > limit.value_or(largest_exponent))) {
        return false;
      }
      if (kind == ParameterKind::time &&
          (value < problem_->reach.begin / reach || value > problem_->reach.end * reach)) {
        return false;
      }
    }
    return true;
  }

  /// The relative deviations of a prediction from the data; large numbers where the law cannot be used.
  [[nodiscard]] Eigen::VectorXd relative(const std::function<Eigen::VectorXd(const ViscoelasticLaw&)>& predict,
                                         const Eigen::VectorXd& values) const {
    constexpr double far_off = 1e6;
    if (!is_usable(values)) return Eigen::VectorXd::Constant(problem_->data.size(), far_off);
    try {
      Eigen::VectorXd deviations = predict(law_with(form_, values)).cwiseQuotient(problem_->data).array() - 1.0;
      for (auto& one : deviations) one = std::isfinite(one) ? std::clamp(one, -far_off, far_off) : far_off;
      return deviations;
    } catch (const InputError&) {  // no series of few terms follows the law
      return Eigen::VectorXd::Constant(problem_->data.size(), far_off);
    }
  }

  /// The unknowns with one of them changed; nothing where the law cannot be used there.
  [[nodiscard]] std::optional<Eigen::VectorXd> beside(Eigen::VectorXd x, Eigen::Index j, double change) const {
    x[j] += change;
    return is_usable(values_with(x)) ? std::optional(x) : std::nullopt;
  }

  /// Derivatives of the deviations by the unknowns, by central differences or, at the end of what can be used, to one
  /// side.
  [[nodiscard]] Eigen::MatrixXd jacobian(const Eigen::VectorXd& x) const {
    Eigen::MatrixXd derivatives = Eigen::MatrixXd::Zero(problem_->data.size(), x.size());
    for (Eigen::Index j = 0; j < x.size(); ++j) {
      const auto above = beside(x, j, step).value_or(x), below = beside(x, j, -step).value_or(x);
      const double distance = above[j] - below[j];
      if (distance == 0.0) continue;
      derivatives.col(j) = (deviations(values_with(above)) - deviations(values_with(below))) / distance;
    }
    return derivatives;
  }

  /// Standard errors of the unknowns, infinite where the data do not determine one or would have one beyond what can be
  /// used.
  [[nodiscard]] Eigen::VectorXd errors_of_unknowns() const {
    const auto x = unknowns();
    const Eigen::VectorXd unknown_errors = Eigen::VectorXd::Constant(x.size(), infinity);
    for (Eigen::Index j = 0; j < x.size(); ++j) {
      if (!beside(x, j, step) || !beside(x, j, -step)) return unknown_errors;
    }
    Eigen::MatrixXd derivatives = jacobian(x);
    const Eigen::VectorXd sizes = derivatives.colwise().norm().transpose().cwiseMax(std::numeric_limits<double>::min());
    derivatives.array().rowwise() /= sizes.transpose().array();
    const auto freedom = static_cast<double>(problem_->data.size() - x.size());
    const double scatter = std::sqrt(deviations(values_).squaredNorm() / freedom);
    const auto found = variances(derivatives);
    if (!found) return unknown_errors;
    return scatter * found->cwiseMax(0.0).cwiseSqrt().cwiseQuotient(sizes);
  }

  /// A state of the search.
  struct State {
    Eigen::VectorXd values;
    std::vector<ParameterOrigin> origins;
    bool has_converged = false;
  };

  /// The best state with one more parameter at its limit, if the sum of squares rises by less than what separates a
  /// parameter from its limit with 95 % of confidence.
  [[nodiscard]] std::optional<State> simplest_as_good() {
    const State now = {values_, origins_};
    const auto free = free_ones();
    const double misfit = deviations(values_).squaredNorm();
    const double variance =
        misfit / static_cast<double>(problem_->data.size() - static_cast<Eigen::Index>(free.size()));
    constexpr double confident = 3.84;  // quantile of chi squared with one degree of freedom
    double least = misfit + confident * variance;
    std::optional<State> best;
    for (const auto i : free) {
      if (!parameter(i).limit || free.size() == 1) continue;
      values_[i] = *parameter(i).limit;
      origin(i) = ParameterOrigin::limit;
      const bool has_converged = search();
      if (const double found = deviations(values_).squaredNorm(); found <= least) {
        least = found;
        best = {values_, origins_, has_converged};
      }
      values_ = now.values;
      origins_ = now.origins;
    }
    return best;
  }

  /// Puts the parameters into the order that the law asks for. Throws InputError where a given one would change.
  void put_in_order() {
    const auto ordered = in_order(form_, values_);
    for (Eigen::Index i = 0; i < count(); ++i) {
      if (ordered[i] == values_[i] || origin(i) != ParameterOrigin::given) continue;
      throw InputError(fmt::format("{} = {:g}: with it the data ask for k above h", parameter(i).key, values_[i]));
    }
    values_ = ordered;
  }

  /// The parameters with their standard errors, to which the distance from the values that were found together with
  /// those at a limit adds: both meet the data.
  [[nodiscard]] std::vector<FittedParameter> described(const Eigen::VectorXd& with_all) const {
    std::vector<FittedParameter> all;
    for (Eigen::Index i = 0; i < count(); ++i) {
      all.push_back({parameter(i).key, values_[i], 0.0, origins_[static_cast<std::size_t>(i)]});
    }
    const auto free = free_ones();
    const auto errors = errors_of_unknowns();
    for (Eigen::Index j = 0; j < errors.size(); ++j) {
      const auto i = free[static_cast<std::size_t>(j)];
      const double distance = unknown_of(i, values_[i]) - unknown_of(i, with_all[i]);
      all[static_cast<std::size_t>(i)].standard_error = std::hypot(errors[j], distance) * slope_of(i);
    }
    return all;
  }

  static constexpr double step = 1e-4;  ///< of an unknown, for the derivatives

  LawForm form_;
  const LawProblem* problem_;
  Eigen::VectorXd values_;                ///< in the order of the parameters
  std::vector<ParameterOrigin> origins_;  ///< of each parameter
};

}  // namespace

LawFit search_law(LawForm form, const LawProblem& problem, const GivenParameters& given) {
  return LawSearch(form, problem, given).result();
}

}  // namespace breccia
