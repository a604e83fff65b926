// The checkpoint from which a run resumes. An input that begins with a slash lists the numbers of a state, which is
// written as a run writes it, with its checksum, and then read by all readers of states. Any other input stands for the
// bytes of the file: they must be refused before the HDF5 library sees them, which is known to crash on hostile files.

#include <sstream>
#include <stdexcept>

#include "breccia/microstructure/packing.hpp"
#include "breccia/microstructure/validity.hpp"
#include "breccia/quasistatic/quasistatic_problem.hpp"

#include "checkpoint/state.hpp"
#include "discretisation/point_fields_state.hpp"
#include "homogenisation/box/packing_state.hpp"
#include "homogenisation/box/stage_microstructure_state.hpp"
#include "input_folder.hpp"
#include "refusal.hpp"
#include "virtual_test/dynamic_state.hpp"
#include "virtual_test/quasistatic_test_state.hpp"

namespace {

using namespace breccia;

/// Lines `/name i 1` and `/name d 0.5 1e3 ...` and `/name t word`.
void write_state(const std::filesystem::path& path, std::string_view text) {
  StateWriter state(path, {"0123456789abcdef", "1.0"});
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string name, word;
    char kind = 'd';
    words >> name >> kind;
    if (kind == 'i') {
      std::int64_t value = 0;
      words >> value;
      state.write(name, value);
    } else if (kind == 't') {
      words >> word;
      state.write(name, word);
    } else {
      std::vector<double> values;
      for (double value = 0.0; words >> value;) values.push_back(value);
      state.write(name, values);
    }
  }
  state.commit();
}

/// Two discs grow on from the state. If they reach their size, their positions must be possible ones.
void go_on_packing(const StateReader& state, Walls walls) {
  PackingRun<2> run({1e-3, walls, {1e-4, 2e-4}}, read_packing_state<2>(state));
  try {
    for (int epoch = 0; epoch < 20 && !run.is_done(); ++epoch) run.advance();
    if (run.is_done()) require_valid<2>({1e-3, walls, run.packing().balls});
  } catch (const NumericalError&) {
    // The discs may jam.
  } catch (const InputError& error) {
    throw std::logic_error(error.what());
  }
}

void read_all(const StateReader& state) {
  static const Discretisation<2> two_cells(Grid<2>{{2, 1}, 1e-3});
  static const Stage two_fillers = {
      .name = "stage", .matrix = {}, .side = 1e-3, .cells = 2, .fillers = {Filler(), Filler()}};
  const auto read = [](const auto& action) { fuzz::allow_refusal([&] { static_cast<void>(action()); }); };
  read([&] { return read_stage_microstructure(state, two_fillers); });
  read([&] { return read_quasistatic_result(state); });
  read([&] { return read_domains(state); });
  read([&] { return read_domain(state, "/running"); });
  read([&] { return read_fields(state, "/fields", two_cells, two_cells.grid().all_cells()); });
  read([&] { return state.text("/field_file/0/file"); });
  fuzz::allow_refusal([&] { go_on_packing(state, Walls::hard); });
  fuzz::allow_refusal([&] { go_on_packing(state, Walls::periodic); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {  // NOLINT(*-naming)
  static const fuzz::InputFolder folder;
  const auto text = fuzz::text_of(data, size);
  const auto path = folder.path() / "state.h5";
  if (!text.starts_with('/')) {
    folder.write("state.h5", text);
    fuzz::allow_refusal([&] { read_all(StateReader(path)); });
    return 0;
  }
  bool is_written = false;
  fuzz::allow_refusal([&] {
    write_state(path, text);
    is_written = true;
  });
  if (is_written) read_all(StateReader(path));
  return 0;
}
