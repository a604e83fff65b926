#include "homogenisation/plan/film_error.hpp"

#include <algorithm>
#include <cmath>

#include "discretisation/contrast.hpp"
#include "homogenisation/run/test_requests.hpp"
#include "homogenisation/stage_materials.hpp"
#include "study/test_rules.hpp"

namespace breccia {
namespace {

/// The rule of the plane, by the thickness of the films over the root of the mean area of the cells.
std::optional<double> error_in_the_plane(double face_share, double film) {
  constexpr double coarsest = 0.3, finest = 0.15, thickest = 0.12;
  if (face_share > coarsest || film > thickest) return std::nullopt;
  const double elements = std::max(face_share, finest) / coarsest, thin = 0.02;
  return 0.052 * elements * elements / (1.0 + film * film / (thin * thin)) + 0.3 * film;
}

/// The rule of space, by the number of elements along an edge and the thickness over the root of the mean volume.
std::optional<double> error_in_space(int divisions, double film) {
  constexpr double thinnest = 0.005, thickest = 0.05;
  if (film < thinnest || film > thickest) return std::nullopt;
  return divisions == 1 ? 0.08 : 0.04;
}

bool has_film_shares(const Stage& stage) {
  const auto* const method = stage.packed_by<LaguerrePacking<2>>();
  return method != nullptr && !method->film_shares.empty();
}

}  // namespace

std::optional<double> film_error(const Study& study, const Stage& stage, const StageMicrostructure& packed) {
  const auto* const grains = packed.grains();
  if (model_of(study.tests, stage) != Model::films || grains == nullptr) return std::nullopt;
  const auto& films = study.tests.films;
  if (films.layers || stage.bonds || !stage.is_periodic() || has_film_shares(stage)) return std::nullopt;
  constexpr double widest = 12.0;
  for (const auto& filler : packed.fillers) {
    if (filler.largest_diameter > widest * filler.smallest_diameter.value_or(0.0)) return std::nullopt;
  }
  if (!are_stiffer_than_matrix(materials_of(stage, expected_matrix(study, stage)))) return std::nullopt;
  const double film =
      grains->film / stage.side * std::pow(static_cast<double>(grains->cell_count), 1.0 / stage.dimensions());
  return stage.dimensions() == 3 ? error_in_space(films.divisions, film) : error_in_the_plane(films.face_share, film);
}

}  // namespace breccia
