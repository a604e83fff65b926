#pragma once

#include <vector>

#include <pybind11/pybind11.h>

#include "breccia/homogenisation/study_result.hpp"

namespace breccia::python {

// The fields of a test for pickle.
pybind11::list state_of_fields(const std::vector<TimedFields<2>>& all);
pybind11::list state_of_fields(const std::vector<TimedFields<3>>& all);
pybind11::list state_of_fields(const std::vector<TimedFilmFields>& all);
template <int dim>
std::vector<TimedFields<dim>> fields_from(const pybind11::list& states);
std::vector<TimedFilmFields> film_fields_from(const pybind11::list& states);

}  // namespace breccia::python
