// Decks with one mistake each, run through the command: the mistake is reported with its location, or the deck runs to
// its end, or the run reports why its numbers are impossible; and no unfinished files remain. BRECCIA_MUTATED_DECKS=300
// takes more of them and prints a table (scripts/fuzz-decks).

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <random>
#include <regex>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "command.hpp"
#include "deck_mutation.hpp"
#include "io/text_file.hpp"
#include "tables/csv.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

constexpr std::array decks = {
    R"(title = "Walled"

[materials.binder]
density = "1.48 g/cm^3"
bulk    = "3.6 GPa"
shear   = { prony = "binder.csv", equilibrium = "1 kPa" }
temperature_shift = { law = "wlf", c1 = 6.5, c2 = "120 K", reference = "19 degC", temperature = "25 degC" }

[materials.hmx]
density = "1.85 g/cm^3"
bulk    = "13.4 GPa"
shear   = "5.84 GPa"

[[stages]]
name    = "A"
matrix  = "binder"
box     = "6 mm"
cells   = 12
filler  = { material = "hmx", fraction = 0.3, from = "0.6 mm", to = "1 mm", sizes = "sizes.csv", gap = "0.1 mm" }
packing = { method = "lubachevsky-stillinger", walls = true, seed = 1 }

[tests]
loads  = ["shear", "bulk"]
boundaries = ["displacement", "traction"]
times  = ["1 ms", "10 ms"]
points_per_decade = 3
fields = "none"

[[measurements]]
name  = "elsewhere"
shear = { curve = "measured.csv" }
times = ["1 us", "2 ms"]
)",
    R"([materials.m]
density = "1 g/cm^3"
bulk    = "1 MPa"
shear   = { terms = [{ time = "10 ms", modulus = "0.5 MPa" }, { time = "0.1 s", modulus = "50 kPa" }] }

[materials.p]
density = "1.5 g/cm^3"
bulk    = "50 MPa"
shear   = "18.8 MPa"

[[stages]]
name    = "A"
matrix  = "m"
box     = "6 mm"
cells   = [12, 24]
filler  = { material = "p", sizes = { diameter = "2 mm" } }
packing = { method = "regular", columns = 2, rows = 2 }

[[stages]]
name    = "B"
matrix  = "A"
box     = "20 mm"
resolution = "1.2 /mm"
filler  = { material = "p" }
packing = { method = "explicit", discs = "discs.csv" }

[tests]
loads = ["shear"]
times  = ["1 ms", "30 ms"]
solver = "stepping"
boundaries = ["periodic"]
volumetric = "standard"
points_per_decade = 4
quasistatic = { steps_per_decade = 4, linear = "direct" }
)",
    R"([materials.m]
density = "1 g/cm^3"
bulk    = "1 MPa"
shear   = { terms = [{ time = "10 ms", modulus = "0.5 MPa" }] }

[materials.p]
density = "1.5 g/cm^3"
bulk    = "50 MPa"
shear   = "18.8 MPa"

[[stages]]
name    = "A"
matrix  = "m"
box     = "6 mm"
cells   = 8
filler  = { material = "p", fraction = 0.2, from = "1 mm", to = "2 mm", sizes = { lognormal = [{ weight = 1, median = "1.4 mm", sigma = 0.5 }] }, gap = "0.1 mm" }
packing = { method = "lubachevsky-stillinger", walls = false }

[tests]
loads = ["shear"]
times  = ["1 ms", "10 ms"]
method = "dynamic"
boundaries = ["displacement"]
points_per_decade = 3
dynamic = { courant = 0.9, ramp_transits = 2, mass_scaling_factors = "auto", overlap = 1.5, reduction_tolerance = 0.01 }

[sweep]
"stages.A.packing.seed" = [1, 2]
)"};

/// Writes the files that the decks name.
void write_data(const test::TemporaryDirectory& directory) {
  directory.write("binder.csv", "relaxation_time_s,modulus_Pa\n1e-3,2e6\n1e-2,1e6\n");
  directory.write("sizes.csv", "diameter_m,cumulative_volume_fraction\n5e-4,0\n1e-3,0.5\n2e-3,1\n");
  directory.write("discs.csv", "x_m,y_m,diameter_m\n5e-3,5e-3,6e-3\n15e-3,15e-3,5e-3\n");
  directory.write("measured.csv", "time_s,modulus_Pa\n1e-6,1e9\n1e-2,1e6\n");
}

/// Limits the memory of the command, so that a deck that needs more fails and does not exhaust the machine.
class MemoryLimit {
 public:
  MemoryLimit() {
    getrlimit(RLIMIT_AS, &before_);
    // The address sanitizer reserves terabytes.
    if (!is_sanitized()) set({bytes, before_.rlim_max});
  }
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;
  MemoryLimit(MemoryLimit&&) = delete;
  MemoryLimit& operator=(MemoryLimit&&) = delete;
  ~MemoryLimit() { set(before_); }

 private:
  static constexpr rlim_t bytes = rlim_t{3} << 30U;
  static constexpr bool is_sanitized() {
#ifdef __SANITIZE_ADDRESS__
    return true;
#else
    return false;
#endif
  }
  static void set(const rlimit& limit) {
    setrlimit(RLIMIT_AS, &limit);
  }
  rlimit before_{};
};

/// Runs the command on the deck of a directory; the exit code is -1 if it takes longer than any of these decks may.
test::Outcome run(const fs::path& directory) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::seconds longest(20);
  const MemoryLimit limit;
  test::RunningCommand command(directory, {"run", "deck.toml", "--out", "out", "--threads", "1", "--quiet"});
  const auto end = Clock::now() + longest;
  if (command.reaches([end] { return Clock::now() > end; })) return {};
  return command.wait();
}

bool has_every_line(const std::string& text, const std::regex& form) {
  std::istringstream lines(text);
  std::string line;
  bool is_any = false;
  while (std::getline(lines, line)) {
    is_any = true;
    if (!std::regex_search(line, form)) return false;
  }
  return is_any;
}

/// The defects of the results of a study; empty if there are none.
std::string flaw_of_results(const fs::path& directory) {
  for (const auto* name : {"curves.csv", "prony.csv", "study.json", "report.html", "A/microstructure.svg"}) {
    if (!fs::exists(directory / name)) return std::string("no ") + name;
  }
  const auto curves = read_csv(directory / "curves.csv", {"stage", "load", "boundary", "method", "cells"});
  for (const double modulus : curves.numbers("modulus_Pa")) {
    if (!(modulus > 0.0) || !std::isfinite(modulus)) return "a modulus of " + std::to_string(modulus);
  }
  if (read_text(directory / "study.json").find("\"complete\": true") == std::string::npos) return "incomplete";
  return {};
}

/// The defects of the results of a study or of all tasks of a sweep; empty if there are none.
std::string flaw_of_all_results(const fs::path& directory) {
  if (!fs::exists(directory / "sweep.json")) return flaw_of_results(directory);
  std::string flaws;
  for (const auto& entry : fs::directory_iterator(directory)) {
    if (entry.is_directory()) flaws += flaw_of_results(entry.path());
  }
  return flaws;
}

/// The half-written files and empty directories among the results; empty if there are none.
std::string half_done(const fs::path& directory) {
  if (!fs::exists(directory)) return {};
  if (fs::is_empty(directory)) return directory.filename().string() + " is empty";
  for (const auto& entry : fs::recursive_directory_iterator(directory)) {
    if (entry.path().extension() == ".partial") return entry.path().filename().string();
    if (entry.is_directory() && fs::is_empty(entry.path())) return entry.path().filename().string() + " is empty";
  }
  return {};
}

/// The defects of a run; empty if there are none.
std::string flaw_of(const test::Outcome& outcome, const fs::path& results) {
  static const std::regex located(R"(^deck\.toml:\d+:\d+: )");
  switch (outcome.exit_code) {
    case 0:
      return flaw_of_all_results(results);
    case 2:
      if (!has_every_line(outcome.errors, located)) return "a mistake without a place";
      return fs::exists(results) ? "results of a deck that was refused" : "";
    case 3:
      if (outcome.errors.empty() || outcome.errors.find("internal") != std::string::npos) return "no reason";
      return half_done(results);
    default:
      return "exit code " + std::to_string(outcome.exit_code);
  }
}

int decks_to_try() {
  const char* wanted = std::getenv("BRECCIA_MUTATED_DECKS");
  return wanted != nullptr ? std::atoi(wanted) : 48;
}

TEST(MutatedDecks, RunWithoutTheirMistakes) {
  for (const auto* deck : decks) {
    const test::TemporaryDirectory directory;
    write_data(directory);
    directory.write("deck.toml", deck);
    const auto outcome = run(directory.path());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    EXPECT_EQ(flaw_of(outcome, directory.path() / "out"), "");
  }
}

TEST(MutatedDecks, AreRefusedWithTheirPlaceOrRun) {
  const auto& mutations = test::deck_mutations();
  std::map<std::string, std::map<int, int>> outcomes;  // number of runs by mutation and exit code
  std::mt19937_64 random(7);
  for (int i = 0; i < decks_to_try(); ++i) {
    const auto& [name, apply] = mutations[static_cast<std::size_t>(i) % mutations.size()];
    const std::string deck = decks[static_cast<std::size_t>(i) / mutations.size() % decks.size()];
    const test::TemporaryDirectory directory;
    write_data(directory);
    const auto mutated = apply(deck, random);
    directory.write("deck.toml", mutated);
    const auto outcome = run(directory.path());
    ++outcomes[name][outcome.exit_code];
    const auto flaw = flaw_of(outcome, directory.path() / "out");
    EXPECT_EQ(flaw, "") << name << ", " << outcome.errors << "\n" << mutated;
  }
  if (std::getenv("BRECCIA_MUTATED_DECKS") == nullptr) return;
  for (const auto& [name, codes] : outcomes) {
    std::printf("%-16s", name.c_str());
    for (const auto& [code, count] : codes) std::printf("  exit %d: %3d", code, count);
    std::printf("\n");
  }
}

}  // namespace
}  // namespace breccia
