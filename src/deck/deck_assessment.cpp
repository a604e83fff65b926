#include "breccia/deck/deck_assessment.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "assessment/sampled_curves.hpp"
#include "deck/resolved_study.hpp"
#include "deck/sweep_names.hpp"
#include "deck/uncertain_materials.hpp"
#include "deckfile/deck.hpp"
#include "io/nearest_name.hpp"

namespace breccia {

struct DeckAssessment::State {
  Deck document;
  std::vector<std::string> overrides;
  Study study = {};  ///< with the median of each input
  AssessmentDesign design = {};
  Sweep sweep = {};
  std::vector<std::vector<NewMaterial>> materials = {};  ///< the materials of each sample that differ from the medians
};

namespace {

std::string override_of(const UncertainInput& input, const Scalar& value) {
  return fmt::format("{}={}", input.name, toml_text(value));
}

Setting setting_of(const UncertainInput& input, const Scalar& value) {
  const Location location = {.option = override_of(input, value)};
  return {input.name, location, {value, location}};
}

/// The study of a deck with values for some of its inputs, and the mistakes that these make.
Study study_with(const Deck& document, std::vector<std::string> overrides, const std::vector<UncertainInput>& inputs,
                 const std::vector<bool>& chosen, const Eigen::VectorXd& coordinates, std::vector<Mistake>& mistakes) {
  auto changed = document.unread_copy();
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (!chosen[i]) continue;
    const auto value = value_at(inputs[i], coordinates[static_cast<Eigen::Index>(i)]);
    changed.set(setting_of(inputs[i], value));
    overrides.push_back(override_of(inputs[i], value));
  }
  auto study = resolve(changed);
  const auto own = changed.mistakes();
  mistakes.insert(mistakes.end(), own.begin(), own.end());
  if (own.empty()) add_hashes(changed, overrides, study);
  return study;
}

bool is_in_a_stage(const Study& study, const std::string& material) {
  return std::ranges::any_of(study.stages, [&](const Stage& stage) {
    const auto materials = named_materials(stage);
    return std::ranges::find(materials, material, &Material::name) != materials.end();
  });
}

/// The lines of messages, each once and no more than a few.
class DifferentLines {
 public:
  void add(const std::string& text) {
    if (std::ranges::find(lines_, text) == lines_.end()) lines_.push_back(text);
  }
  void refuse() const {
    constexpr std::size_t most = 10;
    if (lines_.empty()) return;
    const auto shown =
        std::vector(lines_.begin(), lines_.begin() + static_cast<std::ptrdiff_t>(std::min(lines_.size(), most)));
    throw InputError(fmt::format("{}", fmt::join(shown, "\n")));
  }

 private:
  std::vector<std::string> lines_;
};

/// Whether the moduli of an elastic material are in the intervals over which it varies.
bool is_within(const VariedMaterial& varied, const Material& material) {
  constexpr double rounding = 1e-6;
  const auto holds = [](const std::optional<ModulusInterval>& interval, double modulus) {
    return !interval || (modulus >= interval->least * (1.0 - rounding) && modulus <= interval->most * (1.0 + rounding));
  };
  return !varied.others.empty() ||
         (holds(varied.shear, material.shear.equilibrium()) && holds(varied.bulk, material.bulk.equilibrium()));
}

/// The materials of all samples. Throws InputError where one is no sound material, or is beyond what a deck lets vary.
std::vector<std::vector<NewMaterial>> materials_of(const Deck& document, const Study& study,
                                                   const AssessmentDesign& design) {
  std::vector<std::vector<NewMaterial>> materials(static_cast<std::size_t>(design.coordinates.cols()));
  DifferentLines mistakes;
  for (const auto& varied : study.tests.varied) {
    for (std::size_t sample = 0; sample < materials.size(); ++sample) {
      std::vector<Setting> settings;
      for (std::size_t i = 0; i < study.uncertain.size(); ++i) {
        const auto& input = study.uncertain[i];
        if (design.change_the_box[i] || material_of(input) != varied.name) continue;
        const double coordinate = design.coordinates(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(sample));
        settings.push_back(setting_of(input, value_at(input, coordinate)));
      }
      if (settings.empty()) continue;
      try {
        const auto material = material_with(document, varied.name, settings);
        materials[sample].push_back(new_material(varied.name, material));
        if (is_within(varied, material.material)) continue;
        mistakes.add(
            fmt::format("{}: tests.quasistatic.vary does not hold for all of the distribution of {}; without it "
                        "the responses hold for all of it",
                        document.path().string(), varied.name));
      } catch (const InputError& error) {
        mistakes.add(error.what());
      }
    }
  }
  mistakes.refuse();
  return materials;
}

/// Throws InputError where the studies of the boxes differ in what varies, or in their curves.
void require_alike(const Deck& document, const Sweep& sweep) {
  const auto& first = sweep.tasks.front().study.tests;
  DifferentLines mistakes;
  for (const auto& task : sweep.tasks) {
    const auto& tests = task.study.tests;
    for (const auto& varied : first.varied) {
      if (std::ranges::find(tests.varied, varied.name, &VariedMaterial::name) != tests.varied.end()) continue;
      mistakes.add(
          fmt::format("{}: {} varies with the median of each input, and not with the others: expected a "
                      "material and a mixing that are certain",
                      document.path().string(), varied.name));
    }
    const bool has_same_curves = tests.loads == first.loads && tests.whole_stiffness == first.whole_stiffness &&
                                 tests.boundaries == first.boundaries && tests.first_time == first.first_time &&
                                 tests.last_time == first.last_time &&
                                 tests.points_per_decade == first.points_per_decade &&
                                 tests.by_frequency == first.by_frequency;
    if (has_same_curves) continue;
    mistakes.add(fmt::format("{}: expected loads, boundaries and times that are certain", document.path().string()));
  }
  mistakes.refuse();
}

/// Refuses decks that cannot be assessed.
void require_assessable(const Deck& document, const Study& study) {
  std::vector<std::string> lines;
  if (study.uncertain.empty()) {
    lines.emplace_back(
        R"(every input is certain; expected a distribution, as in shear = { value = "5.8 GPa", sd = "0.6 GPa" }, )"
        "or a range, as in fraction = { from = 0.4, to = 0.6 }");
  }
  if (document.unread_copy().root().has("sweep")) {
    lines.emplace_back("sweep: expected none; an input with several values is written { any = [1, 2, 3] }");
  }
  for (const auto& input : study.uncertain) {
    const auto material = material_of(input);
    if (!material || is_in_a_stage(study, *material)) continue;
    lines.push_back(fmt::format("{}: no stage has this material", input.name));
  }
  if (!main_shear(study.tests.loads)) lines.emplace_back("tests.loads: expected a shear, whose modulus is assessed");
  const auto& methods = study.tests.methods;
  if (std::ranges::find(methods, Method::quasistatic) == methods.end() ||
      study.tests.quasistatic.solver != Solver::reduced) {
    lines.emplace_back(
        R"(tests: an assessment takes the reduced responses of method = "quasistatic" with solver = "reduced")");
  }
  if (lines.empty()) return;
  for (auto& line : lines) line = fmt::format("{}: {}", document.path().string(), line);
  throw InputError(fmt::format("{}", fmt::join(lines, "\n")));
}

/// The studies of the boxes, after that of the deck.
Sweep sweep_of(const Deck& document, const std::vector<std::string>& overrides, const Study& study,
               const AssessmentDesign& design) {
  Sweep sweep = {.keys = {}, .tasks = {}, .overrides = overrides};
  const auto& inputs = study.uncertain;
  std::vector<std::size_t> of_boxes;
  std::vector<std::string> paths;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (!design.change_the_box[i]) continue;
    of_boxes.push_back(i);
    paths.push_back(inputs[i].name);
  }
  if (of_boxes.empty()) {
    sweep.tasks.push_back({.name = {}, .labels = {}, .values = {}, .study = study});
    return sweep;
  }
  const auto labels = labels_of_keys(paths);
  for (std::size_t i = 0; i < paths.size(); ++i) sweep.keys.push_back({.path = paths[i], .label = labels[i]});
  std::vector<Mistake> mistakes;
  const auto add = [&](const std::string& name, const Eigen::VectorXd& coordinates) {
    auto& task = sweep.tasks.emplace_back();
    task.name = name;
    task.study = study_with(document, overrides, inputs, design.change_the_box, coordinates, mistakes);
    for (const auto i : of_boxes) {
      task.values.push_back(value_at(inputs[i], coordinates[static_cast<Eigen::Index>(i)]));
      task.labels.push_back(fmt::format("{}-{}", sweep.keys[task.labels.size()].label, plain_text(task.values.back())));
    }
  };
  add("median", Eigen::VectorXd::Zero(static_cast<Eigen::Index>(inputs.size())));
  for (Eigen::Index box = 0; box < design.boxes.cols(); ++box) {
    add(fmt::format("box-{:02}", box + 1), design.boxes.col(box));
  }
  refuse_mistakes(document.path(), mistakes);
  return sweep;
}

}  // namespace

DeckAssessment::DeckAssessment(std::unique_ptr<State> state) : state_(std::move(state)) {}
DeckAssessment::DeckAssessment(DeckAssessment&&) noexcept = default;
DeckAssessment& DeckAssessment::operator=(DeckAssessment&&) noexcept = default;
DeckAssessment::~DeckAssessment() = default;

namespace {

/// Reads the study of a deck and lays out its samples.
template <class State>
std::unique_ptr<State> state_of(Deck document, const std::vector<std::string>& overrides,
                                const AssessmentOptions& options) {
  auto study = resolve(document);
  document.finish();
  require_assessable(document, study);
  add_hashes(document, overrides, study);
  std::vector<bool> change_the_box;
  for (const auto& input : study.uncertain) change_the_box.push_back(!is_answered_by_responses(input, study));
  auto design = design_samples(study.uncertain, change_the_box, options);
  auto materials = materials_of(document, study, design);
  auto sweep = sweep_of(document, overrides, study, design);
  require_alike(document, sweep);
  return std::make_unique<State>(State{std::move(document), overrides, std::move(study), std::move(design),
                                       std::move(sweep), std::move(materials)});
}

}  // namespace

DeckAssessment::DeckAssessment(const std::filesystem::path& deck, const std::vector<std::string>& overrides,
                               const AssessmentOptions& options, const ValueOrigins& origins)
    : state_(state_of<State>(Deck(deck, overrides, origins), overrides, options)) {}

DeckAssessment DeckAssessment::from_text(const std::string& deck, const std::filesystem::path& directory,
                                         const std::vector<std::string>& overrides, const AssessmentOptions& options,
                                         const ValueOrigins& origins) {
  return DeckAssessment(
      state_of<State>(Deck::from_text(deck, "study", directory, overrides, origins), overrides, options));
}

const std::vector<UncertainInput>& DeckAssessment::inputs() const noexcept {
  return state_->study.uncertain;
}

const AssessmentDesign& DeckAssessment::design() const noexcept {
  return state_->design;
}

const Sweep& DeckAssessment::sweep() const noexcept {
  return state_->sweep;
}

Study DeckAssessment::study_with(std::size_t input, const Scalar& value) const {
  auto overrides = state_->overrides;
  overrides.push_back(override_of(inputs().at(input), value));
  auto changed = state_->document.unread_copy();
  changed.set(setting_of(inputs().at(input), value));
  auto study = resolve(changed);
  changed.finish();
  add_hashes(changed, overrides, study);
  return study;
}

std::string DeckAssessment::stage_named(const std::string& name) const {
  if (name.empty()) return state_->study.stages.back().name;
  std::vector<std::string> names;
  for (const auto& stage : state_->study.stages) names.push_back(stage.name);
  if (std::ranges::find(names, name) != names.end()) return name;
  throw InputError(fmt::format("no stage \"{}\"{}", name, suggestion(name, names)));
}

std::vector<SampledCurve> DeckAssessment::curves(const std::vector<Responder>& solved,
                                                 const std::vector<StageFindings>& reference, const std::string& stage,
                                                 int threads) const {
  if (solved.size() != state_->sweep.tasks.size()) {
    throw InputError(
        fmt::format("expected the responders of {} studies, got {}", state_->sweep.tasks.size(), solved.size()));
  }
  const auto name = stage_named(stage);
  const auto found = std::ranges::find(reference, name, &StageFindings::name);
  if (found == reference.end()) throw InputError(fmt::format("no results of stage {}", name));
  SampledStage sampled = {.reference = *found,
                          .boxes = {solved.begin() + (solved.size() > 1 ? 1 : 0), solved.end()},
                          .box_of = state_->design.box_of,
                          .materials = state_->materials,
                          .threads = threads};
  return sample_curves(sampled);
}

}  // namespace breccia
