// Runs a fuzz target without libFuzzer: over every file of a corpus, and over mutations of these files that are the
// same each time. An input that fails is left in the file `failed-input`.
//
//   deck_fuzzer CORPUS [MUTATIONS]

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include "io/text_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);  // NOLINT(*-naming)

namespace {

using Random = std::mt19937_64;

/// The present input of the target, for the handler of signals.
std::string input;

void keep_failed_input(int) {
  const int file = open("failed-input", O_WRONLY | O_CREAT | O_TRUNC, 0644);
  const bool is_kept = file >= 0 && write(file, input.data(), input.size()) == static_cast<ssize_t>(input.size());
  static_cast<void>(is_kept);
  _exit(1);
}

void run(std::string text) {
  input = std::move(text);
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

std::vector<std::string> read_corpus(const std::filesystem::path& directory) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) files.push_back(entry.path());
  std::ranges::sort(files);  // the same on every machine
  std::vector<std::string> corpus;
  corpus.reserve(files.size());
  for (const auto& file : files) corpus.push_back(breccia::read_text(file));
  return corpus;
}

std::size_t below(std::size_t bound, Random& random) {
  return static_cast<std::size_t>(random() % bound);
}

/// A few lines of a text, or a few letters of one line.
std::string_view piece_of(std::string_view text, Random& random) {
  if (text.empty()) return text;
  const auto begin = below(text.size(), random);
  const bool is_of_lines = below(2, random) == 0;
  const auto end = is_of_lines ? text.find('\n', begin) : begin + 1 + below(12, random);
  return text.substr(begin, end == std::string_view::npos ? end : end - begin);
}

constexpr std::array<std::string_view, 16> awkward = {
    "",  "0", "-1", "1e308", "1e-320", "nan", "inf", "\"", "[[]", "\xff.", "\n[", "= ", "-9223372036854775808",
    "*", "/", ",,"};

std::string mutated(std::string text, const std::vector<std::string>& corpus, Random& random) {
  const auto changes = 1 + below(4, random);
  for (std::size_t change = 0; change < changes; ++change) {
    const auto at = below(text.size() + 1, random);
    const auto& other = corpus[below(corpus.size(), random)];
    switch (below(5, random)) {
      case 0:
        if (at < text.size())
          text[at] = static_cast<char>(static_cast<unsigned char>(text[at]) ^ (1U << below(8, random)));
        break;
      case 1:
        text.erase(at, piece_of(std::string_view(text).substr(at), random).size());
        break;
      case 2:
        text.insert(at, std::string(piece_of(text, random)));
        break;
      case 3:
        text.insert(at, std::string(piece_of(other, random)));
        break;
      default:
        text.replace(at, below(6, random), awkward[below(awkward.size(), random)]);
    }
  }
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("usage: ..._fuzzer CORPUS [MUTATIONS]\n", stderr);
    return 2;
  }
  for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL}) std::signal(signal, keep_failed_input);
  const auto corpus = read_corpus(argv[1]);
  const auto mutations = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 0;
  for (const auto& text : corpus) run(text);
  Random random(1);
  for (std::size_t i = 0; i < mutations; ++i) run(mutated(corpus[i % corpus.size()], corpus, random));
  std::printf("%zu inputs and %lu mutations\n", corpus.size(), mutations);
  return 0;
}
