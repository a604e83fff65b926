// Example 6: a chain of three stages. Discs of three sizes are in a binder; each stage has those of one size in the
// mixture of the binder with all smaller ones (the paper's "dirty binder").
//
//   ex06_chain ex06_chain.toml
//
// The study is put together in C++, and read from the deck that says the same. Both are solved in the memory, to the
// same bits; `breccia run ex06_chain.toml` writes the same curves.csv.

#include <filesystem>
#include <string>

#include <fmt/format.h>

#include "breccia/deck/read_study.hpp"
#include "breccia/homogenisation/solve.hpp"
#include "breccia/results/curves.hpp"

using namespace breccia;

namespace {

/// Discs of one size, a quarter of a square box.
Stage stage_of(const std::string& name, const StageMatrix& matrix, double side, double diameter, double gap,
               std::uint64_t seed) {
  const Material grain = {"grain", 2000.0, PronySeries(20e9), PronySeries(10e9)};
  return {.name = name,
          .matrix = matrix,
          .side = side,
          .cells = 64,
          .fillers = {{.material = grain, .fraction = 0.25, .sizes = SingleSize{diameter}, .gap = gap}},
          .packing = LubachevskyStillingerPacking<2>{.seed = seed}};
}

Study chain() {
  const Material binder = {"binder", 1000.0, PronySeries(1e9), PronySeries(0.1e6, {{1.0, 1e6}, {0.01, 5e6}})};
  return {.stages = {stage_of("fine", binder, 80e-6, 11e-6, 2.5e-6, 1),
                     stage_of("middle", EarlierStage{"fine"}, 0.8e-3, 0.11e-3, 25e-6, 2),
                     stage_of("coarse", EarlierStage{"middle"}, 8e-3, 1.1e-3, 0.25e-3, 3)},
          .tests = {.first_time = 1e-3, .last_time = 10.0, .points_per_decade = 10}};
}

/// Are all curves of two results the same to the last bit?
bool are_same(const StudyResult& one, const StudyResult& other) {
  for (std::size_t s = 0; s < one.stages.size(); ++s) {
    const auto &tests = one.stages[s].tests, &others = other.stages[s].tests;
    for (std::size_t t = 0; t < tests.size(); ++t) {
      if (tests[t].id != others[t].id || tests[t].modulus != others[t].modulus) return false;
    }
  }
  return true;
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count != 2) {
    fmt::print(stderr, "usage: ex06_chain ex06_chain.toml\n");
    return 2;
  }
  const StudyResult result = solve(chain());
  fmt::print("G [MPa]   {:>15}  {:>15}\n{:8}  {:>7} {:>7}  {:>7} {:>7}\n", "at 1 ms", "at 10 s", "stage", "upper",
             "lower", "upper", "lower");
  for (const auto& stage : result.stages) {
    const auto& upper = preferred_test(stage.tests, Load::shear, Boundary::displacement).modulus;
    const auto& lower = preferred_test(stage.tests, Load::shear, Boundary::traction).modulus;
    fmt::print("{:8}  {:7.3f} {:7.3f}  {:7.4f} {:7.4f}\n", stage.name, upper.front().modulus / 1e6,
               lower.front().modulus / 1e6, upper.back().modulus / 1e6, lower.back().modulus / 1e6);
  }
  const bool is_same = are_same(result, solve(read_study(arguments[1])));
  fmt::print("\nThe deck gives the same bits: {}\n", is_same ? "yes" : "no");
  std::filesystem::create_directory("ex06_results");
  write_curves("ex06_results", result);
  return is_same ? 0 : 1;
}
