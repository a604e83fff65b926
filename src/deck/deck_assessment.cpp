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
};

namespace {

std::string override_of(const UncertainInput& input, double coordinate) {
  return fmt::format("{}={}", input.name, toml_text(value_at(input, coordinate)));
}

Setting setting_of(const UncertainInput& input, double coordinate) {
  const Location location = {.option = override_of(input, coordinate)};
  return {input.name, location, {value_at(input, coordinate), location}};
}

/// The study of a deck with values for some of its inputs, and the mistakes that these make.
Study study_with(const Deck& document, std::vector<std::string> overrides, const std::vector<UncertainInput>& inputs,
                 const std::vector<bool>& chosen, const Eigen::VectorXd& coordinates, std::vector<Mistake>& mistakes) {
  auto changed = document.unread_copy();
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (!chosen[i]) continue;
    const double coordinate = coordinates[static_cast<Eigen::Index>(i)];
    changed.set(setting_of(inputs[i], coordinate));
    overrides.push_back(override_of(inputs[i], coordinate));
  }
  auto study = resolve(changed);
  const auto own = changed.mistakes();
  mistakes.insert(mistakes.end(), own.begin(), own.end());
  if (own.empty()) add_hashes(changed, overrides, study);
  return study;
}

/// Refuses decks that cannot be assessed.
void require_assessable(const Deck& document, const Study& study) {
  std::vector<std::string> lines;
  if (study.uncertain.empty()) {
    lines.emplace_back(
        R"(every input is certain; expected a distribution, as in shear = { value = "5.8 GPa", sd = "0.6 GPa" })");
  }
  if (document.unread_copy().root().has("sweep")) {
    lines.emplace_back("sweep: expected none; an input with several values is written { any = [1, 2, 3] }");
  }
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
  auto sweep = sweep_of(document, overrides, study, design);
  return std::make_unique<State>(
      State{std::move(document), overrides, std::move(study), std::move(design), std::move(sweep)});
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

void DeckAssessment::require_stage(const std::string& stage) const {
  if (stage.empty()) return;
  std::vector<std::string> names;
  for (const auto& one : state_->study.stages) names.push_back(one.name);
  if (std::ranges::find(names, stage) != names.end()) return;
  throw InputError(fmt::format("no stage \"{}\"{}", stage, suggestion(stage, names)));
}

std::vector<SampledCurve> DeckAssessment::curves(const std::vector<Responder>& solved,
                                                 const std::vector<StageFindings>& reference, const std::string& stage,
                                                 int threads) const {
  const auto& design = state_->design;
  const auto& inputs = state_->study.uncertain;
  if (solved.size() != state_->sweep.tasks.size()) {
    throw InputError(
        fmt::format("expected the responders of {} studies, got {}", state_->sweep.tasks.size(), solved.size()));
  }
  // The materials of which an input is answered by responses.
  std::vector<std::string> materials;
  for (const auto& varied : state_->study.tests.varied) materials.push_back(varied.name);
  require_stage(stage);
  const auto& name = stage.empty() ? state_->study.stages.back().name : stage;
  const auto found = std::ranges::find(reference, name, &StageFindings::name);
  if (found == reference.end()) throw InputError(fmt::format("no results of stage {}", name));
  SampledStage sampled = {.reference = *found,
                          .boxes = {solved.begin() + (solved.size() > 1 ? 1 : 0), solved.end()},
                          .box_of = design.box_of,
                          .threads = threads};
  for (Eigen::Index sample = 0; sample < design.coordinates.cols(); ++sample) {
    auto& of_sample = sampled.materials.emplace_back();
    for (const auto& material : materials) {
      std::vector<Setting> settings;
      for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (design.change_the_box[i] || material_of(inputs[i]) != material) continue;
        settings.push_back(setting_of(inputs[i], design.coordinates(static_cast<Eigen::Index>(i), sample)));
      }
      if (settings.empty()) continue;
      of_sample.push_back(new_material(material, material_with(state_->document, material, settings)));
    }
  }
  return sample_curves(sampled);
}

}  // namespace breccia
