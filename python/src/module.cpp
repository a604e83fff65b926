#include <pybind11/pybind11.h>

#include "assessments.hpp"
#include "calculations.hpp"
#include "calibrations.hpp"
#include "complex_moduli.hpp"
#include "engineering.hpp"
#include "errors.hpp"
#include "exports.hpp"
#include "fits.hpp"
#include "master_curves.hpp"
#include "materials.hpp"
#include "measured.hpp"
#include "plans.hpp"
#include "quantities.hpp"
#include "results.hpp"
#include "stored_results.hpp"
#include "studies.hpp"

PYBIND11_MODULE(_native, module) {
  namespace python = breccia::python;
  module.doc() = "The library libbreccia, as the package breccia wraps it.";
  module.attr("__version__") = BRECCIA_VERSION;
  python::translate_errors();
  python::bind_quantities(module);
  python::bind_materials(module);
  python::bind_fits(module);
  python::bind_master_curves(module);
  python::bind_measured(module);
  python::bind_studies(module);
  python::bind_complex_moduli(module);
  python::bind_engineering(module);
  python::bind_results(module);
  python::bind_calculations(module);
  python::bind_calibrations(module);
  python::bind_assessments(module);
  python::bind_plans(module);
  python::bind_exports(module);
  python::bind_stored_results(module);
}
