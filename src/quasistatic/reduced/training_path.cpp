#include "quasistatic/reduced/training_path.hpp"

#include "breccia/quasistatic/reduced_response.hpp"

namespace breccia {

TrainingPath matrix_path(PhaseIndex matrix, std::span<const Moduli> moduli) {
  TrainingPath path = {.phases = {{matrix, std::string(name_of_matrix_phase)}}, .points = {}};
  for (const auto& point : moduli) path.points.push_back({point});
  return path;
}

}  // namespace breccia
