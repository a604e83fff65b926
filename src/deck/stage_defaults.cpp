#include "deck/stage_defaults.hpp"

#include <algorithm>

namespace breccia {

StageDefaults read_stage_defaults(const Section& deck) {
  StageDefaults defaults;
  const auto tests = deck.optional_section("tests");
  if (!tests) return defaults;
  if (tests->has("model")) defaults.model = tests->choice<Model>("model").value_or(Model::cells);
  if (!tests->has("boundaries")) return defaults;
  const auto boundaries = tests->list_of_choices<Boundary>("boundaries");
  const auto cuts = [](Boundary boundary) { return boundary != Boundary::periodic; };
  if (std::ranges::any_of(boundaries, cuts)) defaults.walls = Walls::hard;
  return defaults;
}

}  // namespace breccia
