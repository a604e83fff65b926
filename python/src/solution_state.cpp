#include "solution_state.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "breccia/error.hpp"
#include "breccia/results/response_file.hpp"

#include "fields_state.hpp"
#include "materials.hpp"
#include "views.hpp"
#include "words.hpp"

namespace breccia::python {
namespace {

namespace py = pybind11;
namespace fs = std::filesystem;

constexpr int format = 3;

/// A directory that exists as long as this object.
class ScratchDirectory {
 public:
  ScratchDirectory() {
    auto name = (fs::temp_directory_path() / "breccia-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw FileError(fmt::format("{}: cannot make a directory", name));
    path_ = name;
  }
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;
  ScratchDirectory(ScratchDirectory&&) = delete;
  ScratchDirectory& operator=(ScratchDirectory&&) = delete;
  ~ScratchDirectory() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// The bytes of the file in which results keep the reduced responses of a stage.
py::bytes bytes_of(const StoredResponses& responses) {
  const ScratchDirectory scratch;
  write_responses(scratch.path(), responses);
  std::ifstream stream(scratch.path() / "response.h5", std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

StoredResponses responses_from(const std::string& bytes) {
  const ScratchDirectory scratch;
  const auto file = scratch.path() / "response.h5";
  std::ofstream(file, std::ios::binary) << bytes;
  return read_responses(file);
}

/// Pairs of numbers as two arrays.
template <class Pairs>
py::tuple columns_of(const Pairs& pairs) {
  std::vector<double> first, second;
  for (const auto& [one, other] : pairs) {
    first.push_back(one);
    second.push_back(other);
  }
  return py::make_tuple(array_of(first), array_of(second));
}

template <class Pair>
std::vector<Pair> pairs_from(const py::tuple& columns) {
  const auto first = columns[0].cast<std::vector<double>>(), second = columns[1].cast<std::vector<double>>();
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < first.size(); ++i) pairs.push_back({first[i], second.at(i)});
  return pairs;
}

py::dict state_of(const TestId& test) {
  py::dict state;
  state["load"] = name_of(test.load);
  state["boundary"] = name_of(test.boundary);
  state["method"] = name_of(test.method);
  state["grid"] = name_of(test.grid);
  return state;
}

TestId id_from(const py::dict& state) {
  const auto grid = grid_named(state["grid"].cast<std::string>());
  if (!grid) throw InputError("pickle: not a result of Breccia");
  return {value_of<Load>("load", state["load"].cast<std::string>()),
          value_of<Boundary>("boundary", state["boundary"].cast<std::string>()),
          value_of<Method>("method", state["method"].cast<std::string>()), *grid};
}

py::dict state_of(const TestResult& test) {
  py::dict state;
  state["id"] = state_of(test.id);
  state["modulus"] = columns_of(test.modulus);
  state["compliance"] = columns_of(test.compliance);
  state["series"] = python::state_of(test.series);
  state["fields"] = state_of_fields(test.fields);
  state["error_estimate"] = test.error_estimate;
  state["half_bands"] = array_of(test.half_bands);
  state["seconds"] = test.seconds;
  return state;
}

}  // namespace

py::dict state_of_test(const TestResult& test) {
  return state_of(test);
}

TestResult test_from(const py::dict& state) {
  TestResult test{.id = id_from(state["id"].cast<py::dict>())};
  test.modulus = pairs_from<Sample>(state["modulus"].cast<py::tuple>());
  test.compliance = pairs_from<CreepSample>(state["compliance"].cast<py::tuple>());
  test.series = series_from(state["series"].cast<py::tuple>());
  test.fields = fields_from(state["fields"].cast<py::tuple>());
  test.error_estimate = state["error_estimate"].cast<double>();
  test.half_bands = state["half_bands"].cast<std::vector<double>>();
  test.seconds = state["seconds"].cast<std::optional<double>>();
  return test;
}

namespace {

py::dict state_of(const StageMaterial& material) {
  const auto& [solid, fitted, shear_error, bulk_error] = material.result;
  py::dict state;
  state["boundary"] = name_of(material.boundary);
  state["method"] = name_of(material.method);
  state["material"] = python::state_of(solid);
  state["numbers"] = py::make_tuple(fitted.begin, fitted.end, shear_error, bulk_error);
  return state;
}

StageMaterial material_of_stage(const py::dict& state) {
  const auto numbers = state["numbers"].cast<py::tuple>();
  return {value_of<Boundary>("boundary", state["boundary"].cast<std::string>()),
          value_of<Method>("method", state["method"].cast<std::string>()),
          {material_from(state["material"].cast<py::tuple>()),
           {numbers[0].cast<double>(), numbers[1].cast<double>()},
           numbers[2].cast<double>(),
           numbers[3].cast<double>()}};
}

py::dict state_of(const Comparison& comparison) {
  py::list samples;
  for (const auto& [time, modulus, measured] : comparison.samples)
    samples.append(py::make_tuple(time, modulus, measured));
  py::dict state;
  state["measurement"] = comparison.measurement;
  state["test"] = state_of(comparison.test);
  state["samples"] = samples;
  return state;
}

Comparison comparison_from(const py::dict& state) {
  Comparison comparison{state["measurement"].cast<std::string>(), id_from(state["test"].cast<py::dict>()), {}};
  for (const auto& one : state["samples"]) {
    const auto sample = one.cast<py::tuple>();
    comparison.samples.push_back({sample[0].cast<double>(), sample[1].cast<double>(), sample[2].cast<double>()});
  }
  return comparison;
}

py::dict state_of(const SolvedStage& stage);
py::dict state_of(const StoredMaterial& stored);
py::dict state_of(const StageContent& stage);

/// The states of a list.
template <class List>
py::list states_of(const List& list) {
  py::list states;
  for (const auto& one : list) states.append(state_of(one));
  return states;
}

template <class Element>
std::vector<Element> all_from(const py::handle& states, Element (*from)(const py::dict&)) {
  std::vector<Element> all;
  for (const auto& state : states) all.push_back(from(state.cast<py::dict>()));
  return all;
}

py::dict state_of(const SolvedStage& stage) {
  const auto& result = stage.result;
  py::dict state;
  state["name"] = result.name;
  state["numbers"] = py::make_tuple(result.cells, result.dimensions, result.points, result.point_fraction);
  state["microstructure"] = stage.box ? py::object(python::state_of(*stage.box)) : py::object(py::none());
  state["tests"] = states_of(result.tests);
  state["materials"] = states_of(result.materials);
  state["comparisons"] = states_of(result.comparisons);
  state["warnings"] = result.warnings;
  return state;
}

}  // namespace

py::dict state_of_stage(const SolvedStage& stage) {
  return state_of(stage);
}

SolvedStage stage_from(const py::dict& state) {
  SolvedStage stage;
  auto& result = stage.result;
  result.name = state["name"].cast<std::string>();
  const auto numbers = state["numbers"].cast<py::tuple>();
  result.cells = numbers[0].cast<int>();
  result.dimensions = numbers[1].cast<int>();
  result.points = numbers[2].cast<std::size_t>();
  result.point_fraction = numbers[3].cast<double>();
  const py::object box = state["microstructure"];
  if (!box.is_none()) stage.box = box_from(box.cast<py::dict>());
  result.tests = all_from(state["tests"], &test_from);
  result.materials = all_from(state["materials"], &material_of_stage);
  result.comparisons = all_from(state["comparisons"], &comparison_from);
  result.warnings = state["warnings"].cast<std::vector<std::string>>();
  return stage;
}

namespace {

py::tuple numbers_of(const WilliamsLandelFerry& law) {
  return py::make_tuple(law.c1, law.c2, law.reference_temperature);
}

py::tuple numbers_of(const ShiftTable& table) {
  return py::make_tuple(table.temperatures(), table.log10_factors(), table.reference_temperature());
}

ShiftLaw shift_law_from(const py::tuple& numbers) {
  const double reference = numbers[2].cast<double>();
  if (py::isinstance<py::float_>(numbers[0])) {
    return WilliamsLandelFerry{numbers[0].cast<double>(), numbers[1].cast<double>(), reference};
  }
  return ShiftTable(numbers[0].cast<std::vector<double>>(), numbers[1].cast<std::vector<double>>(), reference);
}

py::dict state_of(const StoredMaterial& stored) {
  py::dict state;
  state["material"] = python::state_of(stored.material);
  py::object shift = py::none();
  if (stored.shift) {
    const auto of_law = std::visit([](const auto& law) { return numbers_of(law); }, stored.shift->law);
    shift = py::make_tuple(of_law, stored.shift->temperature);
  }
  state["shift"] = shift;
  return state;
}

StoredMaterial stored_material_from(const py::dict& state) {
  StoredMaterial stored{material_from(state["material"].cast<py::tuple>()), std::nullopt};
  const py::object shift = state["shift"];
  if (!shift.is_none()) {
    const auto parts = shift.cast<py::tuple>();
    stored.shift = {shift_law_from(parts[0].cast<py::tuple>()), parts[1].cast<double>()};
  }
  return stored;
}

py::dict state_of(const StageContent& stage) {
  py::list shares;
  for (const auto& [material, fraction, mass_fraction] : stage.shares) {
    shares.append(py::make_tuple(material, fraction, mass_fraction));
  }
  py::dict state;
  state["name"] = stage.name;
  state["matrix"] = stage.matrix;
  state["dimensions"] = stage.dimensions;
  state["shares"] = shares;
  return state;
}

StageContent stage_content_from(const py::dict& state) {
  StageContent stage{state["name"].cast<std::string>(), state["matrix"].cast<std::string>(),
                     state["dimensions"].cast<int>()};
  for (const auto& one : state["shares"]) {
    const auto share = one.cast<py::tuple>();
    stage.shares.push_back({share[0].cast<std::string>(), share[1].cast<double>(), share[2].cast<double>()});
  }
  return stage;
}

py::dict state_of(const StudyContent& content) {
  py::dict state;
  state["title"] = content.title;
  state["times"] = py::make_tuple(content.times.begin, content.times.end);
  state["stages"] = states_of(content.stages);
  state["materials"] = states_of(content.materials);
  return state;
}

StudyContent content_from(const py::dict& state) {
  const auto times = state["times"].cast<py::tuple>();
  return {state["title"].cast<std::string>(),
          {times[0].cast<double>(), times[1].cast<double>()},
          all_from(state["stages"], &stage_content_from),
          all_from(state["materials"], &stored_material_from)};
}

}  // namespace

py::dict state_of_solution(const Solution& solution) {
  py::dict state;
  state["format"] = format;
  state["content"] = state_of(solution.content);
  state["seconds"] = solution.seconds;
  state["stages"] = states_of(solution.stages);
  py::list responses;
  for (const auto& stored : solution.responses) {
    if (!stored.entries.empty()) responses.append(bytes_of(stored));
  }
  state["responses"] = responses;
  return state;
}

std::shared_ptr<Solution> solution_from(const py::dict& state) {
  if (!state.contains("format") || state["format"].cast<int>() != format) {
    throw InputError("pickle: this result is of another version of Breccia");
  }
  auto solution = std::make_shared<Solution>();
  solution->content = content_from(state["content"].cast<py::dict>());
  solution->seconds = state["seconds"].cast<std::optional<double>>();
  solution->stages = all_from(state["stages"], &stage_from);
  for (const auto& one : state["responses"]) {
    solution->responses.push_back(responses_from(one.cast<std::string>()));
  }
  return solution;
}

}  // namespace breccia::python
