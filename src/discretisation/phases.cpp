#include "breccia/discretisation/phases.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

namespace breccia {

Phases::Phases(std::vector<std::string> names) : names_(std::move(names)) {
  if (names_.size() > no_phase) {
    throw InputError(fmt::format("phases: expected at most {}, got {}", no_phase, names_.size()));
  }
  for (auto name = names_.begin(); name != names_.end(); ++name) {
    if (name->empty()) throw InputError("phases: expected a name for each phase, got an empty one");
    if (std::find(names_.begin(), name, *name) != name) {
      throw InputError(fmt::format("phases: two phases are called \"{}\"", *name));
    }
  }
}

PhaseIndex Phases::index_of(std::string_view name) const {
  const auto found = std::ranges::find(names_, name);
  if (found == names_.end()) {
    throw InputError(
        fmt::format("phases: no phase is called \"{}\"; the phases are: {}", name, fmt::join(names_, ", ")));
  }
  return static_cast<PhaseIndex>(std::distance(names_.begin(), found));
}

std::vector<Material> Phases::materials(const std::map<std::string, Material>& by_phase) const {
  for (const auto& [name, material] : by_phase) static_cast<void>(index_of(name));
  std::vector<Material> materials;
  for (const auto& name : names_) {
    const auto found = by_phase.find(name);
    if (found == by_phase.end()) throw InputError(fmt::format("phases: expected a material for the phase {}", name));
    materials.push_back(found->second);
  }
  return materials;
}

}  // namespace breccia
