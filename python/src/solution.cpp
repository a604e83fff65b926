#include "solution.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "words.hpp"

namespace breccia::python {
namespace {

std::string in_words(const TestId& test) {
  return fmt::format("{}, {}, {}, {}", name_of(test.load), name_of(test.boundary), words_of(test.grid),
                     name_of(test.method));
}

std::string tests_in_words(const StageFindings& stage) {
  std::vector<std::string> tests;
  for (const auto& test : stage.tests) tests.push_back(in_words(test.id));
  return fmt::format("{}", fmt::join(tests, "; "));
}

void require_known(const TestWords& words) {
  if (words.boundary) static_cast<void>(value_of<Boundary>("boundary", *words.boundary));
  if (words.method) static_cast<void>(value_of<Method>("method", *words.method));
  if (words.grid && !grid_named(*words.grid)) {
    throw InputError(fmt::format(R"(grid: expected cells per side, "extrapolated" or "films", got "{}")", *words.grid));
  }
}

/// The load of these words; without one the main shear, or shear where there is none.
TestLoad load_of(const TestWords& words, const StageFindings& stage) {
  if (words.load) return value_of<TestLoad>("load", *words.load);
  std::vector<TestLoad> loads;
  for (const auto& test : stage.tests) loads.push_back(test.id.load);
  return main_shear(loads).value_or(Load::shear);
}

bool has_fields(const TestResult& test) {
  return std::visit([](const auto& fields) { return !fields.at_times.empty(); }, test.fields);
}

bool fits(const TestWords& words, const TestId& test) {
  return (!words.boundary || *words.boundary == name_of(test.boundary)) &&
         (!words.method || *words.method == name_of(test.method)) && (!words.grid || *words.grid == name_of(test.grid));
}

/// The preferred test of those that match the words and are accepted. Throws InputError where there is none, with the
/// tests that exist, or where they have several boundaries.
template <class Accepts>
const TestResult& preferred_of(const StageFindings& stage, const TestWords& words, const Accepts& accepts) {
  const TestResult* found = nullptr;
  std::set<Boundary> boundaries;
  for (const auto& test : stage.tests) {
    if (!accepts(test) || !fits(words, test.id)) continue;
    boundaries.insert(test.id.boundary);
    if (found == nullptr || is_preferred(test.id, found->id)) found = &test;
  }
  if (found == nullptr) {
    throw InputError(fmt::format("stage {}: no such test; it has {}", stage.name,
                                 stage.tests.empty() ? "none" : tests_in_words(stage)));
  }
  if (boundaries.size() > 1) {
    std::vector<std::string> names;
    names.reserve(boundaries.size());
    for (const auto boundary : boundaries) names.push_back(fmt::format("boundary=\"{}\"", name_of(boundary)));
    throw InputError(fmt::format("stage {}: expected {}", stage.name, fmt::join(names, " or ")));
  }
  return *found;
}

}  // namespace

std::shared_ptr<Solution> solution_of(const Study& study, StudyResult result) {
  auto solution = std::make_shared<Solution>();
  solution->content = study_content(study, result);
  solution->seconds = result.seconds;
  solution->responses = responses_of(study, result);
  for (auto& stage : result.stages) {
    const auto of_study = std::ranges::find(study.stages, stage.name, &Stage::name);
    auto box = box_of(*of_study, stage.microstructure);
    solution->stages.push_back({static_cast<StageFindings&&>(stage), std::move(box)});
  }
  return solution;
}

const TestResult& test_of(const StageFindings& stage, const TestWords& words) {
  require_known(words);
  const auto load = load_of(words, stage);
  return preferred_of(stage, words, [load](const TestResult& test) { return test.id.load == load; });
}

const TestResult& test_with_fields(const StageFindings& stage, const TestWords& words) {
  require_known(words);
  const auto asked = words.load ? std::optional(load_of(words, stage)) : std::nullopt;
  const auto is_asked = [&](const TestResult& test) {
    return has_fields(test) && fits(words, test.id) && (!asked || test.id.load == *asked);
  };
  const auto first = std::ranges::find_if(stage.tests, is_asked);
  if (first == stage.tests.end()) {
    throw InputError(
        fmt::format("stage {}: no such fields; tests.fields = \"last\" keeps those at the last time, on the "
                    "finest grid",
                    stage.name));
  }
  return preferred_of(stage, words,
                      [&](const TestResult& test) { return is_asked(test) && test.id.load == first->id.load; });
}

}  // namespace breccia::python
