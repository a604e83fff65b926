#include "virtual_test/time_domains.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/material.hpp"

namespace breccia {

double DomainRules::transit(double mass_scaling, double modulus) const {
  return side / shear_wave_speed(modulus, mass_scaling * density);
}

double DomainRules::last_time(double begin) const {
  return mass_scaling_factors.empty() ? std::min(times.end, longest * begin) : times.end;
}

double DomainRules::admissible_factor(double time, double modulus) const {
  const double transits = time / (2.0 * there_and_back_transits * side);
  return transits * transits * modulus / density;
}

DomainSequence::DomainSequence(DomainRules rules, double modulus)
    : rules_(std::move(rules)), expected_begin_(rules_.times.begin) {
  if (rules_.mass_scaling_factors.empty()) {
    constexpr double margin = 0.9;
    factor_ = margin * rules_.admissible_factor(rules_.times.begin, modulus);
  } else {
    factor_ = rules_.mass_scaling_factors.front();
    expected_begin_ = 2.0 * there_and_back_transits * rules_.transit(factor_, modulus);
  }
}

double DomainSequence::last_time() const {
  return rules_.last_time(expected_begin_);
}

std::optional<double> DomainSequence::next_factor() const {
  const auto& factors = rules_.mass_scaling_factors;
  if (factors.empty()) return rising_ ? factor_ * rules_.factor_ratio : factor_ / rules_.factor_ratio;
  return given_ + 1 < factors.size() ? std::optional(factors[given_ + 1]) : std::nullopt;
}

void DomainSequence::throw_late(double time) const {
  throw NumericalError(fmt::format(
      "time domains: with mass scaling factor {:.3g} the run is valid from {:.3e} s on, after {:g} there-and-back "
      "transits of the shear wave, but times begin at {:.3e} s; give a first mass scaling factor below {:.2g}",
      factor_, time, there_and_back_transits, rules_.times.begin,
      factor_ * rules_.times.begin * rules_.times.begin / (time * time)));
}

bool DomainSequence::observe(double time, double modulus) {
  constexpr double rounding = 1e-9;
  const double admissible = rules_.admissible_factor(time, modulus);
  // Ringing may bring the admissible factor below the limit soon after the window has begun; the window continues.
  constexpr double settled = 1.2;
  if (admissible < factor_ && !(window_ && time < settled * window_->begin)) {
    if (time < expected_begin_) window_.reset();
    expired_ = window_.has_value();
    return !expired_ && time < rules_.times.end;
  }
  if (!window_) {
    if (is_first_ && time > rules_.times.begin * (1.0 + rounding)) throw_late(time);
    window_ = TimeWindow{time, time};
  }
  window_->end = time;
  if (time >= rules_.times.end) {
    // If the next given factor is admissible already, its domain runs, too.
    complete_ = rules_.mass_scaling_factors.empty() || !next_admissible_;
    return false;
  }
  // Earlier times are covered by the previous domain.
  if (time < expected_begin_) return true;
  // Far above its minimum the admissible factor rises again, as on a plateau after a steep fall of the modulus.
  lowest_admissible_ = std::min(lowest_admissible_, admissible);
  if (admissible > 2.0 * lowest_admissible_) rising_ = true;
  const auto next = next_factor();
  if (rising_ && next && admissible >= *next) {
    if (!next_admissible_) next_admissible_ = time;
    return time < rules_.overlap * *next_admissible_;
  }
  next_admissible_.reset();
  return time < last_time();
}

void DomainSequence::advance() {
  if (!window_) {
    throw NumericalError(
        fmt::format("time domains: with mass scaling factor {:.3g} the run is valid nowhere up to {:.3e} s, which is "
                    "less than {:g} there-and-back transits of the shear wave; give smaller mass scaling factors",
                    factor_, rules_.times.end, there_and_back_transits));
  }
  if (expired_) {
    if (!rules_.mass_scaling_factors.empty()) {
      throw NumericalError(fmt::format(
          "time domains: with mass scaling factor {:.3g} the run is valid from {:.3e} to {:.3e} s only, since the "
          "composite relaxes faster than waves cross the box; give a smaller mass scaling factor or an earlier last "
          "time",
          factor_, window_->begin, window_->end));
    }
    rising_ = false;
  }
  if (next_admissible_ || expired_) {
    factor_ = next_factor().value();
    if (given_ + 1 < rules_.mass_scaling_factors.size()) ++given_;
  }
  const double begin = next_admissible_ ? *next_admissible_ : window_->end / rules_.overlap;
  if (rules_.mass_scaling_factors.empty() && window_->end <= furthest_) {
    throw NumericalError(fmt::format(
        "time domains: none with a smaller mass scaling factor goes beyond {:.3e} s; likely causes: ringing after too "
        "short a ramp, or a composite that relaxes faster than waves cross the box",
        window_->end));
  }
  furthest_ = window_->end;
  expected_begin_ = begin;
  expired_ = false;
  is_first_ = false;
  lowest_admissible_ = std::numeric_limits<double>::infinity();
  window_.reset();
  next_admissible_.reset();
}

}  // namespace breccia
