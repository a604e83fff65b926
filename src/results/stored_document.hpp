#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "breccia/viscoelasticity/shifted_material.hpp"

#include "results/composite.hpp"
#include "results/study_document.hpp"

namespace breccia {

/// A warning if the run that left these results in a directory is not complete, so that finer grids, other tests or
/// later stages may be missing; otherwise nothing.
std::optional<std::string> note_on_completeness(const std::filesystem::path& directory, const StudyDocument& document);

/// The materials of a study from its record.
std::vector<ShiftedMaterial> materials_of(const StudyDocument& document);

/// The content of a study, apart from its moduli, from its record.
StudyContent content_of(const StudyDocument& document);

}  // namespace breccia
