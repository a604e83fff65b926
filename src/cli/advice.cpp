#include "advice.hpp"

#include <fmt/format.h>

#include "breccia/homogenisation/memory.hpp"
#include "breccia/homogenisation/not_covered.hpp"
#include "breccia/io/directory_lock.hpp"
#include "breccia/io/display.hpp"
#include "breccia/io/whole_results.hpp"

namespace breccia::cli {
namespace {

bool has(const CLI::App& command, const char* option) {
  return command.get_option_no_throw(option) != nullptr;
}

/// The text that is added to the message of an error; empty if no option of the command helps.
std::string advice_on(const Error& error, const CLI::App& command) {
  if (dynamic_cast<const DirectoryInUse*>(&error) != nullptr && has(command, "--out")) {
    return ", or take another directory (--out)";
  }
  if (dynamic_cast<const LackingMemory*>(&error) != nullptr && has(command, "--no-memory-check")) {
    return " (--no-memory-check runs them nevertheless)";
  }
  if (dynamic_cast<const Interrupted*>(&error) != nullptr && has(command, "--resume")) {
    return ", and --resume continues from it";
  }
  const auto* const not_covered = dynamic_cast<const NotCovered*>(&error);
  if (not_covered != nullptr && not_covered->times() && has(command, "--times")) {
    const auto& times = *not_covered->times();
    return fmt::format(": --times \"{}\" \"{}\"", display(times.begin, "s", 3), display(times.end, "s", 3));
  }
  return {};
}

}  // namespace

std::string with_advice(const Error& error, const CLI::App& command) {
  const auto* const foreign = dynamic_cast<const ForeignResults*>(&error);
  if (foreign != nullptr && has(command, "--out")) {
    const bool may_be_overwritten = foreign->remedy() == ForeignResults::Remedy::overwriting;
    return fmt::format("{}; {}take another directory (--out)", foreign->problem(),
                       may_be_overwritten ? "replace it (--overwrite) or " : "");
  }
  return error.what() + advice_on(error, command);
}

}  // namespace breccia::cli
