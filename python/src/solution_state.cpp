#include "solution_state.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "breccia/error.hpp"

#include "fields_state.hpp"
#include "homogenisation/run/comparison.hpp"
#include "results/response_file.hpp"
#include "results/result_bytes.hpp"

namespace breccia::python {
namespace {

namespace py = pybind11;
namespace fs = std::filesystem;

constexpr int format = 7;

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
py::bytes bytes_of_file(const StageResponses& responses) {
  const ScratchDirectory scratch;
  write_responses(scratch.path(), responses);
  std::ifstream stream(scratch.path() / "response.h5", std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

StageResponses responses_from(const std::string& bytes) {
  const ScratchDirectory scratch;
  const auto file = scratch.path() / "response.h5";
  std::ofstream(file, std::ios::binary) << bytes;
  return read_responses(file);
}

/// Text would have to be UTF-8.
py::bytes as_bytes(const std::string& bytes) {
  return bytes;
}

template <class State>
std::string bytes_in(const State& state) {
  return state.template cast<std::string>();
}

}  // namespace

py::dict state_of_test(const TestResult& test) {
  py::dict state;
  state["result"] = as_bytes(bytes_of(test));
  state["fields"] = state_of_fields(test.fields);
  return state;
}

TestResult test_from(const py::dict& state) {
  auto test = test_from_bytes(bytes_in(state["result"]));
  test.fields = fields_from(state["fields"].cast<py::tuple>());
  return test;
}

py::dict state_of_stage(const SolvedStage& stage) {
  py::list fields;
  for (const auto& test : stage.result.tests) fields.append(state_of_fields(test.fields));
  py::dict state;
  state["result"] = as_bytes(bytes_of(stage.result));
  state["fields"] = fields;
  state["microstructure"] = stage.box ? py::object(python::state_of(*stage.box)) : py::object(py::none());
  return state;
}

SolvedStage stage_from(const py::dict& state) {
  SolvedStage stage{stage_from_bytes(bytes_in(state["result"])), std::nullopt};
  const auto fields = state["fields"].cast<py::list>();
  for (std::size_t i = 0; i < stage.result.tests.size(); ++i) {
    stage.result.tests[i].fields = fields_from(fields[i].cast<py::tuple>());
  }
  const py::object box = state["microstructure"];
  if (!box.is_none()) stage.box = box_from(box.cast<py::dict>());
  return stage;
}

py::dict state_of_solution(const Solution& solution) {
  py::list stages, responses;
  for (const auto& stage : solution.stages) stages.append(state_of_stage(stage));
  for (const auto& stored : solution.responses) {
    if (stored.entries.empty()) continue;
    responses.append(py::make_tuple(bytes_of_file(stored), stored.fillers, stored.warnings));
  }
  py::dict state;
  state["format"] = format;
  state["content"] = as_bytes(bytes_of(solution.content));
  state["seconds"] = solution.seconds;
  state["stages"] = stages;
  state["responses"] = responses;
  return state;
}

std::shared_ptr<Solution> solution_from(const py::dict& state) {
  if (!state.contains("format") || state["format"].cast<int>() != format) {
    throw InputError("pickle: this result is of another version of Breccia");
  }
  auto solution = std::make_shared<Solution>();
  solution->content = content_from_bytes(bytes_in(state["content"]));
  solution->seconds = state["seconds"].cast<std::optional<double>>();
  for (const auto& stage : state["stages"]) solution->stages.push_back(stage_from(stage.cast<py::dict>()));
  for (const auto& one : state["responses"]) {
    const auto parts = one.cast<py::tuple>();
    solution->responses.push_back(responses_from(bytes_in(parts[0])));
    solution->responses.back().fillers = parts[1].cast<std::vector<std::string>>();
    solution->responses.back().warnings = parts[2].cast<std::vector<std::string>>();
    solution->responses.back().abscissa = solution->content.by_frequency ? Abscissa::frequency : Abscissa::time;
    for (const auto& stage : solution->stages) {
      if (stage.result.name != solution->responses.back().stage) continue;
      solution->responses.back().rules = stage.result.accuracy.rules;
      solution->responses.back().measurements = measurements_of(stage.result.name, stage.result.comparisons);
    }
  }
  return solution;
}

}  // namespace breccia::python
