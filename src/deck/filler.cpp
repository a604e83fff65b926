#include "filler.hpp"

#include <fmt/format.h>

#include "breccia/study/filler_sizes.hpp"
#include "breccia/study/stage_rules.hpp"

#include "gap.hpp"
#include "materials.hpp"
#include "packing.hpp"
#include "sizes.hpp"

namespace breccia {

namespace {

constexpr auto several_fillers =
    "expected one table: several fillers in a box are not available yet; a second one, far smaller or larger than the "
    "first, goes into a stage of its own (docs/decks.md, Stages)";

bool is_distribution(const Sizes& sizes) {
  return std::holds_alternative<LognormalSizes>(sizes) || std::holds_alternative<TabulatedSizes>(sizes);
}

/// Reads `from` and `to`, which cut a distribution of sizes. They are optional for a table, and required for a
/// lognormal distribution.
void read_cuts(const Section& section, Filler& filler) {
  if (!filler.sizes) {
    // The missing sizes have been reported already.
    for (const auto* key : {"from", "to"}) {
      if (section.has(key)) static_cast<void>(section.quantity(key, Dimension::length, Range::positive()));
    }
    return;
  }
  if (!is_distribution(*filler.sizes)) {
    section.refuse({"from", "to"}, "only a distribution of sizes (a file or lognormal) is cut");
    return;
  }
  bool misses = false;
  if (const auto* table = std::get_if<TabulatedSizes>(&*filler.sizes)) {
    filler.smallest = table->diameters.front();
    filler.largest = table->diameters.back();
    if (section.has("from")) filler.smallest = section.quantity("from", Dimension::length, Range::positive());
    if (section.has("to")) filler.largest = section.quantity("to", Dimension::length, Range::positive());
    misses = *filler.smallest >= table->diameters.back() || *filler.largest <= table->diameters.front();
    if (misses) {
      section.report("sizes", fmt::format("the table has no sizes from {} to {}: it covers {} to {}",
                                          readable(*filler.smallest, Dimension::length),
                                          readable(*filler.largest, Dimension::length),
                                          readable(table->diameters.front(), Dimension::length),
                                          readable(table->diameters.back(), Dimension::length)));
    }
  } else {
    filler.smallest = section.quantity("from", Dimension::length, Range::positive());
    filler.largest = section.quantity("to", Dimension::length, Range::positive());
  }
  if (*filler.smallest >= *filler.largest) {
    section.report("from",
                   fmt::format("expected less than {} (to), got {}", readable(*filler.largest, Dimension::length),
                               readable(*filler.smallest, Dimension::length)));
  } else if (*filler.smallest < *filler.largest && !misses) {  // and both are numbers
    section.report_errors_of("sizes", [&] { static_cast<void>(distribution_of(filler)); });
  }
}

/// Reports particles that cannot fit into the box.
void check_fit(const Section& section, const Filler& filler, double side) {
  for (const auto& mistake : mistakes_of_gap(filler, side)) section.report("gap", mistake);
  for (const auto& mistake : mistakes_of_diameters(filler, side)) section.report("sizes", mistake);
}

/// Reads fraction and sizes as far as the packing allows them.
void read_amount(const Section& section, Filler& filler) {
  if (std::holds_alternative<ExplicitPacking>(filler.packing)) {
    section.refuse({"sizes", "fraction", "from", "to"}, "the discs of an explicit packing are all listed in its file");
    return;
  }
  filler.sizes = read_sizes(section);
  read_cuts(section, filler);
  if (std::holds_alternative<RegularPacking>(filler.packing)) {
    section.refuse({"fraction"}, "a regular packing has the fraction that follows from its diameter");
    if (filler.sizes && !std::holds_alternative<SingleSize>(*filler.sizes)) {
      section.report("sizes", "a regular packing takes { diameter = ... }");
    }
  } else if (filler.sizes && std::holds_alternative<ListedSizes>(*filler.sizes)) {
    section.refuse({"fraction"}, "a list of sizes is packed as it is: its fraction follows");
  } else {
    filler.fraction = section.fraction("fraction");
  }
}

}  // namespace

std::optional<Filler> read_filler(const Section& stage_section, const Stage& stage,
                                  const std::vector<Material>& materials) {
  if (stage_section.kind("filler") == Kind::array) {
    stage_section.report("filler", several_fillers);
    static_cast<void>(stage_section.has("packing"));
    return std::nullopt;
  }
  const auto section = stage_section.optional_section("filler");
  if (!section) {
    stage_section.refuse({"packing"}, "there is no filler to pack");
    return std::nullopt;
  }
  Filler filler;
  filler.material = read_material_reference(*section, "material", materials);
  section->refuse({"shape", "image"}, discs_alone);
  const auto packing = read_packing(stage_section, stage.side);
  if (!packing) {
    section->accept_all_keys();
    return std::nullopt;
  }
  filler.packing = *packing;
  read_amount(*section, filler);
  read_gap(*section, stage, filler);
  check_fit(*section, filler, stage.side);
  return filler;
}

}  // namespace breccia
