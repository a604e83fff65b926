#include "errors.hpp"

#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/homogenisation/new_materials.hpp"
#include "breccia/homogenisation/plan.hpp"

#include "homogenisation/respond/not_covered.hpp"
#include "io/conflicting_results.hpp"
#include "io/display.hpp"
#include "tables/unknown_columns.hpp"

namespace breccia::python {
namespace {

namespace py = pybind11;

/// Advice to a caller in Python about a conflict of writing in a directory.
std::string advice_on(const ResultConflict& conflict) {
  using Remedy = ResultConflict::Remedy;
  std::vector<std::string> ways;
  if (conflict.remedy == Remedy::none) return {};
  if (conflict.remedy == Remedy::not_resuming) {
    ways.emplace_back("run with overwrite=True in place of resume=True");
  } else {
    ways.emplace_back("replace what is there (overwrite=True)");
  }
  if (conflict.remedy == Remedy::adding) ways.emplace_back("add to it (resume=True)");
  ways.emplace_back("take another directory");
  return "; " + fmt::format("{}", fmt::join(ways, " or "));
}

/// The message of an error, with the arguments that help.
std::string with_advice(const Error& error) {
  if (const auto* const foreign = dynamic_cast<const ConflictingResults*>(&error)) {
    std::vector<std::string> lines;
    for (const auto& conflict : foreign->conflicts()) lines.push_back(conflict.problem + advice_on(conflict));
    return fmt::format("{}", fmt::join(lines, "\n"));
  }
  std::string message = error.what();
  if (dynamic_cast<const LackingMemory*>(&error) != nullptr) message += " (ignore_memory=True runs them nevertheless)";
  if (dynamic_cast<const Interrupted*>(&error) != nullptr) message += ", and resume=True continues from it";
  if (dynamic_cast<const UnknownColumns*>(&error) != nullptr) {
    message += "\ncolumns={\"storage\": NAME, \"loss\": NAME} tells which column is which";
  }
  if (dynamic_cast<const NotVaried*>(&error) != nullptr) {
    message += "; a study built in Python has this table as Tests(quasistatic={\"vary\": {...}})";
  }
  const auto* const not_covered = dynamic_cast<const NotCovered*>(&error);
  if (not_covered != nullptr && not_covered->times()) {
    const auto& times = *not_covered->times();
    message += fmt::format(R"(: times=("{}", "{}"))", display(times.begin, "s", 3), display(times.end, "s", 3));
  }
  return message;
}

void raise(const char* name, const std::string& message) {
  PyErr_SetString(py::module_::import("breccia._errors").attr(name).ptr(), message.c_str());
}

const char* name_of(const Error& error) {
  switch (error.exit_code()) {
    case ExitCode::bad_input:
      return "InputError";
    case ExitCode::numerical_failure:
      return "NumericalError";
    case ExitCode::file_failure:
      return "FileError";
    case ExitCode::interrupted:
      return "Interrupted";
    default:
      return "Error";
  }
}

}  // namespace

void translate_errors() {
  // The argument is passed by value, as pybind11 requires.
  py::register_exception_translator([](std::exception_ptr thrown) {  // NOLINT(performance-unnecessary-value-param)
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& error) {
      raise(name_of(error), with_advice(error));
    } catch (const std::filesystem::filesystem_error& error) {
      raise("FileError", error.what());
    }
  });
}

}  // namespace breccia::python
