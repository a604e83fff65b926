#include "deck/amounts.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "deck/filler_sections.hpp"
#include "deck/image.hpp"
#include "study/limits.hpp"

namespace breccia {
namespace {

constexpr double unknown_amount = std::numeric_limits<double>::quiet_NaN();

/// A filler of a composite.
struct FillerAmount {
  std::size_t stage = 0;
  std::size_t filler = 0;
  Section section;
  bool is_void = false;
  double density = unknown_amount;  ///< [kg/m^3]
  std::string kind = {};            ///< "mass" or "volume"; empty without an amount, or after a mistake
  double amount = unknown_amount;   ///< share of that of the whole [-]
};

/// The stages of one composite and their fillers, both in the order of the deck.
struct Composite {
  std::vector<std::size_t> stages = {};
  std::vector<FillerAmount> shares = {};
  double binder_density = unknown_amount;  ///< [kg/m^3]
};

/// The text of a key, empty where it has none. Leaves mistakes to those who need the key.
std::string text_of(const Section& section, const std::string& key) {
  return section.kind(key) == Kind::text ? section.optional_text(key).value_or("") : "";
}

double density_of(const std::vector<ShiftedMaterial>& materials, const std::string& name) {
  const auto* const found = find_material(materials, name);
  return found == nullptr ? unknown_amount : found->material.density;
}

/// Reads `amount` of a filler, if it has one.
void read_amount(FillerAmount& share) {
  if (!share.section.has("amount")) return;
  if (share.section.kind("amount") != Kind::table) {
    share.section.report("amount",
                         "expected { mass = \"65 %\" } or { volume = \"65 %\" }, a share of the mass or of the volume "
                         "of the whole composite");
    return;
  }
  const auto amount = share.section.section("amount");
  share.kind = amount.exactly_one({"mass", "volume"});
  if (!share.kind.empty()) share.amount = amount.fraction(share.kind);
  if (share.is_void && share.kind == "mass")
    share.section.report("amount", "a void has no mass: expected { volume = ... }");
}

/// The earlier stage that is the matrix of each stage; nothing where that is a material.
std::vector<std::optional<std::size_t>> matrices_of(std::span<const Section> stages,
                                                    const std::vector<ShiftedMaterial>& materials) {
  std::vector<std::string> names;
  std::vector<std::optional<std::size_t>> matrices;
  names.reserve(stages.size());
  matrices.reserve(stages.size());
  for (const auto& stage : stages) {
    const auto matrix = text_of(stage, "matrix");
    const auto found = std::ranges::find(names, matrix);
    const bool is_stage = !matrix.empty() && find_material(materials, matrix) == nullptr && found != names.end();
    matrices.push_back(is_stage ? std::optional<std::size_t>(found - names.begin()) : std::nullopt);
    names.push_back(text_of(stage, "name"));
  }
  return matrices;
}

/// The composites of a deck: stages that build on one another, directly or not, are in one of them.
std::vector<Composite> composites_of(std::span<const Section> stages, const std::vector<ShiftedMaterial>& materials,
                                     const std::vector<std::optional<std::size_t>>& matrices) {
  std::vector<Composite> composites;
  std::vector<std::size_t> composite_of;
  composite_of.reserve(stages.size());
  for (std::size_t stage = 0; stage < stages.size(); ++stage) {
    composite_of.push_back(matrices[stage] ? composite_of[*matrices[stage]] : composites.size());
    if (!matrices[stage]) {
      composites.push_back({.binder_density = density_of(materials, text_of(stages[stage], "matrix"))});
    }
    auto& composite = composites[composite_of.back()];
    composite.stages.push_back(stage);
    for (const auto& section : filler_sections(stages[stage])) {
      const auto number = static_cast<std::size_t>(std::ranges::count(composite.shares, stage, &FillerAmount::stage));
      const auto material = text_of(section, "material");
      composite.shares.push_back({.stage = stage,
                                  .filler = number,
                                  .section = section,
                                  .is_void = material == name_of_void,
                                  .density = density_of(materials, material)});
    }
  }
  return composites;
}

/// Reports amounts of a composite that has no unambiguous whole, or fillers without an amount.
void check_whole(std::span<const Section> stages, const std::vector<std::optional<std::size_t>>& matrices,
                 const Composite& composite) {
  for (const auto stage : composite.stages) {
    const auto builds_on = [&](std::size_t other) { return matrices[other] == stage; };
    if (std::ranges::count_if(composite.stages, builds_on) > 1) {
      stages[stage].report("",
                           "expected the matrix of one stage at most, or fillers with fraction in place of amount: "
                           "of several composites it is not known which is the whole");
    }
    if (has_image(stages[stage])) {
      stages[stage].report("packing",
                           "an image has its fractions: expected fraction in place of amount in the other "
                           "stages of the composite");
    }
  }
  for (const auto& share : composite.shares) {
    if (!share.section.has("amount")) {
      share.section.report("amount",
                           "missing: other fillers of the composite have an amount, and the binder takes what all of "
                           "them leave; expected amount for all of them, or for none where the particles of a stage "
                           "are listed, regular or given by packing.film");
    }
    share.section.refuse({"coating"},
                         "the mass and the volume of a coating are not known before its particles are packed: "
                         "expected fraction in place of amount in all stages of the composite");
  }
}

/// Reports amounts by mass beside amounts by volume. Returns the kind of all solid fillers; that of voids is always by
/// volume.
std::string common_kind(const std::vector<FillerAmount>& shares) {
  std::string kind;
  for (const auto& share : shares) {
    if (share.is_void || share.kind.empty()) continue;
    if (kind.empty()) kind = share.kind;
    if (share.kind == kind) continue;
    share.section.report("amount",
                         fmt::format("expected {{ {} = ... }}, as of the fillers before it: amounts are all by "
                                     "mass, but for voids, or all by volume",
                                     kind));
  }
  return kind;
}

double sum_of(const std::vector<FillerAmount>& shares, const std::string& kind) {
  double sum = 0.0;
  for (const auto& share : shares) sum += share.kind == kind ? share.amount : 0.0;
  return sum;
}

/// Reports amounts that leave nothing for the binder.
void check_sum(const std::vector<FillerAmount>& shares, const std::string& kind) {
  const double sum = sum_of(shares, kind);
  if (!(sum >= 1.0)) return;
  const auto last = std::ranges::find(shares.rbegin(), shares.rend(), kind, &FillerAmount::kind);
  last->section.report("amount", fmt::format("the amounts by {} add up to {:.6g} %: expected less than 100 %, "
                                             "since the binder takes the rest",
                                             kind, 100.0 * sum));
}

/// The volumes of all fillers of a composite as shares of the whole [-].
std::vector<double> volumes_of(const Composite& composite, const std::string& kind) {
  const double voids = sum_of(composite.shares, "volume");
  double solid = (1.0 - sum_of(composite.shares, "mass")) / composite.binder_density;  // volume per mass [m^3/kg]
  for (const auto& share : composite.shares) {
    if (!share.is_void) solid += share.amount / share.density;
  }
  std::vector<double> volumes;
  volumes.reserve(composite.shares.size());
  for (const auto& share : composite.shares) {
    const bool is_by_volume = share.is_void || kind == "volume";
    volumes.push_back(is_by_volume ? share.amount : (1.0 - voids) * share.amount / (share.density * solid));
  }
  return volumes;
}

/// Computes the fractions of the fillers of a composite with amounts. The box of a stage has the volume of the binder
/// and of all fillers up to and including its own.
void add_fractions(const Composite& composite, std::vector<FractionsByAmounts>& fractions) {
  const auto volumes = volumes_of(composite, common_kind(composite.shares));
  for (const auto kind : {"mass", "volume"}) check_sum(composite.shares, kind);
  for (std::size_t i = 0; i < volumes.size(); ++i) {
    const auto& share = composite.shares[i];
    if (!share.section.has("amount")) continue;
    double later = 0.0;
    for (std::size_t j = i; j < volumes.size(); ++j) {
      if (composite.shares[j].stage > share.stage) later += volumes[j];
    }
    const double fraction = volumes[i] / (1.0 - later);
    // Others follow from mistakes in the amounts alone.
    fractions[share.stage][share.filler] = accepts(allowed::fraction, fraction) ? fraction : unknown_amount;
  }
}

}  // namespace

std::vector<FractionsByAmounts> read_amounts(std::span<const Section> stages,
                                             const std::vector<ShiftedMaterial>& materials) {
  std::vector<FractionsByAmounts> fractions(stages.size());
  const auto matrices = matrices_of(stages, materials);
  for (auto& composite : composites_of(stages, materials, matrices)) {
    for (const auto& share : composite.shares) fractions[share.stage].emplace_back();
    const auto has_amount = [](const FillerAmount& share) { return share.section.has("amount"); };
    if (std::ranges::none_of(composite.shares, has_amount)) continue;
    std::ranges::for_each(composite.shares, read_amount);
    check_whole(stages, matrices, composite);
    add_fractions(composite, fractions);
  }
  return fractions;
}

std::string fractions_by_amounts(const Section& deck, const Study& study, std::size_t stages) {
  std::string text;
  const auto sections = deck.sections("stages");
  for (std::size_t number = 0; number < std::min(sections.size(), stages); ++number) {
    const auto fillers = filler_sections(sections[number]);
    for (std::size_t filler = 0; filler < fillers.size(); ++filler) {
      if (!fillers[filler].has("amount")) continue;
      text += fmt::format(" {:.17g}", study.stages[number].fillers[filler].fraction.value_or(0.0));
    }
  }
  return text;
}

}  // namespace breccia
