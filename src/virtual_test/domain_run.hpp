#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "breccia/virtual_test/modulus_bounds.hpp"

#include "checkpoint/state.hpp"
#include "virtual_test/dynamic_test.hpp"
#include "virtual_test/time_domains.hpp"

namespace breccia {

// Instantiated for 2 and 3 dimensions.

/// The cells whose fields in a test are on this process.
template <int dim>
IndexRange<dim> cells_with_fields(const DynamicTest<dim>& test);

/// The rules by which the time domains of a test are chosen.
template <int dim>
DomainRules rules_of(const DynamicTest<dim>& test);

/// The largest number of Prony terms that is integrated in a domain of this window (TimeDomain::terms).
template <int dim>
std::size_t terms_in(const DynamicTest<dim>& test, const TimeWindow& window);

/// The dynamic problem of one time domain, with the record of the domain.
template <int dim>
struct PreparedDomain {
  DynamicProblem<dim> problem;
  TimeDomain domain;
};

/// Prepares the next time domain of a test. Throws NumericalError when it would take too many steps.
template <int dim>
PreparedDomain<dim> prepare(const DynamicTest<dim>& test, const DomainRules& rules, const ShearModulusBounds& bounds,
                            const DomainSequence& sequence);

/// Passes a sample of a domain to DomainSequence::observe() if it is late enough after the ramp. Returns false when the
/// domain is finished.
template <int dim>
bool goes_on(const DynamicTest<dim>& test, const ShearModulusBounds& bounds, const TimeDomain& domain,
             const Sample& sample, DomainSequence& sequence);

/// A running time domain.
template <int dim>
class DomainRun {
 public:
  /// `field_times` are the times [s] at which fields are wanted.
  DomainRun(const DynamicTest<dim>& test, PreparedDomain<dim> prepared, std::span<const double> field_times);

  /// Takes some steps and returns their mean as a sample. The domain is expected to be valid from `expected_begin` [s].
  /// Keeps the fields after these steps if the sample is the first one at or after a field time.
  Sample take_sample(double expected_begin);

  [[nodiscard]] TimeDomain& domain() noexcept { return domain_; }
  [[nodiscard]] std::vector<TimedFields<dim>>& fields() noexcept { return fields_; }

  void save(StateWriter& state) const;
  void restore(const StateReader& state);

 private:
  const DynamicTest<dim>* test_;
  TimeDomain domain_;
  std::unique_ptr<DynamicSolver<dim>> solver_;
  std::span<const double> field_times_;
  std::vector<TimedFields<dim>> fields_;
  std::vector<Averages<dim>> steps_;
  double seconds_before_ = 0.0;  ///< wall time of the earlier runs that were resumed [s]
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace breccia
