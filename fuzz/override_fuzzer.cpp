// Arguments of `--set` on the command line, one a line, and after a "~" arguments of `--sweep`.

#include <string>
#include <vector>

#include "input_folder.hpp"
#include "refusal.hpp"
#include "study_reading.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {  // NOLINT(*-naming)
  using namespace breccia::fuzz;
  static const InputFolder folder;
  std::vector<std::string> overrides, swept;
  for (auto text = text_of(data, size); !text.empty();) {
    const auto line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (line.starts_with('~')) {
      swept.emplace_back(line.substr(1));
    } else {
      overrides.emplace_back(line);
    }
  }
  allow_refusal([&] { read_deck(folder.path() / "fixed.toml", overrides, swept); });
  return 0;
}
