#pragma once

#include <vector>

#include "breccia/viscoelasticity/shifted_material.hpp"

#include "results/composite.hpp"
#include "results/study_document.hpp"

namespace breccia {

/// The materials of a study from its record.
std::vector<ShiftedMaterial> materials_of(const StudyDocument& document);

/// The content of a study, apart from its moduli, from its record.
StudyContent content_of(const StudyDocument& document);

}  // namespace breccia
