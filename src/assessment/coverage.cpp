#include "assessment/coverage.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/display.hpp"

namespace breccia {
namespace {

/// The observations of a composite at one temperature, as the times that they take, 1/omega of those over frequency.
struct ObservedTimes {
  std::size_t composite = 0;
  std::optional<double> temperature = {};
  TimeWindow times = {};
};

std::vector<ObservedTimes> observed_times(const std::vector<Observation>& observations) {
  std::vector<ObservedTimes> all;
  for (const auto& one : observations) {
    const double time = is_over_frequency(one.curve) ? 1.0 / one.at : one.at;
    const auto found = std::ranges::find_if(all, [&](const ObservedTimes& earlier) {
      return earlier.composite == one.composite && earlier.temperature == one.temperature;
    });
    if (found == all.end()) {
      all.push_back({one.composite, one.temperature, {time, time}});
    } else {
      found->times = {std::min(found->times.begin, time), std::max(found->times.end, time)};
    }
  }
  // A responder takes a first and a last time.
  constexpr double apart = 1.001;
  for (auto& one : all) one.times.end = std::max(one.times.end, apart * one.times.begin);
  return all;
}

/// The reason why what was observed is outside of what was sampled with the materials at these scores, in a line;
/// nothing where it is not.
std::optional<std::string> reason_against(const ObservedModel& model, const ObservedTimes& observed,
                                          const Eigen::VectorXd& scores) {
  const auto& composite = model.composites()[observed.composite];
  try {
    std::vector<NewMaterial> own;
    for (const auto& material : model.unknowns().materials_at(scores)) {
      if (find_material(composite.responder.materials(), material.material.name) == nullptr) continue;
      own.push_back(new_material(material.material.name, material));
    }
    auto responder = composite.responder.with(own).within(observed.times);
    if (observed.temperature) responder = responder.at(*observed.temperature);
    static_cast<void>(responder.respond());
  } catch (const InputError& error) {
    const std::string message = error.what();
    return message.substr(0, message.find('\n'));
  }
  return std::nullopt;
}

std::string value_in_words(double value, const std::string& unit) {
  return unit.empty() ? three_digits(value) : display(value, unit);
}

/// Warnings about numbers at the ends of their intervals.
std::vector<std::string> warnings_on_ends(const ObservedModel& model, const ObservedTimes& observed,
                                          const Eigen::VectorXd& scores, const std::vector<Estimate>& estimates) {
  std::vector<std::string> warnings;
  for (std::size_t c = 0; c < model.unknowns().components().size(); ++c) {
    if (model.unknowns().is_of_spectrum(c)) continue;
    const auto& estimate = estimates[c];
    for (const double end : {estimate.interval.lower, estimate.interval.upper}) {
      Eigen::VectorXd moved = scores;
      moved[static_cast<Eigen::Index>(c)] = score_of(estimate.prior, end);
      const auto reason = reason_against(model, observed, moved);
      if (!reason) continue;
      warnings.push_back(fmt::format(
          "{}: {} of {}, the end of its interval, is outside of what its run has sampled: {}",
          model.composites()[observed.composite].name, estimate.name, value_in_words(end, estimate.unit), *reason));
    }
  }
  return warnings;
}

}  // namespace

std::vector<std::string> warnings_on_coverage(const ObservedModel& model, const Eigen::VectorXd& scores,
                                              const std::vector<Estimate>& estimates) {
  std::vector<std::string> warnings;
  for (const auto& observed : observed_times(model.observations())) {
    if (const auto reason = reason_against(model, observed, scores)) {
      warnings.push_back(
          fmt::format("{}: the materials that were found are outside of what its run has sampled, so that its answer "
                      "does not hold: "
                      "{}",
                      model.composites()[observed.composite].name, *reason));
    } else {
      std::ranges::move(warnings_on_ends(model, observed, scores, estimates), std::back_inserter(warnings));
    }
  }
  return warnings;
}

}  // namespace breccia
