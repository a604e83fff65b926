#include "breccia/experiment/dynamic_test.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/fit.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "domain_run.hpp"
#include "dynamic_state.hpp"
#include "test_times.hpp"

namespace breccia {
namespace {

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
  const auto start = std::chrono::steady_clock::now();
  solver->advance(std::max(steps, 10), averages);
  const auto seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return static_cast<double>(test.discretisation.points()) * static_cast<double>(solver->steps_taken()) / seconds;
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

/// Shows the sequence what a domain has seen already. False when the domain has seen enough.
bool show(const DynamicTest& test, const ShearModulusBounds& bounds, const TimeDomain& domain,
          DomainSequence& sequence) {
  return std::ranges::all_of(domain.history,
                             [&](const Sample& sample) { return goes_on(test, bounds, domain, sample, sequence); });
}

}  // namespace

DynamicTestResult run_dynamic_test(const DynamicTest& test, const DynamicObserver& observer, Checkpoint* checkpoint) {
  require_complete(test);
  const auto rules = rules_of(test);
  const ShearModulusBounds bounds(test.discretisation, test.materials);
  DomainSequence sequence(rules, bounds.lower(test.times.begin));
  const auto points = static_cast<double>(test.discretisation.points());
  const double log_range = std::log(test.times.end / test.times.begin);
  double furthest = test.times.begin;
  DynamicTestResult result;

  const auto* earlier = checkpoint != nullptr ? checkpoint->earlier() : nullptr;
  auto past = earlier != nullptr ? read_domains(*earlier) : std::vector<TimeDomain>();
  if (earlier != nullptr) result.fields = read_fields(*earlier, "/fields", test.discretisation);

  const auto tell = [&](const TimeDomain& running, double time) {
    if (!observer.progress) return;
    furthest = std::max(furthest, time);
    const double done = std::log(furthest / test.times.begin);
    observer.progress({.domain = result.domains.size(),
                       .density_factor = running.density_factor,
                       .time = time,
                       .share = log_range > 0.0 ? std::min(1.0, done / log_range) : 0.0,
                       .point_steps_per_second = points * static_cast<double>(running.steps) / running.seconds});
  };
  const auto run = [&](PreparedDomain prepared) {
    const auto field_times = std::span(test.field_times).subspan(result.fields.size());
    DomainRun domain(test, std::move(prepared), field_times);
    bool is_over = false;
    if (earlier != nullptr && result.domains.size() == past.size() && earlier->has("/running")) {
      domain.restore(*earlier);
      is_over = !show(test, bounds, domain.domain(), sequence);
    }
    while (!is_over) {
      const auto sample = domain.take_sample(sequence.expected_begin());
      is_over = !goes_on(test, bounds, domain.domain(), sample, sequence);
      tell(domain.domain(), sample.time);
      if (is_over || checkpoint == nullptr || !checkpoint->is_due()) continue;
      checkpoint->save([&](StateWriter& state) {
        save_domains(state, result.domains);
        save(state, "/fields", result.fields);
        domain.save(state);
      });
    }
    domain.domain().window = window_wanted(sequence);
    // The first domain that is valid at a time tells its fields: the lightest.
    auto& fields = domain.fields();
    for (std::size_t i = 0; i < fields.size() && field_times[i] <= domain.domain().window.end; ++i) {
      result.fields.push_back(std::move(fields[i]));
    }
    return std::move(domain.domain());
  };

  for (;;) {
    auto prepared = prepare(test, rules, bounds, sequence);
    if (result.domains.size() < past.size()) {
      auto& done = past[result.domains.size()];
      static_cast<void>(show(test, bounds, done, sequence));
      result.domains.push_back(std::move(done));
    } else {
      result.domains.push_back(run(std::move(prepared)));
    }
    if (observer.finished) observer.finished(result.domains.back());
    if (sequence.is_complete()) break;
    sequence.advance();
  }
  result.overlaps = compare_overlaps(result.domains, test.points_per_decade);
  result.curve = stitch(result.domains, test.times, test.points_per_decade);
  if (test.boundary == Boundary::traction) convert_creep(result);
  return result;
}

void save_result(StateWriter& state, const DynamicTestResult& result) {
  save_domains(state, result.domains);
  save(state, "/fields", std::span<const TimedFields>());
}

}  // namespace breccia
