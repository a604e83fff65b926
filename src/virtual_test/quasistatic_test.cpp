#include "virtual_test/quasistatic_test.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <iterator>
#include <span>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/fit.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "checkpoint/checkpoint.hpp"
#include "films/film_sampling.hpp"
#include "films/film_stepping.hpp"
#include "quasistatic/reduced/carson_path.hpp"
#include "quasistatic/stepping/log_time_stepping.hpp"
#include "virtual_test/quasistatic_test_state.hpp"
#include "virtual_test/reduced_curves.hpp"
#include "virtual_test/test_times.hpp"

namespace breccia {
namespace {

template <int dim>
QuasistaticProblem<dim> problem_of(const QuasistaticTest& test, const Discretisation<dim>& discretisation) {
  return {.discretisation = discretisation,
          .materials = test.materials,
          .volumetric = test.volumetric,
          .boundary = test.boundary,
          .linear = test.options.linear,
          .crystals = test.crystals};
}

/// Materials of the phases that vary, in the order of these phases.
std::vector<Material> varying_materials(const QuasistaticTest& test) {
  std::vector<Material> materials;
  for (const auto& [index, name] : test.varying) materials.push_back(test.materials[index]);
  return materials;
}

/// Moduli of all points of the paths of these materials and of their variants.
template <class PathOf>
std::vector<std::vector<Moduli>> moduli_on_paths(const QuasistaticTest& test, const std::vector<Material>& materials,
                                                 const PathOf& path_of) {
  std::vector<std::vector<Moduli>> moduli;
  const auto append = [&](const std::vector<Material>& of_phases) {
    for (const auto& point : path_of(of_phases)) moduli.push_back(point.moduli);
  };
  append(materials);
  std::ranges::for_each(test.variants, append);
  return moduli;
}

/// Whether the path of the training set ends before these moduli (theory, section 10).
bool is_beyond_the_path(const std::vector<Moduli>& moduli) {
  return std::ranges::any_of(moduli, is_like_softer);
}

/// Whether one point has the larger shear modulus of the first phase or, if these are equal, of the second one, and so
/// on.
bool is_stiffer(const std::vector<Moduli>& one, const std::vector<Moduli>& other) {
  return std::ranges::lexicographical_compare(one, other, std::ranges::greater(), &Moduli::shear, &Moduli::shear);
}

/// Training set of the reduced basis, from stiff to soft.
TrainingPath training_set(const QuasistaticTest& test, const std::vector<Material>& materials) {
  // When the matrix is a fit to a composite, the fit differs a little from the Carson moduli of the composite: the
  // training set has both.
  const auto near_times = [&test](const auto& of_phases) { return carson_path(of_phases, test.times); };
  TrainingPath path = {.phases = test.varying, .points = moduli_on_paths(test, materials, near_times)};
  // With several phases the curve in time takes a network of many unknowns, too many to compute it after each snapshot.
  if (test.varying.size() == 1) path.target = TargetCurve{materials, test.times};
  if (test.options.range == SampledRange::matrix) {
    const auto everywhere = [&test](const auto& of_phases) { return relaxation_path(of_phases, test.times); };
    const auto whole = test.relaxation.empty() ? moduli_on_paths(test, materials, everywhere) : test.relaxation;
    std::ranges::copy_if(whole, std::back_inserter(path.points), std::not_fn(is_beyond_the_path));
  } else if (test.variants.empty()) {
    return path;
  }
  std::ranges::stable_sort(path.points, is_stiffer);
  return path;
}

/// The problem of grains and films under the boundary of the test.
template <int dim>
FilmProblem<dim> problem_of(const QuasistaticTest& test, FilmProblem<dim> films) {
  films.boundary = test.boundary;
  return films;
}

/// Samples the reduced responses of grains and films by load, and takes the fields of the first load.
template <int dim>
std::vector<ReducedResponse> sample(const FilmProblem<dim>& films, const QuasistaticTest& test,
                                    const std::vector<Material>& materials, const TrainingPath& path,
                                    const ProgressObserver& follow, Checkpoint* checkpoint,
                                    QuasistaticTestResult& result) {
  std::vector<Moduli> of_binder;
  for (const auto& moduli : path.points) of_binder.push_back(moduli.front());
  auto sampled = sample_film_responses(problem_of(test, films), test.loads, of_binder, test.options.sampling, follow,
                                       checkpoint, path.target);
  NetworkFields<dim> fields;
  for (const double time : test.field_times) fields.at_times.push_back({time, sampled.fields(0, materials, time)});
  result.fields = std::move(fields);
  result.effort = sampled.effort;
  return std::move(sampled.responses);
}

/// Samples the reduced responses of cells by load, and takes the fields of the first load.
template <int dim>
std::vector<ReducedResponse> sample(const Discretisation<dim>& discretisation, const QuasistaticTest& test,
                                    const std::vector<Material>& materials, const TrainingPath& path,
                                    const ProgressObserver& follow, Checkpoint* checkpoint,
                                    QuasistaticTestResult& result) {
  const auto problem = problem_of(test, discretisation);
  auto sampled = sample_responses(problem, test.loads, path, test.options.sampling, follow, checkpoint);
  GridFields<dim> fields{discretisation.grid(), {}};
  for (const double time : test.field_times) fields.at_times.push_back({time, sampled.fields(0, materials, time)});
  result.fields = std::move(fields);
  result.effort = sampled.effort;
  return std::move(sampled.responses);
}

void run_reduced(const QuasistaticTest& test, QuasistaticTestResult& result, const ProgressObserver& follow,
                 Checkpoint* checkpoint) {
  const auto materials = varying_materials(test);
  const auto path = training_set(test, materials);
  const auto responses = std::visit(
      [&](const auto& composite) { return sample(composite, test, materials, path, follow, checkpoint, result); },
      test.composite);
  const auto times = logarithmic_times(test.times, test.points_per_decade);
  for (const auto& reduced : responses) {
    auto& response = result.responses.emplace_back(reduced_curves(reduced, materials, times));
    for (const auto& moduli : path.points) {
      response.error_estimate = std::max(response.error_estimate, reduced.error_estimate(moduli));
    }
  }
}

/// Throws InputError unless the binder of grains and films alone varies.
void require_test_of_films(const QuasistaticTest& test) {
  if (test.varying.size() != 1) throw InputError("quasi-static test: of films the binder alone varies");
}

void require_varying_phases(const QuasistaticTest& test) {
  for (const auto& [index, name] : test.varying) {
    if (index < test.materials.size()) continue;
    throw InputError(fmt::format("quasi-static test: expected one of the {} phases as the {}, got number {}",
                                 test.materials.size(), name, index));
  }
}

/// Times of the steps: from well before the first requested time to the last one.
std::vector<double> step_times(const QuasistaticTest& test) {
  constexpr double warm_up = 1e-3;
  const int output = test.points_per_decade;
  const int wanted = test.options.steps_per_decade;
  const int per_decade = output * std::max(1, (wanted + output - 1) / output);
  return logarithmic_times({warm_up * test.times.begin, test.times.end}, per_decade);
}

/// Index of the first step at or after a time, apart from rounding.
std::size_t step_at(const std::vector<double>& steps, double time) {
  constexpr double rounding = 1e-9;
  const auto found = std::lower_bound(steps.begin(), steps.end(), time * (1.0 - rounding));
  return static_cast<std::size_t>(found - steps.begin());
}

/// Inserts a time into the steps unless one of them equals it to rounding. Returns the time of that step.
double make_step_at(std::vector<double>& steps, double time) {
  constexpr double rounding = 1e-9;
  const auto place = steps.begin() + static_cast<std::ptrdiff_t>(step_at(steps, time));
  if (place != steps.end() && *place <= time * (1.0 + rounding)) return *place;
  return *steps.insert(place, time);
}

/// Largest relative deviation of a fit from its data, from the given index on.
double worst_from(std::size_t first, const std::vector<double>& data, const FitQuality& quality) {
  double worst = 0.0;
  for (std::size_t i = first; i < data.size(); ++i) {
    worst = std::max(worst, std::abs(quality.fitted[i] / data[i] - 1.0));
  }
  return worst;
}

/// Steps grains and films through time, and takes the fields of the first load.
template <int dim>
std::vector<SteppedResponse> step(const FilmProblem<dim>& films, const QuasistaticTest& test,
                                  const std::vector<double>& steps, const std::vector<double>& field_steps,
                                  const ProgressObserver& follow, Checkpoint* checkpoint,
                                  QuasistaticTestResult& result) {
  const auto& binder = test.materials[test.varying.front().index];
  auto stepped = run_film_stepping(problem_of(test, films), binder, test.loads, steps, follow, field_steps, checkpoint);
  result.fields = NetworkFields<dim>{std::move(stepped.fields)};
  result.effort = stepped.effort;
  return std::move(stepped.responses);
}

/// Steps cells through time, and takes the fields of the first load.
template <int dim>
std::vector<SteppedResponse> step(const Discretisation<dim>& discretisation, const QuasistaticTest& test,
                                  const std::vector<double>& steps, const std::vector<double>& field_steps,
                                  const ProgressObserver& follow, Checkpoint* checkpoint,
                                  QuasistaticTestResult& result) {
  auto stepped =
      run_log_time_stepping(problem_of(test, discretisation), test.loads, steps, follow, field_steps, checkpoint);
  result.fields = GridFields<dim>{discretisation.grid(), std::move(stepped.fields)};
  result.effort = stepped.effort;
  return std::move(stepped.responses);
}

void run_stepping(const QuasistaticTest& test, QuasistaticTestResult& result, const ProgressObserver& follow,
                  Checkpoint* checkpoint) {
  auto steps = step_times(test);
  // The first time of the curve and the times of the fields are added to the steps.
  make_step_at(steps, test.times.begin);
  std::vector<double> field_steps;
  for (const double time : test.field_times) field_steps.push_back(make_step_at(steps, time));
  const auto stepped = std::visit(
      [&](const auto& composite) { return step(composite, test, steps, field_steps, follow, checkpoint, result); },
      test.composite);
  const auto times = logarithmic_times(test.times, test.points_per_decade);
  const auto first_step = step_at(steps, test.times.begin);
  for (const auto& found : stepped) {
    auto& response = result.responses.emplace_back();
    response.load = found.load;
    std::vector<double> values;
    for (const double time : times) {
      const auto step = step_at(steps, time);
      values.push_back(found.values[step]);
      response.error_estimate = std::max(response.error_estimate, found.error_estimates[step]);
    }
    // All steps are converted: creep before the first time of the curve has an influence on the modulus.
    if (test.boundary == Boundary::traction) {
      const auto fit = fit_creep(steps, found.values);
      response.series = relaxation_modulus(fit.compliance);
      response.fit_error = worst_from(first_step, found.values, fit.quality);
    } else {
      const auto fit = fit_relaxation(steps, found.values);
      response.series = fit.series;
      response.fit_error = worst_from(first_step, found.values, fit.quality);
    }
    for (std::size_t i = 0; i < times.size(); ++i) {
      if (test.boundary == Boundary::traction) {
        response.compliance.push_back({times[i], values[i]});
        response.modulus.push_back({times[i], response.series.at(times[i])});
      } else {
        response.modulus.push_back({times[i], values[i]});
      }
    }
  }
}

}  // namespace

QuasistaticTestResult run_quasistatic_test(const QuasistaticTest& test, const ProgressObserver& observer,
                                           Checkpoint* checkpoint) {
  require_times("quasi-static test", test.times, test.points_per_decade, test.field_times);
  if (test.loads.empty()) throw InputError("quasi-static test: no loads");
  const bool has_films =
      std::holds_alternative<FilmProblem<2>>(test.composite) || std::holds_alternative<FilmProblem<3>>(test.composite);
  if (test.options.solver == Solver::reduced || has_films) require_varying_phases(test);
  if (has_films) require_test_of_films(test);
  if (checkpoint != nullptr && checkpoint->is_finished()) return read_quasistatic_result(*checkpoint->earlier());
  const auto start = std::chrono::steady_clock::now();
  QuasistaticTestResult result;
  if (test.options.solver == Solver::reduced) {
    run_reduced(test, result, observer, checkpoint);
  } else {
    run_stepping(test, result, observer, checkpoint);
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace breccia
