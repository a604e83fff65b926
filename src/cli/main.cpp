#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <sstream>
#include <string>
#include <string_view>
#include <thread>

#include <fmt/format.h>
#include <malloc.h>

#include "breccia/error.hpp"

#include "cli/advice.hpp"
#include "cli/command.hpp"
#include "cli/help.hpp"
#include "cli/misuse.hpp"
#include "cli/thread_waiting.hpp"
#include "cli/version.hpp"
#include "parallel/session.hpp"

namespace {

constexpr auto what_breccia_does =
    R"(Predicts the relaxation modulus of a highly filled composite from its constituents.

- Input: the spectrum of the binder, the moduli of the filler, and the sizes of its particles, in a deck.
- Output: G(t) of a periodic box, with its error; or apparent moduli, under displacements (KUBC) and tractions (SUBC).
- Two solvers: a quasi-static one (reduced basis, seconds) and an explicit material point method that checks it.
- Multiscale chain: small particles and binder first; the mixture is the matrix of the larger particles.
)";

/// Flushes standard output. Throws FileError if it cannot be written, for example because the disk is full.
void flush_output() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) throw breccia::FileError("standard output: cannot write");
}

/// Sets the wording of the help instead of that of CLI11; commands that are added later inherit it.
void name_parts_of_help(CLI::App& application) {
  application.set_help_flag("-h,--help", "print this help");
  const auto formatter = application.get_formatter();
  formatter->label("SUBCOMMAND", "COMMAND");
  formatter->label("Positionals", "Arguments");
  formatter->label("REQUIRED", "(required)");
}

void add_commands(CLI::App& application) {
  namespace cli = breccia::cli;
  cli::add_studio(application);
  cli::add_new(application);
  cli::add_check(application);
  cli::add_run(application);
  cli::add_report(application);
  cli::add_compare(application);
  cli::add_respond(application);
  cli::add_assess(application);
  cli::add_find(application);
  cli::add_calibrate(application);
  cli::add_pack(application);
  cli::add_stages(application);
  cli::add_fit(application);
  cli::add_export(application);
  cli::add_mesh(application);
  cli::add_bench(application);
  cli::add_examples(application);
  cli::add_completion(application);
  cli::add_help(application);
  for (auto* command : application.get_subcommands({})) command->group("Commands");
}

int run(int argc, char** argv) {
  CLI::App application(what_breccia_does, "breccia");
  name_parts_of_help(application);
  application.set_version_flag("--version", breccia::cli::version_text,
                               "print the version, the build and the kernels of this machine");
  application.require_subcommand(0, 1);
  add_commands(application);
  application.footer(breccia::cli::where_to_begin());
  try {
    application.parse(argc, argv);
    if (application.get_subcommands().empty()) throw CLI::RequiredError("a command");
  } catch (const breccia::Error& error) {
    const auto commands = application.get_subcommands();
    if (commands.empty()) throw;
    throw breccia::Error(error.exit_code(), breccia::cli::with_advice(error, *commands.front()));
  } catch (const CLI::ParseError& error) {
    const bool is_mistake = error.get_exit_code() != static_cast<int>(CLI::ExitCodes::Success);
    if (is_mistake) throw breccia::InputError(breccia::cli::describe_misuse(application, error));
    std::ostringstream asked_for;
    application.exit(error, asked_for);
    fmt::print("{}", asked_for.str());
  }
  flush_output();
  return static_cast<int>(breccia::ExitCode::done);
}

struct Outcome {
  breccia::ExitCode exit_code = breccia::ExitCode::done;
  std::string failure = {};  ///< the error message; empty without an error or if it was printed already
};

Outcome guarded_run(int argc, char** argv) {
  using breccia::ExitCode;
  try {
    if (breccia::parallel::is_under_mpirun()) breccia::parallel::start();
    return {static_cast<ExitCode>(run(argc, argv))};
  } catch (const breccia::Error& error) {
    return {error.exit_code(), error.what()};
  } catch (const std::filesystem::filesystem_error& error) {
    return {ExitCode::file_failure, fmt::format("breccia: {}", error.what())};
  } catch (const std::bad_alloc&) {
    return {ExitCode::numerical_failure,
            "not enough memory; `breccia check` estimates that of the grids, to which large pictures and tables add"};
  } catch (const std::exception& error) {
    return {ExitCode::numerical_failure, fmt::format("breccia: internal error: {}", error.what())};
  }
}

/// If all processes fail in the same way, the first one prints the message and ends all of them. A process that is not
/// ended after a while has failed alone: it prints its own message and ends the other processes, which may be waiting
/// for it.
void end_all(const Outcome& outcome) {
  namespace parallel = breccia::parallel;
  constexpr std::chrono::seconds while_the_first_speaks(3);
  if (!parallel::is_first()) std::this_thread::sleep_for(while_the_first_speaks);
  constexpr std::chrono::seconds while_others_write(10);
  const bool is_interrupted = outcome.exit_code == breccia::ExitCode::interrupted;
  if (is_interrupted && parallel::groups() > 1) std::this_thread::sleep_for(while_others_write);
  if (!outcome.failure.empty()) {
    const int process = parallel::group() * parallel::ranks() + parallel::rank();
    fmt::print(stderr, "{}{}\n", process > 0 ? fmt::format("process {}: ", process) : "", outcome.failure);
  }
  if (!parallel::is_alone()) parallel::abort(static_cast<int>(outcome.exit_code));
}

/// Has memory of large fields given back to the system as soon as it is freed. Left to itself, the C library keeps
/// freed blocks of up to 32 MB, between which others do not fit.
void give_back_large_blocks() noexcept {
#ifdef M_MMAP_THRESHOLD
  constexpr int large = 4 << 20;
  mallopt(M_MMAP_THRESHOLD, large);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && argv[1] == std::string_view("run")) breccia::cli::have_threads_sleep_soon(argv);
  give_back_large_blocks();
  const auto outcome = guarded_run(argc, argv);
  if (outcome.exit_code != breccia::ExitCode::done) end_all(outcome);
  breccia::parallel::stop();
  return static_cast<int>(outcome.exit_code);
}
