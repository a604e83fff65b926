#include "deck/filler_sections.hpp"

namespace breccia {

std::vector<Section> filler_sections(const Section& stage) {
  if (stage.kind("filler") == Kind::array) return stage.sections("filler");
  const auto single = stage.optional_section("filler");
  return single ? std::vector{*single} : std::vector<Section>();
}

}  // namespace breccia
