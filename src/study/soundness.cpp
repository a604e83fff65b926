#include "breccia/study/soundness.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>

#include <fmt/format.h>

#include "io/printable.hpp"
#include "study/filler_soundness.hpp"
#include "study/limits.hpp"
#include "study/material_soundness.hpp"
#include "study/stage_rules.hpp"
#include "study/study_mistakes.hpp"
#include "study/test_rules.hpp"
#include "study/tests_soundness.hpp"

namespace breccia {
namespace {

void check_grids(const Stage& stage, const std::string& part, StudyMistakes& mistakes) {
  for (const int cells : stage.grids()) mistakes.check_integer(part, "cells per side", cells, allowed::cells);
  if (stage.coarser_cells.empty() || can_be_extrapolated(stage.grids())) return;
  mistakes.add(
      part, fmt::format("expected at most {} grids, the cells per side rising from grid to grid", allowed::most_grids));
}

void check_matrix(const Stage& stage, std::span<const Stage> earlier, const std::string& part,
                  StudyMistakes& mistakes) {
  if (const auto* material = std::get_if<Material>(&stage.matrix)) {
    check_material(*material, part + ", matrix", mistakes);
    return;
  }
  const auto& name = std::get<EarlierStage>(stage.matrix).name;
  if (std::ranges::find(earlier, name, &Stage::name) == earlier.end()) {
    mistakes.add(part, fmt::format("no earlier stage \"{}\" for its matrix", name));
  }
}

void check_bonds(const Stage& stage, const std::string& part, StudyMistakes& mistakes) {
  const auto& bonds = *stage.bonds;
  if (bonds.kind == Debonding::spring) {
    const auto check = [&](std::string_view what, double value) {
      mistakes.check_quantity(part, what, value, allowed::interface_stiffness, Dimension::interface_stiffness);
    };
    check("normal stiffness of the bonds", bonds.springs.normal);
    check("tangential stiffness of the bonds", bonds.springs.tangential);
  }
  if (!bonds.films.empty()) return;
  mistakes.check_number(part, "share of films that are debonded", bonds.debonded, allowed::debonded);
  mistakes.add_all(part + ", normal of films", mistakes_of_normal(bonds.normal, stage.dimensions()));
}

void check_stage(const Study& study, std::size_t number, StudyMistakes& mistakes) {
  const auto& stage = study.stages[number];
  const auto earlier = std::span(study.stages).first(number);
  const auto part = stage.name.empty() ? fmt::format("stage {}", number + 1) : stage.name;
  if (stage.name.empty()) mistakes.add(part, "expected a name");
  mistakes.add_all(part, mistakes_of_name(stage.name, earlier, study.materials));
  mistakes.check_quantity(part, "side of the box", stage.side, allowed::side, Dimension::length);
  if (stage.dimensions() != study.stages.front().dimensions()) {
    mistakes.add(part, "expected as many dimensions as those of the first stage");
  }
  check_grids(stage, part, mistakes);
  check_matrix(stage, earlier, part, mistakes);
  check_fillers(stage, part, mistakes);
  if (stage.bonds) check_bonds(stage, part, mistakes);
}

}  // namespace

void require_sound(const Study& study) {
  StudyMistakes mistakes;
  if (!is_printable(study.title)) mistakes.add("title", "expected a text without control characters");
  check_materials(study, mistakes);
  if (study.stages.empty()) mistakes.add("study", "expected at least one stage");
  for (std::size_t number = 0; number < study.stages.size(); ++number) check_stage(study, number, mistakes);
  check_tests(study.tests, mistakes);
  check_varied_materials(study, mistakes);
  mistakes.add_all("tests", contradictions(study));
  check_measurements(study, mistakes);
  mistakes.refuse();
}

}  // namespace breccia
