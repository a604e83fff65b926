#include "homogenisation/material_warnings.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "io/display.hpp"
#include "study/abscissa_words.hpp"
#include "study/chain.hpp"
#include "viscoelasticity/poisson_ratio.hpp"

namespace breccia {
namespace {

std::string pressure(double value) {
  return display(value, "Pa", 4);
}

std::string poisson_warning(const Material& material, double bulk, double shear, const std::string& when) {
  return fmt::format("{}: Poisson's ratio is {:.6g} {} (bulk {}, shear {}); are the units right?", material.name,
                     poisson_ratio(bulk, shear), when, pressure(bulk), pressure(shear));
}

bool has_material(const Stage& stage, const std::string& name) {
  const auto materials = named_materials(stage);
  return std::ranges::find(materials, name, &Material::name) != materials.end();
}

}  // namespace

std::optional<std::string> warning_of_poisson_ratio(const Material& material, const TimeWindow& times,
                                                    Abscissa abscissa) {
  for (const double time : {times.begin, times.end}) {
    const double bulk = material.bulk.at(time), shear = material.shear.at(time);
    const auto when = fmt::format("at {}, below zero", readable_in(abscissa, time));
    if (poisson_ratio(bulk, shear) < 0.0) return poisson_warning(material, bulk, shear, when);
  }
  // Poisson's ratio of a soft binder approaches one half as it relaxes, so only the unrelaxed value is doubtful.
  constexpr double most = 0.49999;
  const double bulk = material.bulk.unrelaxed(), shear = material.shear.unrelaxed();
  if (poisson_ratio(bulk, shear) > most) return poisson_warning(material, bulk, shear, "before it relaxes");
  return std::nullopt;
}

std::vector<std::string> warnings_of_unknown_times(const Material& matrix, const TimeWindow& times, Abscissa abscissa) {
  const auto& terms = matrix.shear.terms();
  if (terms.empty()) return {};
  // A term affects the modulus for about a decade on either side of its time.
  constexpr double decade = 10.0;
  const double slowest = terms.front().relaxation_time, fastest = terms.back().relaxation_time;
  // A single term is taken for a deliberate model; several terms come from data of limited range.
  const bool is_of_data = terms.size() > 1;
  const bool is_in_time = abscissa == Abscissa::time;
  std::vector<std::string> warnings;
  if (is_of_data && times.begin < fastest / decade) {
    warnings.push_back(fmt::format(
        "{} {}, more than a decade {} the fastest relaxation time of its matrix, {}, {}; {} the computed modulus is "
        "constant, unlike that of a real material",
        is_in_time ? "times begin at" : "frequencies end at", readable_in(abscissa, times.begin),
        is_in_time ? "before" : "above that of", matrix.name, readable_in(abscissa, fastest),
        is_in_time ? "until then" : "above it"));
  }
  const bool flows = matrix.shear.equilibrium() == 0.0;
  if ((is_of_data || flows) && times.end > slowest * decade) {
    warnings.push_back(fmt::format(
        "{} {}, more than a decade {} the slowest relaxation time of its matrix, {}, {}; {}",
        is_in_time ? "times end at" : "frequencies begin at", readable_in(abscissa, times.end),
        is_in_time ? "after" : "below that of", matrix.name, readable_in(abscissa, slowest),
        flows
            ? "it has no equilibrium modulus and has flowed away there, so that the computed moduli mean nothing"
            : "there it has its equilibrium modulus, which is right for a rubber, and wrong where only the data end"));
  }
  return warnings;
}

std::optional<std::string> warning_of_soft_filler(const Material& filler, const Material& binder, double time,
                                                  Abscissa abscissa) {
  if (is_void(filler)) return std::nullopt;
  const auto softer = [&](const char* name, const PronySeries& of_filler,
                          const PronySeries& of_binder) -> std::optional<std::string> {
    const double its_modulus = of_filler.at(time), modulus = of_binder.at(time);
    if (its_modulus >= modulus) return std::nullopt;
    return fmt::format(
        "the filler, {}, is softer than the binder, {}: {} modulus {} against {} at {}; are the units "
        "right?",
        filler.name, binder.name, name, pressure(its_modulus), pressure(modulus), readable_in(abscissa, time));
  };
  if (auto warning = softer("shear", filler.shear, binder.shear)) return warning;
  return softer("bulk", filler.bulk, binder.bulk);
}

std::vector<std::string> warnings_on_materials(const Study& study, const Stage& stage) {
  const auto end = std::ranges::find(study.stages, stage.name, &Stage::name);
  const TimeWindow times{study.tests.first_time, study.tests.last_time};
  std::vector<std::string> warnings;
  for (const auto& material : named_materials(stage)) {
    const bool is_known = end != study.stages.end() && std::any_of(study.stages.begin(), end, [&](const Stage& one) {
                            return has_material(one, material.name);
                          });
    if (is_known) continue;
    if (auto warning = warning_of_poisson_ratio(material, times, study.tests.abscissa()))
      warnings.push_back(*std::move(warning));
  }
  return warnings;
}

std::vector<std::string> warnings_of_soft_fillers(const Study& study, const Stage& stage) {
  std::vector<std::string> warnings;
  for (const auto& filler : stage.fillers) {
    auto warning = warning_of_soft_filler(filler.material, binder_of(study, stage), study.tests.first_time,
                                          study.tests.abscissa());
    if (warning && std::ranges::find(warnings, *warning) == warnings.end()) warnings.push_back(*std::move(warning));
  }
  return warnings;
}

}  // namespace breccia
