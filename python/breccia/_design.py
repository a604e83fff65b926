"""The value of an input by which a composite has what is wanted."""

from __future__ import annotations

import html
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._assessment import deck_assessment
from ._calculations import solve
from ._calibration import require_shares
from ._errors import InputError
from ._progress import Progress
from ._study import Study


@dataclass(frozen=True)
class FoundInput:
    """What find() has found, in SI units."""

    value: float  #: with the medians of the other inputs
    text: str  #: the value to four digits, as a deck has it: "0.5073", "131.2 MPa"
    interval: tuple[float, float]  #: ends of 95 %; infinite for an end beyond the range that was searched
    inputs: NDArray[np.float64] = field(repr=False)  #: values over the range of the input
    values: NDArray[np.float64] = field(repr=False)  #: what the composite has with these, and the medians of the others
    band: tuple[NDArray[np.float64], NDArray[np.float64]] = field(repr=False)  #: ends of 95 % of that
    reached: float  #: what the study with the value has
    result: _native.Result = field(repr=False)  #: the result of that study
    warnings: list[str]

    def _repr_html_(self) -> str:
        lower, upper = self.interval
        warnings = "".join(f"<div>{html.escape(text)}</div>" for text in self.warnings)
        return (f"<div><b>{html.escape(self.text)}</b> (95 %: {lower:.4g} to {upper:.4g}); the study with it has "
                f"{self.reached:.4g}</div>{warnings}")


def find(study: Study, key: str, so_that: str, *, samples: int = 1000, boxes: int = 0, seed: int = 1,
         stage: str | None = None, model_error: float | None = None, threads: int = 0,
         progress: Progress = None) -> FoundInput:
    """Finds the value of an input by which a composite has what is wanted.

    key: the input, the path of a value in the deck of the study or its last steps, such as "fraction"; in the study it
    is a range to search, such as {"from": 0.4, "to": 0.6}, beside which other inputs may be uncertain; so_that: the
    condition, such as "G(1 ms) = 3 GPa" or "tan_delta(10 Hz) = 0.3"; model_error: error of the moduli of the study as a
    share, the one that it states unless told; samples, boxes, seed, stage: as of assess(). No file is written. Raises
    InputError, also where no value serves and where several do, and NumericalError.
    """
    require_shares(model_error=model_error)
    for argument, text in {"key": key, "so_that": so_that}.items():
        if not isinstance(text, str):
            raise InputError(f"{argument}: expected a text, got {text!r}")
    asked = deck_assessment(study, samples, boxes, seed)
    name = asked.stage_named(stage or "")
    sought = asked.sought(key, so_that, model_error)
    solved = [solve(Study._of(one, study._deck_path or ""), threads=threads, progress=progress) for one in asked.studies]
    found = asked.find(solved, sought, name, threads)
    chosen = Study._of(asked.study_with(sought, found), study._deck_path or "")
    result = solve(chosen, threads=threads, progress=progress)
    reached = asked.value_of(result, name, sought)
    doubt = asked.doubt_on(sought, found, reached)
    return FoundInput(value=found.value, text=asked.text_of(sought, found), interval=found.interval, **found.points,
                      reached=reached, result=result, warnings=found.warnings + ([doubt] if doubt else []))
