#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <string_view>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/io/nearest_name.hpp"
#include "breccia/parallel/session.hpp"

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
  breccia::cli::add_respond(application);
  breccia::cli::add_report(application);
  breccia::cli::add_fit(application);
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

/// Says what went wrong, and returns the exit code. Of several processes that read the same deck one says it.
int fail(std::string_view message, breccia::ExitCode exit_code) {
  if (breccia::parallel::rank() == 0) fmt::print(stderr, "{}\n", message);
  return static_cast<int>(exit_code);
}

/// The same for what may happen to one of several processes alone.
int fail_alone(const std::string& message, breccia::ExitCode exit_code) {
  const bool is_alone = breccia::parallel::ranks() == 1;
  fmt::print(stderr, "{}{}\n", is_alone ? "" : fmt::format("process {}: ", breccia::parallel::rank()), message);
  return static_cast<int>(exit_code);
}

int guarded_run(int argc, char** argv) {
  using breccia::ExitCode;
  try {
    if (breccia::parallel::is_under_mpirun()) breccia::parallel::start();
    return run(argc, argv);
  } catch (const breccia::Error& error) {
    return fail(error.what(), error.exit_code());
  } catch (const std::filesystem::filesystem_error& error) {
    return fail_alone(fmt::format("breccia: {}", error.what()), ExitCode::file_failure);
  } catch (const std::bad_alloc&) {
    return fail_alone("not enough memory for this deck; `breccia check` tells how much it takes",
                      ExitCode::numerical_failure);
  } catch (const std::exception& error) {
    return fail_alone(fmt::format("breccia: internal error: {}", error.what()), ExitCode::numerical_failure);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int exit_code = guarded_run(argc, argv);
  // The others may be waiting for a process that has failed.
  if (exit_code != 0 && breccia::parallel::ranks() > 1) breccia::parallel::abort(exit_code);
  breccia::parallel::stop();
  return exit_code;
}
