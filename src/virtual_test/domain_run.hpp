#pragma once

#include <chrono>
#include <memory>
#include <span>
#include <vector>

#include "breccia/checkpoint/state.hpp"
#include "breccia/virtual_test/dynamic_test.hpp"
#include "breccia/virtual_test/modulus_bounds.hpp"
#include "breccia/virtual_test/time_domains.hpp"

namespace breccia {

/// The rules by which the time domains of a test are chosen.
DomainRules rules_of(const DynamicTest& test);

/// The dynamic problem of one time domain, with the record of the domain.
struct PreparedDomain {
  DynamicProblem<2> problem;
  TimeDomain domain;
};

/// Prepares the next time domain of a test. Throws NumericalError when it would take too many steps.
PreparedDomain prepare(const DynamicTest& test, const DomainRules& rules, const ShearModulusBounds& bounds,
                       const DomainSequence& sequence);

/// Passes a sample of a domain to DomainSequence::observe() if it is late enough after the ramp. False when the domain
/// is finished.
bool goes_on(const DynamicTest& test, const ShearModulusBounds& bounds, const TimeDomain& domain, const Sample& sample,
             DomainSequence& sequence);

/// A running time domain.
class DomainRun {
 public:
  /// `field_times` are the times [s] at which fields are wanted.
  DomainRun(const DynamicTest& test, PreparedDomain prepared, std::span<const double> field_times);

  /// Takes some steps and returns their mean as a sample. The domain is expected to be valid from `expected_begin` [s].
  /// Keeps the fields after these steps if the sample is the first one at or after a field time.
  Sample take_sample(double expected_begin);

  [[nodiscard]] TimeDomain& domain() noexcept { return domain_; }
  [[nodiscard]] std::vector<TimedFields<2>>& fields() noexcept { return fields_; }

  void save(StateWriter& state) const;
  void restore(const StateReader& state);

 private:
  const DynamicTest* test_;
  TimeDomain domain_;
  std::unique_ptr<DynamicSolver<2>> solver_;
  std::span<const double> field_times_;
  std::vector<TimedFields<2>> fields_;
  std::vector<Averages<2>> steps_;
  double seconds_before_ = 0.0;  ///< wall time of the earlier runs that were resumed [s]
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace breccia
