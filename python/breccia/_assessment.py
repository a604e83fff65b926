"""What the uncertainty of the inputs of a study makes of its results."""

from __future__ import annotations

import html
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._calculations import checked, solve
from ._calibration import Calibration, Files, calibration_of, paths_of, require_shares
from ._progress import Progress
from ._study import Study


@dataclass(frozen=True)
class AssessedCurve:
    """A curve with its uncertainty; all arrays run over its times or frequencies."""

    name: str  #: "G", "K + G/3", "|G*|", "phase of G*"
    unit: str  #: "Pa", "rad"
    at: NDArray[np.float64]  #: times [s] or angular frequencies [rad/s]
    reference: NDArray[np.float64]  #: with the median of each input
    median: NDArray[np.float64]
    inputs: tuple[NDArray[np.float64], NDArray[np.float64]]  #: ends of 95 % by the inputs alone
    error: NDArray[np.float64]  #: of the model, over the modulus; NaN where it is not known
    whole: tuple[NDArray[np.float64], NDArray[np.float64]]  #: ends of 95 % with it; NaN where it is not known
    alone: dict[str, NDArray[np.float64]]  #: share of each input alone in the variance (first-order index)
    total: dict[str, NDArray[np.float64]]  #: its share with others (total index)
    interactions: NDArray[np.float64]  #: share of all inputs together, beyond what each causes alone
    unexplained: NDArray[np.float64]  #: share of the variance that polynomials in the inputs do not predict


@dataclass(frozen=True)
class Assessment:
    """What assess() has found."""

    curves: dict[str, AssessedCurve]  #: by their names
    inputs: list[str]  #: the uncertain inputs, by the paths of their keys
    samples: int
    boxes: int
    reference: _native.Result  #: the result with the median of each input
    calibration: Calibration | None  #: the inputs as measurements show them
    warnings: list[str]

    def __getitem__(self, name: str) -> AssessedCurve:
        return self.curves[name]

    def _repr_html_(self) -> str:
        tables = "".join(_table(curve) for curve in self.curves.values())
        warnings = "".join(f"<div>{html.escape(text)}</div>" for text in self.warnings)
        found = "" if self.calibration is None else self.calibration._repr_html_()
        return f"<div>{tables}<div>{self.samples} samples in {self.boxes} box(es)</div>{warnings}{found}</div>"


def assess(study: Study, *, samples: int = 1000, boxes: int = 0, seed: int = 1, stage: str | None = None,
           measured: Files = (), modulus: str | None = None, noise: float | None = None,
           model_error: float | None = None, threads: int = 0, progress: Progress = None) -> Assessment:
    """Carries the uncertainty of the inputs of a study through to its curves.

    Inputs that are not certain are distributions in the study, such as shear={"value": 5.8e9, "sd": 0.6e9}; samples:
    number of samples of all inputs; boxes: number of boxes where inputs change the box, 0 for as many as they need;
    seed: of the samples; stage: the one that is assessed, the last one unless told. measured: the file or the files of
    what was measured of the composite, from which the inputs are found; modulus, noise, model_error: as of calibrate().
    No file is written. Raises InputError and NumericalError.
    """
    require_shares(noise=noise, model_error=model_error)
    asked = deck_assessment(study, samples, boxes, seed)
    name = asked.stage_named(stage or "")
    data = asked.measured(paths_of(measured), modulus, noise, model_error)
    solved = [solve(Study._of(one, study._deck_path or ""), threads=threads, progress=progress) for one in asked.studies]
    found = asked.assess(solved, data, name, threads)
    curves = [AssessedCurve(**one) for one in found.pop("curves")]
    calibration = found.pop("calibration")
    return Assessment(curves={curve.name: curve for curve in curves}, reference=solved[0],
                      calibration=None if calibration is None else calibration_of(calibration), **found)


def deck_assessment(study: Study, samples: int, boxes: int, seed: int) -> _native.DeckAssessment:
    """The assessment of a study whose inputs are not all certain."""
    source = checked(study)
    return _native.DeckAssessment(study._deck_path, source.deck, study._directory, source.overrides, samples, boxes, seed)


def _table(curve: AssessedCurve) -> str:
    names = "".join(f"<th>{html.escape(name.split('.', 1)[-1])}</th>" for name in curve.alone)
    rows = "".join(_row(curve, i) for i in _decades(curve.at))
    return (f"<table><caption>{html.escape(curve.name)}</caption><tr><th>at</th><th>median</th><th>95 % by the inputs</th>"
            f"<th>and with the model</th>{names}</tr>{rows}</table>")


def _row(curve: AssessedCurve, i: int) -> str:
    known = not np.isnan(curve.whole[0][i])
    whole = f"{curve.whole[0][i]:.4g} to {curve.whole[1][i]:.4g}" if known else "not known"
    shares = "".join(f"<td>{100 * share[i]:.0f} %</td>" for share in curve.alone.values())
    return (f"<tr><td>{curve.at[i]:.3g}</td><td>{curve.median[i]:.4g} {curve.unit}</td>"
            f"<td>{curve.inputs[0][i]:.4g} to {curve.inputs[1][i]:.4g}</td><td>{whole}</td>{shares}</tr>")


def _decades(at: NDArray[np.float64]) -> list[Any]:
    """The indices of the values nearest to whole decades, and of the ends."""
    decades = np.arange(np.ceil(np.log10(at[0]) - 1e-9), np.log10(at[-1]) + 1e-9)
    indices = {0, len(at) - 1, *(int(np.argmin(np.abs(np.log10(at) - decade))) for decade in decades)}
    return sorted(indices)
