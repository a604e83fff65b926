#include "dynamics/instruction_set.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

constexpr std::array known_sets = {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512};

#ifdef BRECCIA_X86_KERNELS
bool is_supported(InstructionSet set) {
  switch (set) {
    case InstructionSet::baseline:
      return true;
    case InstructionSet::avx2:
      return __builtin_cpu_supports("avx2") != 0;
    case InstructionSet::avx512:
      return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
             __builtin_cpu_supports("avx512vl") != 0;
  }
  return false;
}
#else
bool is_supported(InstructionSet set) {
  return set == InstructionSet::baseline;
}
#endif

}  // namespace

std::string_view name_of(InstructionSet set) {
  switch (set) {
    case InstructionSet::baseline:
      return "baseline";
    case InstructionSet::avx2:
      return "avx2";
    case InstructionSet::avx512:
      return "avx512";
  }
  return {};
}

std::vector<InstructionSet> supported_instruction_sets() {
  std::vector<InstructionSet> sets;
  std::ranges::copy_if(known_sets, std::back_inserter(sets), is_supported);
  return sets;
}

InstructionSet chosen_instruction_set() {
  const auto supported = supported_instruction_sets();
  const char* wanted = std::getenv("BRECCIA_INSTRUCTION_SET");
  if (wanted == nullptr) return supported.back();
  // The name is qualified because another one may be declared where several sources are compiled as one.
  const auto found = std::ranges::find_if(supported, [&](InstructionSet set) { return name_of(set) == wanted; });
  if (found != supported.end()) return *found;
  throw InputError(fmt::format(
      "BRECCIA_INSTRUCTION_SET: expected baseline, avx2 or avx512, and one that this processor has, got '{}'", wanted));
}

}  // namespace breccia
