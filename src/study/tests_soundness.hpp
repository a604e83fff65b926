#pragma once

#include "breccia/study/study.hpp"

#include "study/study_mistakes.hpp"

namespace breccia {

/// Checks the tests of a study, with the options of their methods.
void check_tests(const Tests& tests, StudyMistakes& mistakes);

/// Checks the elastic materials over whose moduli the tests sample.
void check_varied_materials(const Study& study, StudyMistakes& mistakes);

/// Checks the measurements of a study, which are compared with stages of it.
void check_measurements(const Study& study, StudyMistakes& mistakes);

}  // namespace breccia
