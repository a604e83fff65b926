#pragma once

#include <vector>

#include "breccia/viscoelasticity/shifted_material.hpp"

#include "results/composite.hpp"
#include "results/study_document.hpp"

namespace breccia {

/// The materials of a study from its record.
std::vector<ShiftedMaterial> materials_of(const StudyDocument& document);

/// What is known of a study beside its moduli.
StudyContent content_of(const StudyDocument& document);

}  // namespace breccia
