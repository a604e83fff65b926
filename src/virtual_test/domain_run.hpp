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

/// What decides about the domains of a test.
DomainRules rules_of(const DynamicTest& test);

/// A problem for one time domain, and what is told of it.
struct PreparedDomain {
  DynamicProblem<2> problem;
  TimeDomain domain;
};

/// Throws NumericalError when the times would take too many steps.
PreparedDomain prepare(const DynamicTest& test, const DomainRules& rules, const ShearModulusBounds& bounds,
                       const DomainSequence& sequence);

/// Shows a sample of a domain to the sequence, once the ramp is long over. False when the domain has seen enough.
bool goes_on(const DynamicTest& test, const ShearModulusBounds& bounds, const TimeDomain& domain, const Sample& sample,
             DomainSequence& sequence);

/// A time domain under way.
class DomainRun {
 public:
  /// With the times [s] at which fields are wanted.
  DomainRun(const DynamicTest& test, PreparedDomain prepared, std::span<const double> field_times);

  /// Takes some steps, for a time that the domain is expected to be valid from [s], and returns their mean. Keeps the
  /// fields just after a time at which they are wanted.
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
  double seconds_before_ = 0.0;  ///< of the runs that this one goes on from [s]
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace breccia
