"""Relaxation moduli of highly filled composites from their constituents.

    study  = breccia.read_study("deck.toml", {"stages.0.cells": 96})
    result = breccia.solve(study)
    time, modulus = result["model"].curve(load="shear", boundary="displacement")

Numbers are in SI units: m, s, Pa, kg/m^3, K, rad/s. Where a deck takes a quantity, text with a unit is accepted, too.
"""

import atexit as _atexit
import os as _os

# Threads that wait for others sleep after a few microseconds instead of a millisecond, in which they would keep the
# threads of other programs from the cores. libgomp reads this when it is loaded, by _native if not by another module
# before.
_says_nothing = not {"OMP_WAIT_POLICY", "GOMP_SPINCOUNT"} & set(_os.environ)
if _says_nothing:
    _os.environ["GOMP_SPINCOUNT"] = "1000"

from . import _drawings, _errors, _figures, _html, _native, _plot, _signatures, _tables

if _says_nothing:
    del _os.environ["GOMP_SPINCOUNT"]

from ._assessment import AssessedCurve, Assessment, assess
from ._calculations import pack, plan, respond, run, solve
from ._calibration import Calibration, Estimate, calibrate
from ._design import FoundInput, find
from ._errors import Error, FileError, InputError, Interrupted, NumericalError
from ._exports import Isochrone, export, isochrone
from ._fits import fit, fit_creep, fit_dynamic, master_curve, read_measured, read_sweeps
from ._materials import Material
from ._native import (
    ComplexEngineeringModuli,
    ComplexModuli,
    CreepCompliance,
    CreepFit,
    EngineeringModuli,
    MasterCurve,
    Microstructure,
    Plan,
    PronySeries,
    RelaxationFit,
    Result,
    Solid,
    StagePlan,
    StageResult,
    TestPlan,
    TestResult,
    WilliamsLandelFerry,
    __version__,
    quantity,
)
from ._stages import Coating, Filler, Image, Packing, Stage
from ._stored import read_results, read_sweep_results
from ._study import Measurement, Study, Tests, read_study, read_sweep

__all__ = [
    "AssessedCurve", "Assessment", "Calibration", "Coating", "ComplexEngineeringModuli", "ComplexModuli", "CreepCompliance", "CreepFit", "EngineeringModuli",
    "Error", "Estimate", "FileError", "Filler", "FoundInput", "Image",
    "InputError", "Interrupted", "Isochrone", "MasterCurve", "Material", "Measurement", "Microstructure",
    "NumericalError", "Packing", "Plan", "PronySeries", "RelaxationFit", "Result", "Solid", "Stage", "StagePlan",
    "StageResult", "Study", "TestPlan", "TestResult", "Tests", "WilliamsLandelFerry",
    "assess", "calibrate", "export", "find", "fit", "fit_creep", "fit_dynamic", "isochrone", "master_curve", "pack", "plan", "quantity",
    "read_measured", "read_results", "read_study", "read_sweep", "read_sweep_results", "read_sweeps", "respond", "run",
    "solve",
]

# The classes of the library are public under the name of this package, also for pickle.
for _name in __all__:
    _object = globals()[_name]
    if getattr(_object, "__module__", "").startswith("breccia."):
        _object.__module__ = "breccia"

_signatures.show_signatures()
for _class, _drawing in _drawings.DRAWINGS.items():
    setattr(_class, "plot", _figures.plot_by(_drawing))
    setattr(_class, "svg", _plot.svg_by(_drawing))
setattr(Result, "_repr_svg_", Result.svg)
setattr(StageResult, "_repr_svg_", StageResult.svg)
setattr(Result, "table", _tables.result_table)
setattr(StageResult, "table", _tables.stage_table)
setattr(Result, "_ipython_key_completions_", _tables.names_of_stages)
setattr(Plan, "_ipython_key_completions_", _tables.names_of_stages)
setattr(Result, "_repr_html_", _html.result_html)
setattr(StageResult, "_repr_html_", _html.stage_html)
setattr(TestResult, "_repr_html_", _html.test_html)
setattr(ComplexModuli, "_repr_html_", _html.complex_html)
setattr(EngineeringModuli, "_repr_html_", _html.engineering_html)
setattr(PronySeries, "_repr_html_", _html.series_html)
setattr(RelaxationFit, "_repr_html_", _html.relaxation_fit_html)
setattr(CreepFit, "_repr_html_", _html.creep_fit_html)
setattr(MasterCurve, "_repr_html_", _html.master_curve_html)
setattr(Microstructure, "_repr_html_", _html.microstructure_html)
setattr(Microstructure, "_repr_svg_", Microstructure.svg)

# Calculations of other threads are ended first, then MPI and PETSc, where one has started them; a host program ends what
# it has started itself.
_atexit.register(_native.stop_parallel)
