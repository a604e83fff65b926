#include "results/composite.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "io/nearest_name.hpp"
#include "results/best_tests.hpp"
#include "virtual_test/bulk_test.hpp"

namespace breccia {
namespace {

/// Adds a value to a list that has each value once.
template <class Value>
void add_once(std::vector<Value>& list, const Value& value) {
  if (std::ranges::find(list, value) == list.end()) list.push_back(value);
}

template <class Enum>
std::vector<std::string> words_of(const std::vector<Enum>& values) {
  std::vector<std::string> words(values.size());
  std::ranges::transform(values, words.begin(), [](Enum value) { return name_of(value); });
  return words;
}

/// Resolves the choice among the series of one study and collects its mistakes.
class Chooser {
 public:
  Chooser(std::string place, const std::vector<StageSeries>& series, CompositeChoice choice)
      : place_(std::move(place)), series_(series), choice_(std::move(choice)) {}

  /// The complete choice, with defaults for what was not chosen.
  CompositeChoice resolved() {
    choose_stage();
    if (!mistakes_.empty()) refuse();
    choose_boundary();
    choose_load();
    refuse();
    return choice_;
  }

 private:
  void choose_stage() {
    std::vector<std::string> stages;
    for (const auto& one : series_) add_once(stages, one.stage);
    if (stages.empty()) {
      mistakes_.push_back(fmt::format("{}: no series of moduli; no test is finished", place_));
    } else if (choice_.stage.empty()) {
      choice_.stage = stages.back();
    } else if (std::ranges::find(stages, choice_.stage) == stages.end()) {
      mistakes_.push_back(
          fmt::format("{}: no results of a stage \"{}\"{}", place_, choice_.stage, suggestion(choice_.stage, stages)));
    }
  }

  void choose_boundary() {
    std::vector<Boundary> boundaries;
    for (const auto& one : series_) {
      if (one.stage == choice_.stage) add_once(boundaries, one.boundary);
    }
    choose(boundaries, choice_.boundary, "boundary condition");
  }

  void choose_load() {
    std::vector<TestLoad> loads;
    for (const auto& one : series_) {
      const bool is_here = one.stage == choice_.stage && (!choice_.boundary || one.boundary == *choice_.boundary);
      if (is_here && !one.load.is_bulk()) add_once(loads, one.load);
    }
    if (choice_.shear_load == Load::bulk) {
      mistakes_.emplace_back(
          "load: expected a load of shear, got bulk; the bulk modulus is taken from its test anyway");
      return;
    }
    if (loads.empty()) {
      if (!mistakes_.empty()) return;  // a mistake in the boundary condition
      mistakes_.push_back(fmt::format("{}: stage {} was not tested in shear", place_, choice_.stage));
      return;
    }
    const auto main = main_shear(loads);
    if (!choice_.shear_load && (main == TestLoad::isotropic() || main == TestLoad(Load::shear)))
      choice_.shear_load = main;
    choose(loads, choice_.shear_load, "shear load");
  }

  template <class Enum>
  void choose(const std::vector<Enum>& known, std::optional<Enum>& chosen, const char* what) {
    const auto names = words_of(known);
    if (chosen && std::ranges::find(known, *chosen) == known.end()) {
      mistakes_.push_back(fmt::format("{}: stage {} was not tested under the {} {}; it has {}", place_, choice_.stage,
                                      what, name_of(*chosen), fmt::join(names, ", ")));
    } else if (!chosen && known.size() == 1) {
      chosen = known.front();
    } else if (!chosen) {
      mistakes_.push_back(fmt::format("{}: stage {} has results of several {}s; choose one: {}", place_, choice_.stage,
                                      what, fmt::join(names, ", ")));
    }
  }

  void refuse() const {
    if (!mistakes_.empty()) throw InputError(fmt::format("{}", fmt::join(mistakes_, "\n")));
  }

  std::string place_;
  const std::vector<StageSeries>& series_;
  CompositeChoice choice_;
  std::vector<std::string> mistakes_;
};

const ShiftedMaterial& material_of(const StudyContent& content, const std::string& name, const std::string& place) {
  if (const auto* const found = find_material(content.materials, name)) return *found;
  throw FileError(fmt::format("{}: no material \"{}\"", place, name));
}

const StageContent* find_stage(const StudyContent& content, const std::string& name) {
  const auto found = std::ranges::find(content.stages, name, &StageContent::name);
  return found == content.stages.end() ? nullptr : &*found;
}

/// The name of the binder at the end of a chain of matrices.
std::string binder_of_chain(const StudyContent& content, std::string name) {
  for (std::size_t links = 0; links <= content.stages.size(); ++links) {
    const auto* const stage = find_stage(content, name);
    if (stage == nullptr) return name;
    name = stage->matrix;
  }
  return name;
}

/// Adds the density and the temperature shift of the composite.
void add_materials(const StudyContent& content, const StageContent& stage, const std::string& place,
                   Composite& composite) {
  const auto& binder = material_of(content, binder_of_chain(content, stage.name), place);
  double rest = 1.0;
  bool relaxes_by_binder_alone = true;
  for (const auto& share : stage.shares) {
    rest -= share.fraction;
    if (share.material == name_of_void) continue;
    const auto& material = material_of(content, share.material, place).material;
    composite.density += share.fraction * material.density;
    relaxes_by_binder_alone = relaxes_by_binder_alone && is_elastic(material);
  }
  composite.density += rest * binder.material.density;
  if (relaxes_by_binder_alone) composite.shift = binder.shift;
}

}  // namespace

std::optional<PronySeries> Composite::bulk() const {
  if (!dilatational) return std::nullopt;
  return bulk_modulus_of(*dilatational, shear, dimensions);
}

std::string boundary_in_words(Boundary boundary) {
  if (boundary == Boundary::periodic) return "periodic boundary";
  return fmt::format("{} boundary ({})", name_of(boundary), boundary == Boundary::displacement ? "KUBC" : "SUBC");
}

StudyContent study_content(const Study& study, const StudyResult& result) {
  StudyContent content{.title = study.title,
                       .times = {study.tests.first_time, study.tests.last_time},
                       .by_frequency = study.tests.by_frequency,
                       .materials = study.materials};
  std::vector<std::vector<FillerStatistics>> packed;
  for (std::size_t i = 0; i < result.stages.size(); ++i) {
    const auto& stage = study.stages[i];
    packed.push_back(result.stages[i].microstructure.fillers);
    auto [fraction, mass_fraction, porosity, materials, coatings] = filler_of_the_whole(study, stage, packed);
    materials.insert(materials.end(), coatings.begin(), coatings.end());
    if (porosity > 0.0) materials.push_back({name_of_void, porosity});
    content.stages.push_back({stage.name, name_of(stage.matrix), stage.dimensions(), std::move(materials)});
  }
  return content;
}

std::vector<StageSeries> series_of(const StageFindings& stage) {
  std::vector<StageSeries> all;
  for (const auto* const test : best_tests(stage)) {
    all.push_back({stage.name, test->id.load, test->id.boundary, test->series, largest_whole(test->errors)});
  }
  return all;
}

Composite composite_of(const StudyContent& content, const std::vector<StageSeries>& series,
                       const CompositeChoice& choice, const std::string& place) {
  const auto chosen = Chooser(place, series, choice).resolved();
  const auto find = [&](TestLoad load) {
    const auto found = std::ranges::find_if(series, [&](const StageSeries& one) {
      return one.stage == chosen.stage && one.boundary == *chosen.boundary && one.load == load;
    });
    return found == series.end() ? std::nullopt : std::optional(*found);
  };
  const auto* const stage = find_stage(content, chosen.stage);
  if (stage == nullptr) throw FileError(fmt::format("{}: no stage {}", place, chosen.stage));
  Composite composite;
  composite.title = content.title;
  composite.stage = chosen.stage;
  composite.boundary = *chosen.boundary;
  composite.shear_load = *chosen.shear_load;
  composite.dimensions = stage->dimensions;
  const auto shear = find(*chosen.shear_load).value();
  composite.shear = shear.series;
  composite.shear_error = shear.error;
  if (const auto bulk = find(Load::bulk)) composite.dilatational = bulk->series;
  composite.times = content.times;
  add_materials(content, *stage, place, composite);
  return composite;
}

}  // namespace breccia
