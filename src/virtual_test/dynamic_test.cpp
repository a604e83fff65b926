#include "virtual_test/dynamic_test.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/fit.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "checkpoint/checkpoint.hpp"
#include "discretisation/point_fields_state.hpp"
#include "parallel/session.hpp"
#include "quasistatic/reduced/stiff_composite.hpp"
#include "virtual_test/domain_run.hpp"
#include "virtual_test/dynamic_state.hpp"
#include "virtual_test/stitching.hpp"
#include "virtual_test/test_times.hpp"

namespace breccia {
namespace {

template <int dim>
void require_complete(const DynamicTest<dim>& test) {
  require_loads("dynamic test", dim, std::span(&test.load, 1));
  require_times("dynamic test", test.times, test.points_per_decade, test.field_times);
  require_phases("dynamic test", test.discretisation, test.materials.size());
  if (!(test.options.courant > 0.0) || test.options.courant > 1.0) {
    throw InputError(fmt::format("dynamic test: expected a courant number in (0, 1], got {}", test.options.courant));
  }
}

/// Approximate memory of one run on a grid [B].
std::size_t memory_of(const DynamicTest<2>& test, const Grid<2>& grid, std::size_t terms) {
  const auto points = grid.cell_count() * Discretisation<2>::points_per_cell;
  const auto nodes = grid.node_count();
  const std::size_t results = points * sizeof(double) * 9;
  if (test.options.formulation == Formulation::classical) return results + points * (180 + 24 * terms) + nodes * 72;
  return results + nodes * 5 * sizeof(double) + points / 4 * (8 + 5 * sizeof(double) * terms);
}

std::size_t memory_of(const DynamicTest<3>& test, const Grid<3>& grid, std::size_t terms) {
  const auto cells = grid.cell_count(), points = cells * Discretisation<3>::points_per_cell;
  const auto nodes = grid.node_count();
  // The memory has three lists of the phases of the points (of the stage, of the test and of its run), and the fields
  // of the cells.
  constexpr std::size_t numbers_of_fields = 15;
  const std::size_t rest = points * 3 * sizeof(PhaseIndex) +
                           cells * test.field_times.size() * (sizeof(PhaseIndex) + numbers_of_fields * sizeof(double));
  if (test.options.formulation == Formulation::classical) return rest + points * (280 + 48 * terms) + nodes * 112;
  return rest + nodes * 7 * sizeof(double) + cells * (8 + 18 * sizeof(double) * terms);
}

/// The window of a domain that is used. A domain that is valid earlier than expected is used from the expected time on,
/// since the domain before it is better at earlier times. The first domain is used from the beginning, which may be
/// earlier than expected where its mass scaling factor is given.
TimeWindow window_wanted(const DomainSequence& sequence) {
  auto window = sequence.window().value_or(TimeWindow{});
  if (!sequence.is_first()) {
    window.begin = std::max(window.begin, std::min(sequence.expected_begin(), window.end));
  }
  return window;
}

}  // namespace

template <int dim>
double mean_density(const Discretisation<dim>& discretisation, const std::vector<Material>& materials) {
  require_phases("mean density", discretisation, materials.size());
  const auto fractions = discretisation.fractions(materials.size());
  double density = 0.0;
  for (std::size_t m = 0; m < materials.size(); ++m) density += fractions[m] * materials[m].density;
  return density;
}

namespace {

/// A lower estimate of the composite's shear modulus at the first time [Pa]. Under a traction boundary a box may be
/// softer than the lower bound of an infinite body; without mixed cells the error of the grid compensates for that.
template <int dim>
double least_modulus(const DynamicTest<dim>& test, const ShearModulusBounds& bounds) {
  constexpr double softening = 0.7;
  const bool is_softer = test.boundary == Boundary::traction && !test.discretisation.mixtures().empty();
  return (is_softer ? softening : 1.0) * bounds.lower(test.times.begin);
}

}  // namespace

template <int dim>
std::vector<TimeDomain> plan_dynamic_test(const DynamicTest<dim>& coarse, double refinement) {
  require_complete(coarse);
  // The time step is proportional to the side of a cell.
  auto test = coarse;
  test.options.courant /= refinement;
  const auto rules = rules_of(test);
  const ShearModulusBounds bounds(test.discretisation, test.materials);
  DomainSequence sequence(rules, least_modulus(test, bounds));
  std::vector<TimeDomain> domains;
  for (;;) {
    auto domain = prepare(test, rules, bounds, sequence).domain;
    constexpr double increase = 1.01;
    double time = std::min(0.5 * sequence.expected_begin(), test.times.end);
    while (sequence.observe(time, bounds.estimate(time))) time *= increase;
    domain.window = window_wanted(sequence);
    domain.steps = static_cast<std::int64_t>(std::ceil((time + 0.5 * domain.ramp) / domain.time_step));
    domains.push_back(std::move(domain));
    if (sequence.is_complete()) return domains;
    sequence.advance();
  }
}

template <int dim>
double dynamic_memory(const DynamicTest<dim>& test, double refinement) {
  require_complete(test);
  const auto rules = rules_of(test);
  const ShearModulusBounds bounds(test.discretisation, test.materials);
  // A domain is expected to begin at this time or later.
  const double first = DomainSequence(rules, least_modulus(test, bounds)).expected_begin();
  constexpr double increase = 2.0;
  std::size_t terms = 0;
  for (double begin = std::min(first, test.times.end); begin <= test.times.end; begin *= increase) {
    terms = std::max(terms, terms_in(test, {begin, std::max(rules.last_time(begin), begin)}));
  }
  auto grid = test.discretisation.grid();
  for (auto& cells : grid.cells) cells = static_cast<int>(std::lround(cells * refinement));
  return static_cast<double>(memory_of(test, grid, terms));
}

template <int dim>
double trial_speed(const DynamicTest<dim>& test) {
  require_complete(test);
  const ShearModulusBounds bounds(test.discretisation, test.materials);
  const auto rules = rules_of(test);
  const DomainSequence sequence(rules, least_modulus(test, bounds));
  auto preparation = prepare(test, rules, bounds, sequence);
  const auto solver = make_dynamic_solver(test.options.formulation, std::move(preparation.problem), test.threads);
  std::vector<Averages<dim>> averages;
  // A fixed amount of work, the same on all processes, of a few tenths of a second.
  const double points_x_steps = test.options.formulation == Formulation::classical ? 3e6 : 1e8;
  const auto steps = static_cast<int>(points_x_steps / static_cast<double>(test.discretisation.points()));
  const auto start = std::chrono::steady_clock::now();
  solver->advance(std::max(steps, 10), averages);
  const auto seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return static_cast<double>(test.discretisation.points()) * static_cast<double>(solver->steps_taken()) / seconds;
}

namespace {

/// Throws InputError where voids leave the composite no stiffness. Several processes divide a box in another way than
/// the quasi-static method, and go on without this check.
template <int dim>
void require_stiff_under_load(const DynamicTest<dim>& test) {
  if (parallel::ranks() > 1) return;
  const auto& discretisation = test.discretisation;
  const auto phases = std::min<std::size_t>(discretisation.first_mixture(), test.materials.size());
  const auto materials = std::span(test.materials).first(phases);
  require_stiff(QuasistaticProblem<dim>{.discretisation = discretisation,
                                        .materials = {materials.begin(), materials.end()},
                                        .volumetric = test.volumetric,
                                        .boundary = test.boundary},
                std::array{test.load});
}

/// Converts 1 / J to the creep compliance and then to the relaxation modulus.
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

/// Runs the time domains of a test one after the other, or restores them from an earlier run.
template <int dim>
class DynamicRun {
 public:
  DynamicRun(const DynamicTest<dim>& test, const ProgressObserver& observer, const DomainObserver& finished,
             Checkpoint* checkpoint)
      : test_(test),
        observer_(observer),
        finished_(finished),
        checkpoint_(checkpoint),
        earlier_(checkpoint != nullptr ? checkpoint->earlier() : nullptr),
        rules_(rules_of(test)),
        bounds_(test.discretisation, test.materials),
        sequence_(rules_, least_modulus(test, bounds_)),
        furthest_(test.times.begin),
        fields_{test.discretisation.grid(), {}} {
    if (earlier_ == nullptr) return;
    past_ = read_domains(*earlier_);
    fields_.at_times = read_fields(*earlier_, "/fields", test.discretisation, cells_with_fields(test));
  }

  DynamicTestResult run() {
    for (;;) {
      auto prepared = prepare(test_, rules_, bounds_, sequence_);
      const bool is_past = result_.domains.size() < past_.size();
      result_.domains.push_back(is_past ? take_over(past_[result_.domains.size()]) : run(std::move(prepared)));
      if (finished_) finished_(result_.domains.back());
      if (sequence_.is_complete()) break;
      sequence_.advance();
    }
    result_.fields = std::move(fields_);
    return std::move(result_);
  }

 private:
  TimeDomain take_over(TimeDomain& past) {
    static_cast<void>(show(past));
    return std::move(past);
  }

  TimeDomain run(PreparedDomain<dim> prepared) {
    const auto field_times = std::span(test_.field_times).subspan(fields_.at_times.size());
    DomainRun<dim> domain(test_, std::move(prepared), field_times);
    bool is_over = false;
    if (earlier_ != nullptr && result_.domains.size() == past_.size() && earlier_->has("/running")) {
      domain.restore(*earlier_);
      is_over = !show(domain.domain());
    }
    while (!is_over) {
      const auto sample = domain.take_sample(sequence_.expected_begin());
      is_over = !goes_on(test_, bounds_, domain.domain(), sample, sequence_);
      tell(domain.domain(), sample.time);
      if (!is_over) save_if_due(domain);
    }
    domain.domain().window = window_wanted(sequence_);
    keep_fields(domain, field_times);
    return std::move(domain.domain());
  }

  /// Passes the history of a restored domain to the sequence. Returns false when the domain is finished.
  bool show(const TimeDomain& domain) {
    return std::ranges::all_of(
        domain.history, [&](const Sample& sample) { return goes_on(test_, bounds_, domain, sample, sequence_); });
  }

  void tell(const TimeDomain& running, double time) {
    if (!observer_) return;
    furthest_ = std::max(furthest_, time);
    const double log_range = std::log(test_.times.end / test_.times.begin);
    const double done = std::log(furthest_ / test_.times.begin);
    const double speed = running.point_steps_per_second(test_.discretisation.points());
    observer_({.share = log_range > 0.0 ? std::min(1.0, done / log_range) : 0.0,
               .details = fmt::format("time domain {} at {:.3g} s, {:.0f} million points x steps/s",
                                      result_.domains.size() + 1, time, speed / 1e6)});
  }

  void save_if_due(const DomainRun<dim>& domain) {
    if (checkpoint_ == nullptr || !checkpoint_->is_due()) return;
    checkpoint_->save([&](StateWriter& state) {
      save_domains(state, result_.domains);
      save(state, "/fields", fields_.grid, fields_.at_times);
      domain.save(state);
    });
  }

  /// Takes the fields at each time from the first domain that is valid there, since it has the smallest mass scaling
  /// factor.
  void keep_fields(DomainRun<dim>& domain, std::span<const double> times) {
    auto& fields = domain.fields();
    for (std::size_t i = 0; i < fields.size() && times[i] <= domain.domain().window.end; ++i) {
      fields_.at_times.push_back(std::move(fields[i]));
    }
  }

  const DynamicTest<dim>& test_;
  const ProgressObserver& observer_;
  const DomainObserver& finished_;
  Checkpoint* checkpoint_;
  const StateReader* earlier_;
  DomainRules rules_;
  ShearModulusBounds bounds_;
  DomainSequence sequence_;
  double furthest_;               // latest time that a domain has reached [s]
  std::vector<TimeDomain> past_;  // domains that the earlier run has finished
  GridFields<dim> fields_;        // fields from the finished domains
  DynamicTestResult result_;
};

}  // namespace

template <int dim>
DynamicTestResult run_dynamic_test(const DynamicTest<dim>& test, const ProgressObserver& observer,
                                   const DomainObserver& finished, Checkpoint* checkpoint) {
  require_complete(test);
  require_stiff_under_load(test);
  auto result = DynamicRun<dim>(test, observer, finished, checkpoint).run();
  result.overlaps = compare_overlaps(result.domains, test.points_per_decade);
  result.curve = stitch(result.domains, test.times, test.points_per_decade);
  if (test.boundary == Boundary::traction) convert_creep(result);
  return result;
}

#define BRECCIA_INSTANTIATE(dim)                                                                                       \
  template std::vector<TimeDomain> plan_dynamic_test(const DynamicTest<dim>&, double);                                 \
  template double dynamic_memory(const DynamicTest<dim>&, double);                                                     \
  template DynamicTestResult run_dynamic_test(const DynamicTest<dim>&, const ProgressObserver&, const DomainObserver&, \
                                              Checkpoint*);                                                            \
  template double trial_speed(const DynamicTest<dim>&);                                                                \
  template double mean_density(const Discretisation<dim>&, const std::vector<Material>&);
BRECCIA_INSTANTIATE(2)
BRECCIA_INSTANTIATE(3)
#undef BRECCIA_INSTANTIATE

}  // namespace breccia
