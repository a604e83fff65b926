#include <cstdio>
#include <exception>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "command.hpp"

namespace {

/// CLI11 has an exit code for every way to misuse a command line; we have one.
int report(const CLI::App& application, const CLI::ParseError& error) {
  const bool is_mistake = application.exit(error) != 0;
  return static_cast<int>(is_mistake ? breccia::ExitCode::bad_input : breccia::ExitCode::done);
}

int run(int argc, char** argv) {
  CLI::App application("Relaxation moduli of highly filled composites, from their constituents.", "breccia");
  application.set_version_flag("--version", "breccia " BRECCIA_VERSION);
  application.require_subcommand(1);
  application.failure_message(CLI::FailureMessage::simple);
  breccia::cli::add_check(application);
  try {
    application.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return report(application, error);
  }
  return static_cast<int>(breccia::ExitCode::done);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const breccia::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return static_cast<int>(error.exit_code());
  } catch (const std::exception& error) {
    fmt::print(stderr, "breccia: {}\n", error.what());
    return static_cast<int>(breccia::ExitCode::numerical_failure);
  }
}
