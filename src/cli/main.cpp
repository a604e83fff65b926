#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/io/nearest_name.hpp"

#include "command.hpp"

namespace {

/// `unknown command "chek", did you mean "check"?`, if that is what went wrong.
std::string unknown_command(const CLI::App& application, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-' || !application.get_subcommands().empty()) return {};
  std::vector<std::string> commands;
  for (const auto* command : application.get_subcommands(nullptr)) commands.push_back(command->get_name());
  return fmt::format("unknown command \"{}\"{}", argv[1], breccia::suggestion(argv[1], commands));
}

/// What was printed may still be on its way, to a disk that is full.
void flush_output() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) throw breccia::FileError("standard output: cannot write");
}

/// CLI11 has an exit code for every way to misuse a command line; we have one.
int report(const CLI::App& application, const CLI::ParseError& error) {
  const bool is_mistake = application.exit(error) != 0;
  return static_cast<int>(is_mistake ? breccia::ExitCode::bad_input : breccia::ExitCode::done);
}

int run(int argc, char** argv) {
  CLI::App application("Relaxation moduli of highly filled composites, from their constituents.", "breccia");
  application.set_version_flag("--version", "breccia " BRECCIA_VERSION);
  application.require_subcommand(0, 1);
  application.failure_message(CLI::FailureMessage::simple);
  breccia::cli::add_run(application);
  breccia::cli::add_check(application);
  breccia::cli::add_pack(application);
  try {
    application.parse(argc, argv);
    if (application.get_subcommands().empty()) throw CLI::RequiredError("a command");
  } catch (const CLI::ParseError& error) {
    const auto unknown = unknown_command(application, argc, argv);
    if (!unknown.empty()) throw breccia::InputError(unknown);
    return report(application, error);
  }
  flush_output();
  return static_cast<int>(breccia::ExitCode::done);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const breccia::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return static_cast<int>(error.exit_code());
  } catch (const std::filesystem::filesystem_error& error) {
    fmt::print(stderr, "breccia: {}\n", error.what());
    return static_cast<int>(breccia::ExitCode::file_failure);
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "not enough memory for this deck; `breccia check` tells how much it takes\n");
    return static_cast<int>(breccia::ExitCode::numerical_failure);
  } catch (const std::exception& error) {
    fmt::print(stderr, "breccia: internal error: {}\n", error.what());
    return static_cast<int>(breccia::ExitCode::numerical_failure);
  }
}
