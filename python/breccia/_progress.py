"""Progress of long calculations: a line in terminals, a bar in notebooks, nothing elsewhere."""

from __future__ import annotations

import html
import sys
import time
from typing import Any, Callable, Optional, TextIO, Union

Show = Callable[[str, float, str], None]
Progress = Union[None, bool, Show]

_PATIENCE = 0.5  # seconds for which a calculation shows nothing


def _words(seconds: float) -> str:
    """A duration in words."""
    if seconds < 60:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 3600 else f"{seconds / 3600:.1f} h"


class _Display:
    """What has been shown so far, and how long the present work has taken."""

    def __init__(self) -> None:
        self._begun = time.monotonic()
        self._what = ""
        self._since = self._begun

    def __call__(self, what: str, share: float, details: str) -> None:
        now = time.monotonic()
        if what != self._what:
            self._what, self._since = what, now
        if now - self._begun < _PATIENCE:
            return
        elapsed = now - self._since
        left = f", {_words(elapsed * (1 - share) / share)} left" if 0.02 < share < 1 else ""
        self._show(what, min(max(share, 0.0), 1.0), f"{details}, {_words(elapsed)} so far{left}")

    def _show(self, what: str, share: float, details: str) -> None:
        raise NotImplementedError

    def close(self) -> None:
        raise NotImplementedError


class _Terminal(_Display):
    """A line that is overwritten."""

    def __init__(self, stream: TextIO) -> None:
        super().__init__()
        self._stream = stream
        self._is_shown = False

    def _show(self, what: str, share: float, details: str) -> None:
        filled = round(20 * share)
        bar = "#" * filled + "." * (20 - filled)
        self._stream.write(f"\r\x1b[K{what} [{bar}] {100 * share:.0f} %, {details}")
        self._stream.flush()
        self._is_shown = True

    def close(self) -> None:
        if self._is_shown:
            self._stream.write("\r\x1b[K")
            self._stream.flush()


class _Notebook(_Display):
    """A bar below the cell, which goes when the calculation ends."""

    def __init__(self) -> None:
        super().__init__()
        self._handle: Any = None

    def _show(self, what: str, share: float, details: str) -> None:
        from IPython.display import HTML, display

        text = HTML('<div style="font-size:90%">'
                    f'<progress value="{share:.3f}" max="1" style="vertical-align:middle;width:16em"></progress> '
                    f"{html.escape(what)}: {100 * share:.0f} %, {html.escape(details)}</div>")
        if self._handle is None:
            self._handle = display(text, display_id=True)
        else:
            self._handle.update(text)

    def close(self) -> None:
        from IPython.display import HTML

        if self._handle is not None:
            self._handle.update(HTML(""))


def _is_notebook() -> bool:
    """Whether this process is the kernel of a notebook. IPython is not imported for the answer."""
    module = sys.modules.get("IPython")
    shell = module.get_ipython() if module is not None else None
    return shell is not None and hasattr(shell, "kernel")


class shown:
    """Shows the progress of what is done inside: `with shown(progress) as show`."""

    def __init__(self, progress: Progress) -> None:
        self._display: Optional[_Display] = None
        self._show: Optional[Show] = None
        if callable(progress):
            self._show = progress
        elif progress is not False and _is_notebook():
            self._display = _Notebook()
        elif progress or (progress is None and sys.stderr is not None and sys.stderr.isatty()):
            self._display = _Terminal(sys.stderr)

    def __enter__(self) -> Optional[Show]:
        return self._display if self._display is not None else self._show

    def __exit__(self, *exception: object) -> None:
        if self._display is not None:
            self._display.close()
