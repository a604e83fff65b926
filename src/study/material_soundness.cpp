#include "study/material_soundness.hpp"

#include <algorithm>
#include <variant>

#include <fmt/format.h>

#include "io/printable.hpp"
#include "io/units.hpp"
#include "study/limits.hpp"
#include "viscoelasticity/poisson_ratio.hpp"

namespace breccia {
namespace {

void check_shift(const TemperatureShift& shift, const std::string& part, StudyMistakes& mistakes) {
  if (const auto* law = std::get_if<WilliamsLandelFerry>(&shift.law)) {
    mistakes.check_number(part, "c1", law->c1, Range::positive());
    mistakes.check_quantity(part, "c2", law->c2, Range::positive(), Dimension::temperature_difference);
    mistakes.check_quantity(part, "reference temperature", law->reference_temperature, Range::not_negative(),
                            Dimension::temperature);
  }
  mistakes.check_quantity(part, "temperature", shift.temperature, Range::not_negative(), Dimension::temperature);
  mistakes.add_error_of(part, [&shift] { static_cast<void>(shift_factor(shift.law, shift.temperature)); });
}

/// A material whose unrelaxed moduli are positive has a Poisson's ratio above the least one.
void check_poisson_ratio(const Material& material, const std::string& part, StudyMistakes& mistakes) {
  const double bulk = material.bulk.unrelaxed(), shear = material.shear.unrelaxed();
  if (!(bulk > 0.0) || !(shear > 0.0) || poisson_ratio(bulk, shear) > allowed::poisson.lower) return;
  mistakes.add(part, fmt::format("expected a Poisson's ratio above {}, got {:.4g} (bulk {}, shear {}); are the units "
                                 "right?",
                                 allowed::poisson.lower, poisson_ratio(bulk, shear),
                                 readable(bulk, Dimension::pressure), readable(shear, Dimension::pressure)));
}

}  // namespace

void check_material(const Material& material, const std::string& part, StudyMistakes& mistakes) {
  if (material.name == name_of_void) {
    mistakes.add(part, "expected a solid: only fillers are voids");
    return;
  }
  if (!is_printable(material.name)) mistakes.check_name(part, material.name);
  mistakes.check_quantity(part, "density", material.density, Range::positive(), Dimension::density);
  mistakes.check_quantity(part, "unrelaxed bulk modulus", material.bulk.unrelaxed(), Range::positive(),
                          Dimension::pressure);
  mistakes.check_quantity(part, "unrelaxed shear modulus", material.shear.unrelaxed(), Range::positive(),
                          Dimension::pressure);
  check_poisson_ratio(material, part, mistakes);
}

void check_materials(const Study& study, StudyMistakes& mistakes) {
  for (const auto& one : study.materials) {
    const auto& [material, shift, constants, expansion] = one;
    const auto part = "material " + material.name;
    check_material(material, part, mistakes);
    if (find_material(study.materials, material.name) != &one) mistakes.add(part, "another material has this name");
    if (shift) check_shift(*shift, "temperature shift of " + material.name, mistakes);
    if (expansion) {
      mistakes.check_quantity(part, "thermal expansion", *expansion, allowed::thermal_expansion, Dimension::expansion);
    }
  }
}

}  // namespace breccia
