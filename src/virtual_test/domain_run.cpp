#include "virtual_test/domain_run.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "discretisation/point_fields_state.hpp"
#include "virtual_test/dynamic_state.hpp"

namespace breccia {
namespace {

/// Number of steps over which one sample of the history is averaged: it changes the time by less than half a per cent,
/// and takes little wall time, so that an interruption is handled soon.
int steps_to_average(double time, double time_step, std::size_t points) {
  constexpr double resolution = 0.005, points_x_steps = 3e7;
  const double steps = std::min(resolution * time / time_step, points_x_steps / static_cast<double>(points));
  return std::max(1, static_cast<int>(steps));
}

/// One sample of the history from the mean of a few steps: the modulus, or under a traction boundary 1 / J.
template <int dim>
Sample averaged_sample(const DynamicTest<dim>& test, const std::vector<Averages<dim>>& steps, double first_time,
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

/// Time after the midpoint of the ramp, in ramp durations, from which on the response equals that to a step [-].
double ramps_to_wait(Boundary boundary) {
  return boundary == Boundary::traction ? 1.0 : 1.5;
}

}  // namespace

template <int dim>
IndexRange<dim> cells_with_fields(const DynamicTest<dim>& test) {
  return own_cells(test.options.formulation, test.discretisation.grid());
}

template <int dim>
DomainRules rules_of(const DynamicTest<dim>& test) {
  const auto& grid = test.discretisation.grid();
  DomainRules rules;
  rules.side = grid.cell_side * std::ranges::max(grid.cells);
  rules.density = mean_density(test.discretisation, test.materials);
  rules.times = test.times;
  rules.mass_scaling_factors = test.options.mass_scaling_factors;
  rules.overlap = test.options.overlap;
  return rules;
}

/// A material with the Prony terms that matter in the window of a domain.
struct ReducedMaterial {
  Material material;
  std::size_t terms = 0;
  double error_bound = 0.0;  ///< relative error bound of the reduction [-]
};

ReducedMaterial reduced(const Material& material, const TimeWindow& window, double tolerance) {
  const auto bulk = reduce_to_window(material.bulk, window, tolerance);
  const auto shear = reduce_to_window(material.shear, window, tolerance);
  return {{material.name, material.density, bulk.series, shear.series},
          bulk.series.terms().size() + shear.series.terms().size(),
          std::max(bulk.error_bound, shear.error_bound)};
}

/// Reduces G and K + G/3, the moduli of mixed cells. K of a mixture has terms of both, and those of G cancel in K +
/// G/3: a reduction of K by itself would keep terms that the reduced G no longer has.
ReducedMaterial reduced_in_plane_strain(const Material& material, const TimeWindow& window, double tolerance) {
  const auto bulk = reduce_to_window(plane_strain_bulk_modulus(material), window, tolerance);
  const auto shear = reduce_to_window(material.shear, window, tolerance);
  const auto terms = shear.series.terms().size() + (material.bulk.is_elastic() ? 0 : bulk.series.terms().size());
  return {{material.name, material.density, PronySeries::difference(bulk.series, shear.series.scaled(1.0 / 3.0)),
           shear.series},
          terms,
          std::max(bulk.error_bound, shear.error_bound)};
}

/// The materials of a test, by PhaseIndex and then those of mixtures, with the terms that matter in a window.
template <int dim>
std::vector<ReducedMaterial> reduced_materials(const DynamicTest<dim>& test, const TimeWindow& window) {
  const auto reduce = dim == 2 && !test.discretisation.mixtures().empty() ? reduced_in_plane_strain : reduced;
  std::vector<ReducedMaterial> materials;
  for (const auto& material : test.materials) {
    materials.push_back(reduce(material, window, test.options.reduction_tolerance));
  }
  return materials;
}

/// The largest number of terms of a phase.
template <int dim>
std::size_t most_terms(const DynamicTest<dim>& test, const std::vector<ReducedMaterial>& materials) {
  std::size_t most = 0;
  const auto phases = materials.size() - test.discretisation.mixtures().size();
  for (std::size_t phase = 0; phase < phases; ++phase) most = std::max(most, materials[phase].terms);
  return most;
}

template <int dim>
std::size_t terms_in(const DynamicTest<dim>& test, const TimeWindow& window) {
  return most_terms(test, reduced_materials(test, window));
}

template <int dim>
PreparedDomain<dim> prepare(const DynamicTest<dim>& test, const DomainRules& rules, const ShearModulusBounds& bounds,
                            const DomainSequence& sequence) {
  const double begin = sequence.expected_begin();
  const double end = std::max(sequence.last_time(), begin);
  constexpr double early = 1.0 / 6.0;
  TimeDomain domain;
  domain.mass_scaling = sequence.mass_scaling();
  auto reduced_to_domain = reduced_materials(test, {begin, end});
  domain.terms = most_terms(test, reduced_to_domain);
  std::vector<Material> materials;
  for (auto& [material, terms, error_bound] : reduced_to_domain) {
    materials.push_back(std::move(material));
    domain.reduction_error = std::max(domain.reduction_error, error_bound);
  }
  domain.time_step =
      test.options.courant * stable_time_step(test.discretisation, materials, test.volumetric, domain.mass_scaling);
  // While the factors rise, the window begins, by definition, after a known number of transits, which gives the
  // duration of one. A factor that falls again is valid long before its window begins. The second estimate is lower,
  // since the composite is stiffer during the ramp.
  const double transit = std::min(begin / (2.0 * there_and_back_transits),
                                  rules.transit(domain.mass_scaling, bounds.lower(early * begin)));
  const double ramp_transits =
      test.boundary == Boundary::traction ? test.options.creep_ramp_transits : test.options.ramp_transits;
  domain.ramp =
      test.options.ramp_time ? *test.options.ramp_time * std::sqrt(domain.mass_scaling) : ramp_transits * transit;
  constexpr double most_steps = 1e10;
  if (!(end / domain.time_step < most_steps)) {
    throw NumericalError(
        fmt::format("time domains: {:.3e} s would take {:.1e} steps of {:.1e} s; the composite relaxes so far before "
                    "that time that "
                    "waves hardly cross the box; give an earlier last time",
                    end, end / domain.time_step, domain.time_step));
  }
  DynamicProblem<dim> problem = {.discretisation = test.discretisation,
                                 .materials = std::move(materials),
                                 .volumetric = test.volumetric,
                                 .mass_scaling = domain.mass_scaling,
                                 .time_step = domain.time_step,
                                 .boundary = test.boundary,
                                 .load = unit_strain<dim>(test.load),
                                 .traction = unit_stress<dim>(test.load),
                                 .ramp = StrainRamp(domain.ramp),
                                 .start = test.options.start};
  return {std::move(problem), std::move(domain)};
}

template <int dim>
bool goes_on(const DynamicTest<dim>& test, const ShearModulusBounds& bounds, const TimeDomain& domain,
             const Sample& sample, DomainSequence& sequence) {
  // Shear waves determine the validity under all loads; under a bulk load their speed is estimated.
  const double shear_modulus = test.load != Load::bulk ? sample.modulus : bounds.lower(sample.time);
  return sample.time <= ramps_to_wait(test.boundary) * domain.ramp || sequence.observe(sample.time, shear_modulus);
}

template <int dim>
DomainRun<dim>::DomainRun(const DynamicTest<dim>& test, PreparedDomain<dim> prepared,
                          std::span<const double> field_times)
    : test_(&test),
      domain_(std::move(prepared.domain)),
      solver_(make_dynamic_solver(test.options.formulation, std::move(prepared.problem), test.threads)),
      field_times_(field_times) {}

template <int dim>
Sample DomainRun<dim>::take_sample(double expected_begin) {
  steps_.clear();
  const double time = solver_->time();
  const auto points = test_->discretisation.points();
  solver_->advance(steps_to_average(std::max(time, expected_begin), domain_.time_step, points), steps_);
  const auto sample = averaged_sample(*test_, steps_, time, domain_.time_step);
  const bool creeps = test_->boundary == Boundary::traction;
  if (!creeps || time >= 0.5 * domain_.ramp) domain_.history.push_back(sample);
  domain_.steps = solver_->steps_taken();
  domain_.seconds = seconds_before_ + std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  while (fields_.size() < field_times_.size() && sample.time >= field_times_[fields_.size()]) {
    fields_.push_back({solver_->time(), solver_->fields()});
  }
  return sample;
}

template <int dim>
void DomainRun<dim>::save(StateWriter& state) const {
  save_domain(state, "/running", domain_);
  breccia::save(state, "/running/fields", test_->discretisation.grid(), fields_);
  solver_->save(state, "/solver");
}

template <int dim>
void DomainRun<dim>::restore(const StateReader& state) {
  domain_ = read_domain(state, "/running");
  fields_ = read_fields(state, "/running/fields", test_->discretisation, cells_with_fields(*test_));
  seconds_before_ = domain_.seconds;
  solver_->restore(state, "/solver");
}

#define BRECCIA_INSTANTIATE(dim)                                                                               \
  template IndexRange<dim> cells_with_fields(const DynamicTest<dim>&);                                         \
  template DomainRules rules_of(const DynamicTest<dim>&);                                                      \
  template std::size_t terms_in(const DynamicTest<dim>&, const TimeWindow&);                                   \
  template PreparedDomain<dim> prepare(const DynamicTest<dim>&, const DomainRules&, const ShearModulusBounds&, \
                                       const DomainSequence&);                                                 \
  template bool goes_on(const DynamicTest<dim>&, const ShearModulusBounds&, const TimeDomain&, const Sample&,  \
                        DomainSequence&);                                                                      \
  template class DomainRun<dim>;
BRECCIA_INSTANTIATE(2)
BRECCIA_INSTANTIATE(3)
#undef BRECCIA_INSTANTIATE

}  // namespace breccia
