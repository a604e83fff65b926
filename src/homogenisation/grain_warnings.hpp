#pragma once

#include <optional>
#include <string>
#include <vector>

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// A warning about films for which the model of grains and films is not made: films that are not long compared with
/// their thickness and, in space, resolved films of too few elements. Nothing for a stage without grains.
[[nodiscard]] std::optional<std::string> warning_of_films(const StageMicrostructure& packed, const FilmOptions& films);

/// Warnings about films that are debonded: more gaps than the model of films was held against resolved ones with, a
/// share that whole films do not give, and a direction. Nothing for a stage without grains.
[[nodiscard]] std::vector<std::string> warnings_of_debonding(const Stage& stage, const StageMicrostructure& packed,
                                                             const FilmOptions& films);

/// A warning about grains that are far smaller than the requested sizes, which are those of the cells: films take most
/// of the small cells. Nothing for a stage without grains.
[[nodiscard]] std::optional<std::string> warning_of_lost_grains(const Stage& stage, const StageMicrostructure& packed);

}  // namespace breccia
