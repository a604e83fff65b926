#include "assessment/coverage.hpp"

#include <optional>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/display.hpp"

namespace breccia {
namespace {

/// The reason why a composite with these materials is outside of what was sampled, in a line; nothing where it is not.
std::optional<std::string> reason_against(const ObservedComposite& composite,
                                          const std::vector<ShiftedMaterial>& materials) {
  std::vector<NewMaterial> own;
  for (const auto& material : materials) {
    if (find_material(composite.responder.materials(), material.material.name) == nullptr) continue;
    own.push_back(new_material(material.material.name, material));
  }
  try {
    static_cast<void>(composite.responder.with(own).respond());
  } catch (const InputError& error) {
    const std::string message = error.what();
    return message.substr(0, message.find('\n'));
  }
  return std::nullopt;
}

std::string value_in_words(double value, const std::string& unit) {
  return unit.empty() ? three_digits(value) : display(value, unit);
}

}  // namespace

std::vector<std::string> warnings_on_coverage(const ObservedModel& model, const Eigen::VectorXd& scores,
                                              const std::vector<Estimate>& estimates) {
  std::vector<std::string> warnings;
  for (const auto& composite : model.composites()) {
    if (const auto reason = reason_against(composite, model.unknowns().materials_at(scores))) {
      warnings.push_back(
          fmt::format("{}: the materials that were found are outside of what its run has sampled, so that its answer "
                      "does not hold: "
                      "{}",
                      composite.name, *reason));
      continue;
    }
    for (std::size_t c = 0; c < model.unknowns().components().size(); ++c) {
      if (model.unknowns().is_of_spectrum(c)) continue;
      const auto& estimate = estimates[c];
      for (const double end : {estimate.interval.lower, estimate.interval.upper}) {
        Eigen::VectorXd moved = scores;
        moved[static_cast<Eigen::Index>(c)] = score_of(estimate.prior, end);
        const auto reason = reason_against(composite, model.unknowns().materials_at(moved));
        if (!reason) continue;
        warnings.push_back(
            fmt::format("{}: {} of {}, the end of its interval, is outside of what its run has sampled: {}",
                        composite.name, estimate.name, value_in_words(end, estimate.unit), *reason));
      }
    }
  }
  return warnings;
}

}  // namespace breccia
