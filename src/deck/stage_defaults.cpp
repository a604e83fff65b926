#include "deck/stage_defaults.hpp"

#include <algorithm>
#include <optional>

namespace breccia {

namespace {

/// Whether a stage asks for walls. Its particles and those of all other stages are then tested under the same
/// boundaries.
bool asks_for_walls(const Section& stage) {
  const auto packing = stage.kind("packing") == Kind::table ? stage.optional_section("packing") : std::nullopt;
  return packing && packing->kind("walls") == Kind::boolean && packing->optional_boolean("walls").value_or(false);
}

bool cuts_particles(Boundary boundary) {
  return boundary != Boundary::periodic;
}

}  // namespace

StageDefaults read_stage_defaults(const Section& deck) {
  StageDefaults defaults;
  const auto tests = deck.optional_section("tests");
  if (tests && tests->has("model")) defaults.model = tests->choice<Model>("model").value_or(Model::cells);
  if (tests && tests->has("boundaries")) {
    const bool cuts = std::ranges::any_of(tests->list_of_choices<Boundary>("boundaries"), cuts_particles);
    if (cuts) defaults.walls = Walls::hard;
  } else if (std::ranges::any_of(deck.sections("stages"), asks_for_walls)) {
    defaults.walls = Walls::hard;
  }
  return defaults;
}

}  // namespace breccia
