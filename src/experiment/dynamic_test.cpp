#include "breccia/experiment/dynamic_test.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/experiment/modulus_bounds.hpp"
#include "breccia/experiment/time_domains.hpp"
#include "breccia/viscoelasticity/fit.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "test_times.hpp"

namespace breccia {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

DomainRules rules_of(const DynamicTest& test) {
  const auto& grid = test.discretisation.grid();
  DomainRules rules;
  rules.side = grid.cell_side * std::max(grid.columns, grid.rows);
  rules.density = mean_density(test.discretisation, test.materials);
  rules.times = test.times;
  rules.density_factors = test.options.density_factors;
  rules.overlap = test.options.overlap;
  return rules;
}

/// A problem for one time domain, and what is told of it.
struct Preparation {
  DynamicProblem problem;
  TimeDomain domain;
};

Preparation prepare(const DynamicTest& test, const DomainRules& rules, const ShearModulusBounds& bounds,
                    const DomainSequence& sequence) {
  const double begin = sequence.expected_begin();
  const double end = std::max(sequence.last_time(), begin);
  constexpr double early = 1.0 / 6.0;
  TimeDomain domain;
  domain.density_factor = sequence.density_factor();
  std::vector<Material> materials;
  for (const auto& material : test.materials) {
    const auto bulk = reduce_to_window(material.bulk, {begin, end}, test.options.reduction_tolerance);
    const auto shear = reduce_to_window(material.shear, {begin, end}, test.options.reduction_tolerance);
    materials.push_back({material.name, material.density, bulk.series, shear.series});
    domain.terms = std::max(domain.terms, bulk.series.terms().size() + shear.series.terms().size());
    domain.reduction_error = std::max({domain.reduction_error, bulk.error_bound, shear.error_bound});
  }
  domain.time_step = test.options.courant *
                     stable_time_step(test.discretisation, materials, test.options.volumetric, domain.density_factor);
  // A factor that still rises begins its window after so many transits, by definition; that gives the duration of one.
  // A factor that falls again is valid long before its window begins. The composite is stiffer during the ramp.
  const double transit = std::min(begin / (2.0 * there_and_back_transits),
                                  rules.transit(domain.density_factor, bounds.lower(early * begin)));
  const double ramp_transits =
      test.boundary == Boundary::traction ? test.options.creep_ramp_transits : test.options.ramp_transits;
  domain.ramp =
      test.options.ramp_time ? *test.options.ramp_time * std::sqrt(domain.density_factor) : ramp_transits * transit;
  constexpr double most_steps = 1e10;
  if (!(end / domain.time_step < most_steps)) {
    throw NumericalError(
        fmt::format("time domains: {:.3e} s would take {:.1e} steps of {:.1e} s; the composite relaxes so far before "
                    "that time that "
                    "waves hardly cross the box; give an earlier last time",
                    end, end / domain.time_step, domain.time_step));
  }
  DynamicProblem problem = {.discretisation = test.discretisation,
                            .materials = std::move(materials),
                            .volumetric = test.options.volumetric,
                            .density_factor = domain.density_factor,
                            .time_step = domain.time_step,
                            .boundary = test.boundary,
                            .load = unit_strain(test.load),
                            .ramp = StrainRamp(domain.ramp),
                            .start = test.options.start};
  return {std::move(problem), std::move(domain)};
}

/// Steps over which one sample of the history is averaged: few enough to change the time by less than half a per cent,
/// and to take no longer than a user waits for an answer.
int steps_to_average(double time, double time_step, std::size_t points) {
  constexpr double resolution = 0.005, points_x_steps = 3e7;
  const double steps = std::min(resolution * time / time_step, points_x_steps / static_cast<double>(points));
  return std::max(1, static_cast<int>(steps));
}

/// What the mean of a few steps tells: the modulus, or under a traction boundary 1 / J.
Sample averaged_sample(const DynamicTest& test, const std::vector<Averages>& steps, double first_time,
                       double time_step) {
  const bool creeps = test.boundary == Boundary::traction;
  double sum = 0.0;
  for (const auto& [stress, strain] : steps) {
    sum += creeps ? compliance_of(test.load, strain) : modulus_of(test.load, stress);
  }
  const auto count = static_cast<double>(steps.size());
  const double mean = sum / count;
  return {first_time + 0.5 * (count - 1.0) * time_step, creeps ? 1.0 / mean : mean};
}

/// Ramp durations from its midpoint after which what is measured is the answer to a step.
double ramps_to_wait(Boundary boundary) {
  return boundary == Boundary::traction ? 1.0 : 1.5;
}

/// Told how far a domain is, and the time that it has reached.
using DomainReport = std::function<void(const TimeDomain&, double)>;

/// Runs until the sequence has seen enough. Returns the fields just after those of the times [s] that it has reached.
std::vector<TimedFields> run_domain(const DynamicTest& test, const ShearModulusBounds& bounds, DomainSequence& sequence,
                                    DynamicSolver& solver, TimeDomain& domain, std::span<const double> field_times,
                                    const DomainReport& report) {
  const bool creeps = test.boundary == Boundary::traction;
  const auto points = test.discretisation.points();
  const auto start = Clock::now();
  std::vector<Averages> steps;
  std::vector<TimedFields> fields;
  for (bool go_on = true; go_on;) {
    steps.clear();
    const double time = solver.time();
    solver.advance(steps_to_average(std::max(time, sequence.expected_begin()), domain.time_step, points), steps);
    const auto sample = averaged_sample(test, steps, time, domain.time_step);
    if (!creeps || time >= 0.5 * domain.ramp) domain.history.push_back(sample);
    domain.steps = solver.steps_taken();
    domain.seconds = seconds_since(start);
    // Shear waves decide about validity under either load; under a bulk load their speed is only known by estimate.
    const double shear_modulus = test.load != Load::bulk ? sample.modulus : bounds.lower(sample.time);
    go_on = sample.time <= ramps_to_wait(test.boundary) * domain.ramp || sequence.observe(sample.time, shear_modulus);
    while (fields.size() < field_times.size() && sample.time >= field_times[fields.size()]) {
      fields.push_back({solver.time(), solver.fields()});
    }
    report(domain, sample.time);
  }
  return fields;
}

void require_complete(const DynamicTest& test) {
  require_times("dynamic test", test.times, test.field_times);
  if (!(test.options.courant > 0.0) || test.options.courant > 1.0) {
    throw InputError(fmt::format("dynamic test: expected a courant number in (0, 1], got {}", test.options.courant));
  }
}

/// Bytes of one run, about.
std::size_t memory_of(const DynamicTest& test, std::size_t terms) {
  const auto points = test.discretisation.points();
  const auto nodes = test.discretisation.grid().nodes();
  const std::size_t results = points * sizeof(double) * 9;
  if (test.options.formulation == Formulation::classical) return results + points * (180 + 24 * terms) + nodes * 72;
  return results + nodes * 6 * sizeof(double) + points / 4 * (8 + 5 * sizeof(double) * terms);
}

/// The window of a domain as far as it is wanted. Only the first domain may be valid earlier than expected without the
/// times before being known better from another.
TimeWindow window_wanted(const DomainSequence& sequence) {
  auto window = sequence.window().value_or(TimeWindow{});
  if (!sequence.is_first()) {
    window.begin = std::max(window.begin, std::min(sequence.expected_begin(), window.end));
  }
  return window;
}

}  // namespace

double mean_density(const Discretisation& discretisation, const std::vector<Material>& materials) {
  const auto fractions = discretisation.fractions(materials.size());
  double density = 0.0;
  for (std::size_t m = 0; m < materials.size(); ++m) density += fractions[m] * materials[m].density;
  return density;
}

DynamicPlan plan_dynamic_test(const DynamicTest& test) {
  require_complete(test);
  const auto rules = rules_of(test);
  const ShearModulusBounds bounds(test.discretisation, test.materials);
  DomainSequence sequence(rules, bounds.lower(test.times.begin));
  DynamicPlan plan;
  for (;;) {
    auto domain = prepare(test, rules, bounds, sequence).domain;
    constexpr double increase = 1.01;
    double time = std::min(0.5 * sequence.expected_begin(), test.times.end);
    while (sequence.observe(time, bounds.estimate(time))) time *= increase;
    domain.window = window_wanted(sequence);
    domain.steps = static_cast<std::int64_t>(std::ceil((time + 0.5 * domain.ramp) / domain.time_step));
    plan.bytes = std::max(plan.bytes, memory_of(test, domain.terms));
    plan.domains.push_back(std::move(domain));
    if (sequence.is_complete()) return plan;
    sequence.advance();
  }
}

double trial_speed(const DynamicTest& test) {
  require_complete(test);
  const ShearModulusBounds bounds(test.discretisation, test.materials);
  const auto rules = rules_of(test);
  const DomainSequence sequence(rules, bounds.lower(test.times.begin));
  auto preparation = prepare(test, rules, bounds, sequence);
  const auto solver = make_dynamic_solver(test.options.formulation, std::move(preparation.problem), test.threads);
  std::vector<Averages> averages;
  // A given amount of work, the same on all processes, that takes a few tenths of a second.
  const double points_x_steps = test.options.formulation == Formulation::classical ? 3e6 : 1e8;
  const auto steps = static_cast<int>(points_x_steps / static_cast<double>(test.discretisation.points()));
  const auto start = Clock::now();
  solver->advance(std::max(steps, 10), averages);
  return static_cast<double>(test.discretisation.points()) * static_cast<double>(solver->steps_taken()) /
         seconds_since(start);
}

namespace {

/// From 1 / J to the compliance, and on to the relaxation modulus.
void convert_creep(DynamicTestResult& result) {
  std::vector<double> times, compliances;
  for (const auto& [time, reciprocal] : result.curve) {
    times.push_back(time);
    compliances.push_back(1.0 / reciprocal);
    result.compliance.push_back({time, 1.0 / reciprocal});
  }
  const auto fit = fit_creep(times, compliances);
  result.fit_error = fit.quality.worst_error;
  const auto series = relaxation_modulus(fit.compliance);
  for (auto& [time, modulus] : result.curve) modulus = series.at(time);
}

}  // namespace

DynamicTestResult run_dynamic_test(const DynamicTest& test, const DynamicObserver& observer) {
  require_complete(test);
  const auto rules = rules_of(test);
  const ShearModulusBounds bounds(test.discretisation, test.materials);
  DomainSequence sequence(rules, bounds.lower(test.times.begin));
  const auto points = static_cast<double>(test.discretisation.points());
  const double log_range = std::log(test.times.end / test.times.begin);
  double furthest = test.times.begin;
  DynamicTestResult result;
  for (;;) {
    auto [problem, domain] = prepare(test, rules, bounds, sequence);
    const auto solver = make_dynamic_solver(test.options.formulation, std::move(problem), test.threads);
    const auto field_times = std::span(test.field_times).subspan(result.fields.size());
    auto fields =
        run_domain(test, bounds, sequence, *solver, domain, field_times, [&](const TimeDomain& running, double time) {
          if (!observer.progress) return;
          furthest = std::max(furthest, time);
          const double done = std::log(furthest / test.times.begin);
          observer.progress({.domain = result.domains.size(),
                             .density_factor = running.density_factor,
                             .time = time,
                             .share = log_range > 0.0 ? std::min(1.0, done / log_range) : 0.0,
                             .point_steps_per_second = points * static_cast<double>(running.steps) / running.seconds});
        });
    domain.window = window_wanted(sequence);
    // The first domain that is valid at a time tells its fields: the lightest.
    for (std::size_t i = 0; i < fields.size() && field_times[i] <= domain.window.end; ++i) {
      result.fields.push_back(std::move(fields[i]));
    }
    result.domains.push_back(std::move(domain));
    if (observer.finished) observer.finished(result.domains.back());
    if (sequence.is_complete()) break;
    sequence.advance();
  }
  result.overlaps = compare_overlaps(result.domains, test.points_per_decade);
  result.curve = stitch(result.domains, test.times, test.points_per_decade);
  if (test.boundary == Boundary::traction) convert_creep(result);
  return result;
}

}  // namespace breccia
