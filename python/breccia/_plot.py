"""Plots of moduli as SVG: logarithmic or linear axes, a band between bounds, no library."""

from __future__ import annotations

import html
import math
from dataclasses import dataclass, field
from typing import Any, Callable, Sequence

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

COLOURS = ("#1f5f8b", "#c2572b", "#3a7d44", "#7d4f91", "#8a6d1d", "#52606d")
_LEFT, _RIGHT, _TOP, _BOTTOM, _WIDTH, _HEIGHT = 88, 18, 16, 46, 578, 340
_PREFIXES = {9: "G", 6: "M", 3: "k", 0: "", -3: "m"}


@dataclass
class Curve:
    """A curve of a plot: values [Pa] or [-] at times [s], frequencies [rad/s] or temperatures [degC]."""

    label: str
    x: Floats
    y: Floats
    colour: int = 0
    dashes: str = ""
    marks: bool = False


@dataclass
class Band:
    """The area between two curves with the same abscissae."""

    x: Floats
    low: Floats
    high: Floats
    colour: int = 0


@dataclass
class Drawing:
    """Curves and bands on logarithmic axes, and what these are called; values have the unit of `ordinate`."""

    curves: list[Curve]
    bands: list[Band] = field(default_factory=list)
    abscissa: str = "Time / s"
    ordinate: str = "M(t)"
    unit: str = "Pa"

    @property
    def quotable_unit(self) -> str:
        """The unit as a divisor: Pa, (1/Pa)."""
        return f"({self.unit})" if "/" in self.unit else self.unit


@dataclass
class _Axis:
    """A logarithmic axis: decades from `first` to `last` on pixels from `begin` to `end`."""

    first: float
    last: float
    begin: float
    end: float

    def place(self, values: Floats) -> Floats:
        share = (np.log10(values) - self.first) / (self.last - self.first)
        return np.asarray(self.begin + share * (self.end - self.begin))

    def decades(self, most: int = 8) -> list[int]:
        """The whole decades within, at most so many."""
        whole = range(math.ceil(self.first - 1e-9), math.floor(self.last + 1e-9) + 1)
        return list(whole)[:: max(1, math.ceil(len(whole) / most))]

    def steps(self) -> list[float]:
        """1, 2 and 5 times the whole decades, or all their multiples where these are fewer than two."""
        around = range(math.floor(self.first), math.ceil(self.last) + 1)
        for digits in ((1, 2, 5), range(1, 10)):
            steps = [float(f"{digit}e{decade}") for decade in around for digit in digits
                     if self.first - 1e-9 <= decade + math.log10(digit) <= self.last + 1e-9]
            if len(steps) > 1:
                break
        return steps

    def values(self, most: int) -> list[float]:
        """Where labels stand: at whole decades, or at steps within them where there are fewer than two."""
        decades = self.decades(most)
        return [10.0**decade for decade in decades] if len(decades) > 1 else self.steps()

    def ticks(self) -> list[tuple[float, str]]:
        """Places of whole decades, or of steps within one, and what stands there."""
        decades = self.decades()
        if len(decades) > 1:
            return [(float(self.place(np.array(10.0**decade))), _power(decade)) for decade in decades]
        return [(float(self.place(np.array(step))), f"{step:g}") for step in self.steps()]


@dataclass
class _LinearAxis:
    """A linear axis from `first` to `last` on pixels from `begin` to `end`."""

    first: float
    last: float
    begin: float
    end: float

    def place(self, values: Floats) -> Floats:
        return np.asarray(self.begin + (values - self.first) / (self.last - self.first) * (self.end - self.begin))

    def ticks(self) -> list[tuple[float, str]]:
        """Places of round numbers, at most nine, and the numbers."""
        power = 10.0 ** math.floor(math.log10((self.last - self.first) / 8))
        step = next(power * times for times in (1, 2, 5, 10) if power * times >= (self.last - self.first) / 8)
        first, last = math.ceil(self.first / step - 1e-9), math.floor(self.last / step + 1e-9)
        return [(float(self.place(np.array(number * step))), f"{number * step:g}".replace("-", "\u2212"))
                for number in range(first, last + 1)]


def _linear_axis(values: Sequence[Floats], begin: float, end: float) -> _LinearAxis:
    numbers = np.concatenate(values)
    first, last = float(numbers.min()), float(numbers.max())
    if first == last:  # a single value stands in the middle
        first, last = first - 0.5, last + 0.5
    return _LinearAxis(first, last, begin, end)


def _axis(values: Sequence[Floats], begin: float, end: float, margin: float) -> _Axis:
    logs = np.log10(np.concatenate([value[np.isfinite(value) & (value > 0)] for value in values]))
    first, last = float(logs.min()), float(logs.max())
    widening = max(margin * (last - first), (1.0 - (last - first)) / 2 if margin else 1e-6)
    return _Axis(first - widening, last + widening, begin, end)


def _shown(curve: Curve) -> Curve:
    """The part of a curve that logarithmic axes can show, in few enough points for a page."""
    good = np.isfinite(curve.x) & np.isfinite(curve.y) & (curve.y > 0)
    x, y = curve.x[good], curve.y[good]
    step = max(1, len(x) // 400)
    return Curve(curve.label, np.asarray(x[::step]), np.asarray(y[::step]), curve.colour, curve.dashes, curve.marks)


def _points(across: Floats, up: Floats) -> str:
    return " ".join(f"{a:.1f},{b:.1f}" for a, b in zip(across, up))


def _power(decade: int) -> str:
    sign = "\u2212" if decade < 0 else ""
    return f'10<tspan dy="-5" font-size="9">{sign}{abs(decade)}</tspan>'


def _pascals(value: float) -> str:
    """A round number of pascals in words: 100 kPa."""
    decade = math.floor(math.log10(value) + 1e-9)
    prefix = min(max(3 * (decade // 3), -3), 9)
    return f"{value / 10.0**prefix:.6g} {_PREFIXES[prefix]}Pa"


def _grid(x: _Axis | _LinearAxis, y: _Axis, abscissa: str, words: Callable[[float], str]) -> list[str]:
    parts = []
    for at, tick in x.ticks():
        parts.append(f'<line x1="{at:.1f}" x2="{at:.1f}" y1="{_TOP}" y2="{_HEIGHT - _BOTTOM}" stroke="#e4e7eb"/>')
        parts.append(f'<text x="{at:.1f}" y="{_HEIGHT - _BOTTOM + 17}" text-anchor="middle">{tick}</text>')
    for value in y.values(6):
        at = float(y.place(np.array(value)))
        parts.append(f'<line x1="{_LEFT}" x2="{_WIDTH - _RIGHT}" y1="{at:.1f}" y2="{at:.1f}" stroke="#e4e7eb"/>')
        parts.append(f'<text x="{_LEFT - 8}" y="{at + 4:.1f}" text-anchor="end">{words(value)}</text>')
    parts.append(f'<text x="{(_LEFT + _WIDTH - _RIGHT) / 2}" y="{_HEIGHT - 8}" text-anchor="middle">'
                 f"{html.escape(abscissa)}</text>")
    return parts


def _legend(curves: Sequence[Curve]) -> list[str]:
    parts = []
    for number, curve in enumerate(curves):
        up = _HEIGHT - _BOTTOM - 14 - 17 * (len(curves) - 1 - number)
        colour = COLOURS[curve.colour % len(COLOURS)]
        if curve.marks:
            parts.append(f'<circle cx="{_LEFT + 24}" cy="{up - 4}" r="3" fill="none" stroke="{colour}"/>')
        else:
            parts.append(f'<line x1="{_LEFT + 12}" x2="{_LEFT + 36}" y1="{up - 4}" y2="{up - 4}" stroke="{colour}" '
                         f'stroke-width="2" stroke-dasharray="{curve.dashes}"/>')
        parts.append(f'<text x="{_LEFT + 42}" y="{up}" paint-order="stroke" stroke="#ffffff" stroke-width="3">'
                     f"{html.escape(curve.label)}</text>")
    return parts


def svg_of(drawing: Drawing) -> str:
    """A drawing as SVG; empty where there is nothing to draw."""
    positive = [Curve(curve.label, curve.x[curve.x > 0], curve.y[curve.x > 0], curve.colour, curve.dashes, curve.marks)
                for curve in drawing.curves]
    words = _pascals if drawing.unit == "Pa" else plain
    ordinate = drawing.ordinate if drawing.unit == "Pa" else f"{drawing.ordinate} / {drawing.quotable_unit}"
    return _drawn(positive, drawing.bands, lambda values: _axis(values, _LEFT, _WIDTH - _RIGHT, 0.0), drawing.abscissa,
                  ordinate, words)


def svg_by(drawing_of: Callable[[Any], Drawing]) -> Callable[[Any], str]:
    """The method svg() of a class of which drawing_of() has the curves."""

    def svg(self: Any) -> str:
        """Its picture as SVG; empty where there is nothing to draw."""
        return svg_of(drawing_of(self))

    return svg


def svg_over_temperature(curves: Sequence[Curve], ordinate: str, words: Callable[[float], str] | None = None) -> str:
    """An SVG of curves over the temperature [degC], on a linear axis; words: for round values, of moduli by default."""
    return _drawn(curves, (), lambda values: _linear_axis(values, _LEFT, _WIDTH - _RIGHT), "Temperature / \u00b0C",
                  ordinate, words or _pascals)


def plain(value: float) -> str:
    """A number without a unit: 0.1."""
    return f"{value:.6g}"


def _drawn(curves: Sequence[Curve], bands: Sequence[Band], axis: Callable[[Sequence[Floats]], _Axis | _LinearAxis],
           abscissa: str, ordinate: str, words: Callable[[float], str]) -> str:
    curves = [shown for shown in map(_shown, curves) if len(shown.x) > 0]
    if not curves:
        return ""
    x = axis([curve.x for curve in curves])
    y = _axis([curve.y for curve in curves], _HEIGHT - _BOTTOM, _TOP, 0.06)
    parts = _grid(x, y, abscissa, words)
    middle = (_TOP + _HEIGHT - _BOTTOM) / 2
    parts.append(f'<text transform="rotate(-90)" x="{-middle}" y="15" text-anchor="middle">{html.escape(ordinate)}</text>')
    for band in bands:
        step = max(1, len(band.x) // 400)
        across = x.place(band.x[::step])
        low, high = (np.clip(y.place(edge[::step]), _TOP, _HEIGHT - _BOTTOM) for edge in (band.low, band.high))
        outline = _points(np.concatenate([across, across[::-1]]), np.concatenate([high, low[::-1]]))
        parts.append(f'<polygon points="{outline}" fill="{COLOURS[band.colour % len(COLOURS)]}" opacity="0.14"/>')
    for curve in curves:
        colour = COLOURS[curve.colour % len(COLOURS)]
        across, up = x.place(curve.x), y.place(curve.y)
        if curve.marks:
            parts += [f'<circle cx="{a:.1f}" cy="{b:.1f}" r="3" fill="none" stroke="{colour}"/>'
                      for a, b in zip(across, up)]
        else:
            parts.append(f'<polyline points="{_points(across, up)}" fill="none" stroke="{colour}" stroke-width="2" '
                         f'stroke-linejoin="round" stroke-dasharray="{curve.dashes}"/>')
    parts += _legend(curves)
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {_WIDTH} {_HEIGHT}" '
            f'style="max-width:{_WIDTH}px;width:100%;background:#ffffff" '
            'font-family="system-ui,sans-serif" font-size="12" fill="#323f4b">'
            f'<rect x="{_LEFT}" y="{_TOP}" width="{_WIDTH - _LEFT - _RIGHT}" height="{_HEIGHT - _TOP - _BOTTOM}" '
            f'fill="none" stroke="#cbd2d9"/>{"".join(parts)}</svg>')
