"""Pictures of results on axes of Matplotlib, which is loaded for them alone."""

from __future__ import annotations

import importlib
from typing import Any, Callable

import numpy as np

from ._errors import InputError
from ._plot import COLOURS, Drawing


def draw(drawing: Drawing, ax: Any = None) -> Any:
    """Draws curves and bands on axes of Matplotlib, new ones by default, and returns the axes.

    Both axes become logarithmic; labels have the quantity and the SI unit. Raises InputError where there is nothing to
    draw, and where Matplotlib is not installed.
    """
    if not drawing.curves:
        raise InputError("plot: there is no curve to draw")
    if ax is None:
        try:
            pyplot = importlib.import_module("matplotlib.pyplot")
        except ImportError:
            raise InputError("plot: Matplotlib is not installed; svg() draws without it") from None
        ax = pyplot.subplots()[1]
    for band in drawing.bands:
        ax.fill_between(band.x, band.low, band.high, color=COLOURS[band.colour % len(COLOURS)], alpha=0.14, linewidth=0)
    for curve in drawing.curves:
        shown = np.isfinite(curve.y) & (curve.y > 0) & (curve.x > 0)
        style: dict[str, Any] = {"marker": "o", "linestyle": "none", "fillstyle": "none", "markersize": 4} if curve.marks else {
            "linestyle": "--" if curve.dashes else "-"}
        ax.plot(curve.x[shown], curve.y[shown], color=COLOURS[curve.colour % len(COLOURS)], label=curve.label, **style)
    ax.set(xscale="log", yscale="log", xlabel=drawing.abscissa, ylabel=f"{drawing.ordinate} / {drawing.quotable_unit}")
    ax.legend(frameon=False)
    return ax


def plot_by(drawing_of: Callable[[Any], Drawing]) -> Callable[..., Any]:
    """The method plot() of a class of which drawing_of() has the curves."""

    def plot(self: Any, ax: Any = None) -> Any:
        """Draws it on axes of Matplotlib, new ones by default, and returns the axes. Raises InputError where there is
        nothing to draw, and without Matplotlib."""
        return draw(drawing_of(self), ax)

    return plot
