#pragma once

#include <pybind11/pybind11.h>

namespace breccia::python {

/// Translates the errors of the library to the exceptions of `breccia._errors`, with advice for Python added to their
/// messages.
void translate_errors();

}  // namespace breccia::python
