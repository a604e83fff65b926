#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "breccia/discretisation/phase.hpp"
#include "breccia/viscoelasticity/material.hpp"

namespace breccia {

/// The phases of a microstructure by their names, such as "matrix" and "filler". The position of a phase in this list
/// is the PhaseIndex of its material points, and its position in every list "by PhaseIndex". Two phases may be of one
/// material.
class Phases {
 public:
  /// Throws InputError when a name is empty or occurs twice, or when there are more phases than a PhaseIndex can
  /// number.
  explicit Phases(std::vector<std::string> names);

  [[nodiscard]] std::size_t size() const noexcept { return names_.size(); }
  /// The names, by PhaseIndex.
  [[nodiscard]] const std::vector<std::string>& names() const noexcept { return names_; }

  /// The PhaseIndex of the phase with this name. Throws InputError when there is none.
  [[nodiscard]] PhaseIndex index_of(std::string_view name) const;

  /// Materials given by the names of their phases, as a list by PhaseIndex. Throws InputError when a phase has no
  /// material, and when a name is not the name of a phase.
  [[nodiscard]] std::vector<Material> materials(const std::map<std::string, Material>& by_phase) const;

 private:
  std::vector<std::string> names_;
};

}  // namespace breccia
