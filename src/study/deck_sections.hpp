#pragma once

#include <map>
#include <string>
#include <vector>

#include "breccia/io/deck.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// What a deck means, but for its sweep and without the overrides and the hash. Mistakes are left to the deck.
Study resolve(const Deck& document);

/// Hash of a deck without mistakes: of what it says, its overrides and its data files, but not of its sweep, so that a
/// task remains the same when its sweep grows.
std::string hash_of(const Deck& document);

/// Hashes of its stages (Study::stage_hashes).
std::vector<std::string> stage_hashes_of(const Deck& document, const Study& study);

/// The materials of a deck, and by name the temperature shifts that are in them.
struct DeckMaterials {
  std::vector<Material> materials;
  std::map<std::string, TemperatureShift> temperature_shifts;
};

/// [materials]: each table is a material, named by its key.
DeckMaterials read_materials(const Section& deck);

/// [[stages]], whose materials are among those given.
std::vector<Stage> read_stages(const Section& deck, const std::vector<Material>& materials);

/// What is said of a key that asks for anything but discs.
inline constexpr auto discs_alone =
    "all particles are discs so far: other shapes and images are not available (docs/limitations.md)";

/// `filler` and `packing` of a stage whose box and cells are known; nothing when it has neither.
std::optional<Filler> read_filler(const Section& stage_section, const Stage& stage,
                                  const std::vector<Material>& materials);

/// `gap` of a filler whose sizes and packing are known, in a stage whose box and cells are known.
void read_gap(const Section& section, const Stage& stage, Filler& filler);

/// `sizes` of a filler.
std::optional<Sizes> read_sizes(const Section& filler);

/// `packing` of a stage with a box of the given side [m].
std::optional<PackingMethod> read_packing(const Section& stage, double side);

/// Does a packing draw its particles at random, so that it has a `seed`?
bool takes_seed(const Section& packing);

/// The material that a key names; a nameless one after a report.
Material read_material_reference(const Section& section, const std::string& key,
                                 const std::vector<Material>& materials);

/// [tests] of these stages.
Tests read_tests(const Section& deck, const std::vector<Stage>& stages);

/// Two rising times [s] where a section has such a key.
std::optional<TimeWindow> read_time_window(const Section& section, const std::string& key);

/// [[measurements]] of the stages given.
std::vector<Measurement> read_measurements(const Section& deck, const std::vector<Stage>& stages, const Tests& tests);

/// Reports what each part of a study allows and the whole does not.
void refuse_contradictions(const Section& deck, const Study& study);

}  // namespace breccia
