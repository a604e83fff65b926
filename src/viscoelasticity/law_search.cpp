#include "viscoelasticity/law_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "viscoelasticity/fit_quality.hpp"
#include "viscoelasticity/law_unknowns.hpp"
#include "viscoelasticity/least_squares.hpp"

namespace breccia {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The square of the quantile of Student's distribution that 95 % do not exceed, by the expansion of Cornish and Fisher
/// (to 1 % from three degrees of freedom on).
double squared_quantile(double freedom) {
  constexpr double z = 1.6449;
  const double first = (z * z * z + z) / 4.0, second = (5.0 * std::pow(z, 5) + 16.0 * z * z * z + 3.0 * z) / 96.0;
  const double t = z + first / freedom + second / (freedom * freedom);
  return t * t;
}

/// A state of the search that has come to an end.
struct Found {
  LawState state;
  double misfit = infinity;  ///< sum of the squares of the relative deviations
  bool has_converged = false;
};

/// The search for the parameters of a law, whose functions take one state to another.
class LawSearch {
 public:
  LawSearch(LawForm form, const LawProblem& problem)
      : form_(form), problem_(&problem), bounds_(bounds_of(form, problem.range)) {}

  /// The state in which the given parameters have their values. Throws InputError.
  [[nodiscard]] LawState with(const GivenParameters& given) const {
    auto mistakes = mistakes_in(form_, given);
    if (mistakes.empty()) mistakes = mistakes_beside_data(given);
    if (!mistakes.empty()) throw InputError(fmt::format("{}", fmt::join(mistakes, "\n")));
    LawState state = {Eigen::VectorXd::Ones(count()),
                      std::vector<ParameterOrigin>(parameters_of(form_).size(), ParameterOrigin::fitted)};
    for (const auto& [key, value] : given) {
      const auto i = number_of(key);
      state.values[i] = value;
      origin(state, i) = ParameterOrigin::given;
    }
    if (form_ == LawForm::power_law_creep) fix_time_of_power_law(state);
    require_data(state);
    return state;
  }

  /// The best of the searches from the five best of all starting values.
  [[nodiscard]] Found best_of_starts(const LawState& state) const {
    auto lists = starting_values(form_, problem_->range);
    for (std::size_t i = 0; i < lists.size(); ++i) {
      if (state.origins[i] != ParameterOrigin::fitted) lists[i] = {state.values[static_cast<Eigen::Index>(i)]};
    }
    std::vector<std::pair<double, LawState>> starts;
    for (auto& values : combinations(lists)) {
      const double misfit = deviations(problem_->foresee, values).squaredNorm();
      starts.emplace_back(misfit, LawState{std::move(values), state.origins});
    }
    constexpr std::size_t searches = 5;
    const auto tried = std::min(searches, starts.size());
    std::ranges::partial_sort(starts, starts.begin() + static_cast<std::ptrdiff_t>(tried), {},
                              &std::pair<double, LawState>::first);
    Found best;
    for (std::size_t i = 0; i < tried; ++i) {
      if (auto found = searched(starts[i].second); found.misfit < best.misfit) best = std::move(found);
    }
    return best;
  }

  /// The best state with one more parameter at its limit, if the data do not tell it from the limit at 95 %.
  [[nodiscard]] std::optional<Found> simplest_as_good(const Found& now) const {
    const LawUnknowns unknowns(form_, bounds_, now.state);
    const double freedom = freedom_of(unknowns);
    double largest = now.misfit * (1.0 + squared_quantile(freedom) / freedom);
    std::optional<Found> best;
    for (Eigen::Index j = 0; j < unknowns.size() && unknowns.size() > 1; ++j) {
      const auto i = unknowns.parameter(j);
      const auto& limit = parameters_of(form_)[static_cast<std::size_t>(i)].limit;
      if (!limit) continue;
      auto found = searched(with_fixed(now.state, i, *limit, ParameterOrigin::limit));
      if (found.misfit > largest) continue;
      largest = found.misfit;
      best = std::move(found);
    }
    return best;
  }

  /// The state in which a parameter that has come to a bound stays there; nothing where none has.
  [[nodiscard]] std::optional<Found> with_one_at_bound(const Found& now) const {
    const LawUnknowns unknowns(form_, bounds_, now.state);
    for (Eigen::Index j = 0; j < unknowns.size() && unknowns.size() > 1; ++j) {
      const auto i = unknowns.parameter(j);
      const auto bound = unknowns.bound_at(i, now.state.values[i]);
      if (bound) return searched(with_fixed(now.state, i, *bound, ParameterOrigin::bound));
    }
    return std::nullopt;
  }

  /// The law of a state, with its parameters in order. `with_all` is the state before parameters took their limits.
  [[nodiscard]] LawFit fit_of(LawState state, const LawState& with_all) const {
    put_in_order(state);
    const LawUnknowns unknowns(form_, bounds_, state);
    return {.form = form_,
            .parameters = described(state, unknowns, in_order(form_, with_all.values)),
            .series = series_of(law_with(form_, state.values)),
            .quality = quality_of_fit(problem_->data, deviations(problem_->predict, state.values), problem_->at,
                                      jacobian(unknowns, unknowns.of_state()))};
  }

 private:
  using Prediction = std::function<Eigen::VectorXd(const ViscoelasticLaw&)>;

  [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(parameters_of(form_).size()); }
  [[nodiscard]] Eigen::Index number_of(std::string_view key) const {
    const auto parameters = parameters_of(form_);
    return std::ranges::find(parameters, key, &LawParameter::key) - parameters.begin();
  }
  static ParameterOrigin& origin(LawState& state, Eigen::Index i) { return state.origins[static_cast<std::size_t>(i)]; }
  static LawState with_fixed(LawState state, Eigen::Index i, double value, ParameterOrigin why) {
    state.values[i] = value;
    origin(state, i) = why;
    return state;
  }

  /// Given moduli and compliances at t = 0 and at infinite time between which the data do not lie, nor near them.
  [[nodiscard]] std::vector<std::string> mistakes_beside_data(const GivenParameters& given) const {
    const auto& [least, most, reach] = problem_->range;
    constexpr double near = 2.0;
    std::vector<std::string> mistakes;
    for (const auto& [key, value] : given) {
      const auto& parameter = parameters_of(form_)[static_cast<std::size_t>(number_of(key))];
      const bool is_relaxed = parameter.kind == ParameterKind::modulus && parameter.limit;
      const bool is_unrelaxed = parameter.kind == ParameterKind::modulus && !parameter.limit;
      if ((is_relaxed || key == "instantaneous") && value > near * least) {
        mistakes.push_back(
            fmt::format("{}: expected less than all data, whose smallest is {:.3g}, got {:.3g}", key, least, value));
      }
      if (is_unrelaxed && near * value < most) {
        mistakes.push_back(
            fmt::format("{}: expected more than all data, whose largest is {:.3g}, got {:.3g}", key, most, value));
      }
    }
    return mistakes;
  }

  /// The compliance depends on creep / time^exponent alone: the time is a power of ten seconds amid the data.
  void fix_time_of_power_law(LawState& state) const {
    const auto creep = number_of("creep"), time = number_of("time");
    if (origin(state, creep) != ParameterOrigin::fitted || origin(state, time) != ParameterOrigin::fitted) return;
    const auto& [begin, end] = problem_->range.reach;
    state.values[time] = std::pow(10.0, std::round(0.5 * std::log10(begin * end)));
    origin(state, time) = ParameterOrigin::of_no_effect;
  }

  void require_data(const LawState& state) const {
    constexpr Eigen::Index fewest_more = 3;  // than unknowns, for the scatter
    const auto unknown = std::ranges::count(state.origins, ParameterOrigin::fitted);
    if (unknown == 0) throw InputError("all parameters of the law are given: nothing is left to be fitted");
    if (problem_->data.size() >= unknown + fewest_more) return;
    throw InputError(fmt::format("{} has {} unknowns: expected at least {} data, got {}", name_of(form_), unknown,
                                 unknown + fewest_more, problem_->data.size()));
  }

  [[nodiscard]] double freedom_of(const LawUnknowns& unknowns) const {
    return static_cast<double>(problem_->data.size() - unknowns.size());
  }

  /// Moves the fitted values of a state to the next minimum of the sum of squares.
  [[nodiscard]] Found searched(const LawState& state) const {
    const LawUnknowns unknowns(form_, bounds_, state);
    const auto deviations_of = [&](const Eigen::VectorXd& x) {
      return deviations(problem_->predict, unknowns.values(x));
    };
    const NonlinearLeastSquares least_squares = {
        .values = problem_->data.size(),
        .deviations = [&](const Eigen::VectorXd& x, Eigen::VectorXd& f) { f = deviations_of(x); },
        .jacobian = [&](const Eigen::VectorXd& x,
                        Eigen::MatrixXd& derivatives) { derivatives = jacobian(unknowns, x); }};
    constexpr SearchLimits limits = {.relative_step = 1e-9, .relative_decrease = 1e-12, .most_evaluations = 1000};
    auto x = unknowns.of_state();
    const bool has_converged = search_least_squares(least_squares, limits, x);
    return {{unknowns.values(x), state.origins}, deviations_of(x).squaredNorm(), has_converged};
  }

  /// The relative deviations of a prediction from the data; large numbers where the law has none.
  [[nodiscard]] Eigen::VectorXd deviations(const Prediction& predict, const Eigen::VectorXd& values) const {
    constexpr double far_off = 1e6;
    try {
      Eigen::VectorXd deviations = predict(law_with(form_, values)).cwiseQuotient(problem_->data).array() - 1.0;
      for (auto& one : deviations) one = std::isfinite(one) ? std::clamp(one, -far_off, far_off) : far_off;
      return deviations;
    } catch (const InputError&) {  // no series of few terms follows the law
      return Eigen::VectorXd::Constant(problem_->data.size(), far_off);
    }
  }

  /// Derivatives of the deviations by the unknowns, by central differences.
  [[nodiscard]] Eigen::MatrixXd jacobian(const LawUnknowns& unknowns, const Eigen::VectorXd& x) const {
    constexpr double step = 1e-4;
    Eigen::MatrixXd derivatives(problem_->data.size(), x.size());
    for (Eigen::Index j = 0; j < x.size(); ++j) {
      Eigen::VectorXd above = x, below = x;
      above[j] += step;
      below[j] -= step;
      derivatives.col(j) = (deviations(problem_->predict, unknowns.values(above)) -
                            deviations(problem_->predict, unknowns.values(below))) /
                           (2.0 * step);
    }
    return derivatives;
  }

  /// Standard errors of the unknowns; infinite where the data do not determine one.
  [[nodiscard]] Eigen::VectorXd errors_of(const LawUnknowns& unknowns, const LawState& state) const {
    Eigen::MatrixXd derivatives = jacobian(unknowns, unknowns.of_state());
    const Eigen::VectorXd sizes = derivatives.colwise().norm().transpose().cwiseMax(std::numeric_limits<double>::min());
    derivatives.array().rowwise() /= sizes.transpose().array();
    const double misfit = deviations(problem_->predict, state.values).squaredNorm();
    const double scatter = std::sqrt(misfit / freedom_of(unknowns));
    Eigen::VectorXd errors = Eigen::VectorXd::Constant(unknowns.size(), infinity);
    const auto found = variances(derivatives);
    for (Eigen::Index j = 0; found && j < errors.size(); ++j) {
      if ((*found)[j] > 0.0) errors[j] = scatter * std::sqrt((*found)[j]) / sizes[j];
    }
    return errors;
  }

  /// Puts the parameters into the order that the law asks for. Throws InputError where a given one would change.
  void put_in_order(LawState& state) const {
    const auto ordered = in_order(form_, state.values);
    for (Eigen::Index i = 0; i < count(); ++i) {
      if (ordered[i] == state.values[i] || origin(state, i) != ParameterOrigin::given) continue;
      throw InputError(fmt::format("{} = {:g}: with it the data ask for k above h",
                                   parameters_of(form_)[static_cast<std::size_t>(i)].key, state.values[i]));
    }
    state.values = ordered;
  }

  /// The parameters with their standard errors, to which the distance from the values that were found together with
  /// those at a limit adds: both meet the data.
  [[nodiscard]] std::vector<FittedParameter> described(const LawState& state, const LawUnknowns& unknowns,
                                                       const Eigen::VectorXd& with_all) const {
    std::vector<FittedParameter> all;
    for (Eigen::Index i = 0; i < count(); ++i) {
      const auto number = static_cast<std::size_t>(i);
      const auto& parameter = parameters_of(form_)[number];
      const bool is_at_bound = state.origins[number] == ParameterOrigin::bound;
      all.push_back({parameter.key, state.values[i], is_at_bound ? infinity : 0.0, state.origins[number]});
    }
    const auto errors = errors_of(unknowns, state);
    for (Eigen::Index j = 0; j < errors.size(); ++j) {
      const auto i = unknowns.parameter(j);
      auto& parameter = all[static_cast<std::size_t>(i)];
      const double distance = unknowns.scaled(i, parameter.value) - unknowns.scaled(i, with_all[i]);
      const bool is_exponent = parameters_of(form_)[static_cast<std::size_t>(i)].kind == ParameterKind::exponent;
      parameter.standard_error =
          std::hypot(errors[j] * unknowns.slope(j), distance) * (is_exponent ? 1.0 : parameter.value);
    }
    return all;
  }

  LawForm form_;
  const LawProblem* problem_;
  std::vector<Bounds> bounds_;
};

}  // namespace

LawFit search_law(LawForm form, const LawProblem& problem, const GivenParameters& given) {
  const LawSearch search(form, problem);
  auto found = search.best_of_starts(search.with(given));
  const auto with_all = found.state;
  while (auto simpler = search.simplest_as_good(found)) found = *std::move(simpler);
  while (auto bounded = search.with_one_at_bound(found)) found = *std::move(bounded);
  if (!found.has_converged) {
    throw NumericalError(fmt::format("the search for the parameters of {} did not converge", name_of(form)));
  }
  return search.fit_of(found.state, with_all);
}

}  // namespace breccia
