#include "deck/stage_defaults.hpp"

#include <algorithm>
#include <optional>

namespace breccia {
namespace {

/// The table of a stage's packing.
std::optional<Section> packing_of(const Section& stage) {
  return stage.kind("packing") == Kind::table ? stage.optional_section("packing") : std::nullopt;
}

/// Whether a stage asks for walls. Its particles and those of all other stages are then tested under the same
/// boundaries.
bool asks_for_walls(const Section& stage) {
  const auto packing = packing_of(stage);
  return packing && packing->kind("walls") == Kind::boolean && packing->optional_boolean("walls").value_or(false);
}

/// Whether a stage asks for a window in a larger body, packing.walls = "cut".
bool asks_for_window(const Section& stage) {
  const auto packing = packing_of(stage);
  return packing && packing->kind("walls") == Kind::text && packing->text("walls") == "cut";
}

bool cuts_particles(Boundary boundary) {
  return boundary != Boundary::periodic;
}

}  // namespace

StageDefaults read_stage_defaults(const Section& deck) {
  StageDefaults defaults;
  const auto tests = deck.optional_section("tests");
  const auto stages = deck.sections("stages");
  if (std::ranges::any_of(stages, asks_for_window)) {
    defaults.boundaries = {Boundary::displacement, Boundary::traction};
  }
  if (tests && tests->has("model")) defaults.model = tests->choice<Model>("model").value_or(Model::cells);
  if (tests && tests->has("boundaries")) {
    const auto boundaries = tests->list_of_choices<Boundary>("boundaries");
    const bool cut = !boundaries.empty() && std::ranges::all_of(boundaries, cuts_particles);
    if (cut) defaults.walls = Walls::hard;
  } else if (std::ranges::any_of(stages, asks_for_walls)) {
    defaults.walls = Walls::hard;
  }
  return defaults;
}

}  // namespace breccia
