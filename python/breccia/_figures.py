"""Pictures of results on axes of Matplotlib, which is loaded for them alone."""

from __future__ import annotations

import importlib
from typing import Any, Callable

import numpy as np

from ._errors import InputError
from ._plot import COLOURS, Drawing


def draw(drawing: Drawing, ax: Any = None, label: str | None = None) -> Any:
    """Draws curves and bands on axes of Matplotlib, new ones by default, and returns the axes.

    Both axes become logarithmic; they are named by the quantity and the SI unit. label: begins the labels of what was
    computed, with colours that follow those on the axes; what is there already under its label, such as the binder, is
    not drawn again. Raises InputError where there is nothing to draw, for what are no axes, and without Matplotlib.
    """
    if not drawing.curves:
        raise InputError("plot: there is no curve to draw")
    if ax is None:
        try:
            pyplot = importlib.import_module("matplotlib.pyplot")
        except ImportError:
            raise InputError("plot: Matplotlib is not installed; svg() draws without it") from None
        ax = pyplot.subplots()[1]
    if not callable(getattr(ax, "fill_between", None)):
        raise InputError(f"plot: ax: expected axes of Matplotlib, got {ax!r}")
    present = {line.get_label() for line in ax.get_lines()}
    offset = 0 if label is None else sum(line.get_linestyle() == "-" for line in ax.get_lines())
    for band in drawing.bands:
        ax.fill_between(band.x, band.low, band.high, color=COLOURS[(band.colour + offset) % len(COLOURS)], alpha=0.14, linewidth=0)
    for curve in drawing.curves:
        is_computed = not curve.marks and not curve.dashes
        if label is not None and curve.label in present and not is_computed:
            continue
        name = f"{label}, {curve.label}" if label is not None and is_computed else curve.label
        colour = COLOURS[(curve.colour + (offset if is_computed else 0)) % len(COLOURS)]
        shown = np.isfinite(curve.y) & (curve.y > 0) & (curve.x > 0)
        style: dict[str, Any] = {"marker": "o", "linestyle": "none", "fillstyle": "none", "markersize": 4} if curve.marks else {
            "linestyle": "--" if curve.dashes else "-"}
        ax.plot(curve.x[shown], curve.y[shown], color=colour, label=name, **style)
    ax.set(xscale="log", yscale="log", xlabel=drawing.abscissa, ylabel=f"{drawing.ordinate} / {drawing.quotable_unit}")
    ax.legend(frameon=False)
    return ax


def plot_by(drawing_of: Callable[[Any], Drawing]) -> Callable[..., Any]:
    """The method plot() of a class of which drawing_of() has the curves."""

    def plot(self: Any, ax: Any = None, label: str | None = None) -> Any:
        """Draws it on axes of Matplotlib, new ones by default, and returns the axes. label: a name for it where several
        are on the axes. Raises InputError where there is nothing to draw, and without Matplotlib."""
        return draw(drawing_of(self), ax, label)

    return plot
