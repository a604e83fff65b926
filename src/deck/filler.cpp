#include "deck/filler.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "deck/crystals.hpp"
#include "deck/filler_sections.hpp"
#include "deck/gap.hpp"
#include "deck/materials.hpp"
#include "deck/packing.hpp"
#include "deck/shapes.hpp"
#include "deck/size_cuts.hpp"
#include "deck/sizes.hpp"
#include "study/limits.hpp"
#include "study/listed_box.hpp"
#include "study/stage_rules.hpp"

namespace breccia {

namespace {

/// Reads fraction and sizes as far as the packing allows them.
struct ReadAmount {
  const Section& section;
  std::optional<double> by_amount;  ///< fraction that follows from the amount of the filler [-]
  Filler& filler;

  template <int dim>
  void operator()(const LaguerrePacking<dim>& grains) const {
    if (grains.is_random() && grains.file.empty()) {
      read_sizes_and_cuts();
    } else {
      section.refuse({"sizes", "from", "to"}, "the sizes of the grains follow from packing.sites");
    }
    if (grains.film) {
      section.refuse({"fraction", "amount"}, "it follows from packing.film");
    } else if (!by_amount && !section.has("fraction")) {
      section.report("fraction", "missing, expected the fraction of the grains, their amount, or packing.film");
    } else {
      read_fraction();
    }
    section.refuse({"coating"}, "grains of a tessellation have films alone");
  }
  template <int dim>
  void operator()(const ExplicitPacking<dim>&) const {
    section.refuse({"sizes", "fraction", "amount", "from", "to"},
                   "the particles of an explicit packing are all listed in its file");
  }
  void operator()(const RegularPacking&) const { read_one_size(); }
  void operator()(const LatticePacking&) const { read_one_size(); }
  template <class Packing>
  void operator()(const Packing&) const {
    read_sizes_and_cuts();
    if (filler.sizes && std::holds_alternative<ListedSizes>(*filler.sizes)) {
      section.refuse({"fraction", "amount"}, "a list of sizes is packed as it is: its fraction follows");
    } else {
      read_fraction();
    }
  }

 private:
  void read_fraction() const {
    if (by_amount) section.refuse({"fraction"}, "it follows from the amount");
    filler.fraction = by_amount ? *by_amount : section.fraction("fraction");
  }
  void read_sizes_and_cuts() const {
    filler.sizes = read_sizes(section);
    read_cuts(section, filler);
  }
  void read_one_size() const {
    read_sizes_and_cuts();
    section.refuse({"fraction", "amount"}, "a regular packing has the fraction that follows from its diameter");
    if (filler.sizes && !std::holds_alternative<SingleSize>(*filler.sizes)) {
      section.report("sizes", "a regular packing takes { diameter = ... }");
    }
  }
};

/// Reads `coating = { material = ..., thickness = ... }`.
std::optional<Coating> read_coating(const Section& section, const std::vector<ShiftedMaterial>& materials) {
  const auto coating = section.optional_section("coating");
  if (!coating) return std::nullopt;
  auto material = read_material_reference(*coating, "material", materials);
  if (is_void(material)) {
    coating->report("material", "a particle in a void carries nothing: expected a filler of void in its place");
  }
  return Coating{std::move(material), coating->quantity("thickness", Dimension::length, Range::positive())};
}

/// Reads the material of a filler, and the orientations of its particles where the material is a crystal.
void read_material(const Section& section, const std::vector<ShiftedMaterial>& materials, std::size_t number,
                   Filler& filler) {
  const auto name = section.kind("material") == Kind::text ? section.optional_text("material") : std::nullopt;
  const auto* const named = find_material(materials, name.value_or(""));
  if (named != nullptr && named->constants) {
    filler.material = named->material;
    filler.crystal = Crystal{*named->constants, read_orientations(section, number)};
    return;
  }
  filler.material = read_material_reference(section, "material", materials);
  section.refuse({"orientations"}, "only crystals have them, whose material has a stiffness");
}

/// Reads the next filler of a stage whose packing has been read.
Filler read_filler(const Section& section, const Stage& stage, const std::vector<ShiftedMaterial>& materials,
                   std::optional<double> by_amount) {
  Filler filler;
  read_material(section, materials, stage.fillers.size(), filler);
  section.refuse({"image"}, image_elsewhere);
  filler.shape = read_shape(section, stage);
  if (!stage.has_grains()) filler.coating = read_coating(section, materials);
  visit_nested(ReadAmount{section, by_amount, filler}, stage.packing);
  read_gap(section, stage, filler);
  return filler;
}

/// Reports mistakes that concern all fillers of a stage together.
void check_together(const Section& section, const Stage& stage) {
  if (stage.fillers.size() > allowed::most_fillers) {
    section.report("filler",
                   fmt::format("expected at most {} fillers, got {}", allowed::most_fillers, stage.fillers.size()));
  }
  const bool is_regular = stage.packing_name() == PackingName::regular;
  if (is_regular && stage.fillers.size() > 1) {
    section.report("filler", fmt::format("expected one filler for a regular packing, got {}", stage.fillers.size()));
  }
  if (stage.has_grains() && stage.fillers.size() > 1) {
    section.report("filler", fmt::format("expected one filler for a tessellation, got {}", stage.fillers.size()));
  }
  for (const auto& mistake : mistakes_of_fractions(stage)) section.report("filler", mistake);
  const auto lacks_name = [](const Filler& filler) { return filler.material.name.empty(); };
  // A material without a name has been reported already.
  if (std::ranges::any_of(stage.fillers, lacks_name)) return;
  for (const auto& mistake : mistakes_of_phases(stage)) section.report("filler", mistake);
}

/// Throws InputError where listed particles, with their coatings, overlap or cross a wall.
struct RequireRoom {
  const Stage& stage;

  template <int dim>
  void operator()(const ExplicitPacking<dim>& listed) const {
    if (listed.count() == 0) return;  // an empty list has been reported already
    try {
      require_room<dim>(stage, listed_box(stage, listed));
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", listed.file.string(), error.what()));
    }
  }
  template <class Packing>
  void operator()(const Packing&) const {}
};

}  // namespace

void read_fillers(const Section& section, const std::vector<ShiftedMaterial>& materials, Walls walls,
                  const FractionsByAmounts& fractions, Stage& stage) {
  const auto tables = filler_sections(section);
  if (tables.empty()) {
    if (section.kind("filler") == Kind::array) section.report("filler", "expected at least one table");
    section.refuse({"packing"}, "there is no filler to pack; method = \"image\" alone needs none");
    return;
  }
  auto packing = read_packing(section, stage, tables.size(), walls);
  if (!packing) {
    for (const auto& table : tables) {
      static_cast<void>(read_material_reference(table, "material", materials));
      table.accept_all_keys();
    }
    return;
  }
  stage.packing = *std::move(packing);
  for (std::size_t number = 0; number < tables.size(); ++number) {
    stage.fillers.push_back(read_filler(tables[number], stage, materials, fractions[number]));
  }
  check_together(section, stage);
  if (!stage.is_listed() || !(stage.side > 0.0)) return;
  const auto table = section.section("packing");
  const auto* const key = table.has("particles") ? "particles" : table.has("discs") ? "discs" : "polygons";
  table.report_errors_of(key, [&] { visit_nested(RequireRoom{stage}, stage.packing); });
}

void check_fit(const Section& section, const Stage& stage) {
  if (!(stage.side > 0.0) || stage.has_image()) return;
  const auto tables = filler_sections(section);
  for (std::size_t number = 0; number < std::min(tables.size(), stage.fillers.size()); ++number) {
    const auto& filler = stage.fillers[number];
    for (const auto& mistake : mistakes_of_gap(filler, stage.side)) tables[number].report("gap", mistake);
    for (const auto& mistake : mistakes_of_diameters(filler, stage.packing, stage.side)) {
      tables[number].report("sizes", mistake);
    }
  }
}

}  // namespace breccia
