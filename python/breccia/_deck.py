"""Decks as text: what a study that was built in Python is checked and solved from."""

from __future__ import annotations

import itertools
import os
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._errors import InputError


class Files:
    """Files that hold the arrays of a study, since a deck names files; they exist as long as this object."""

    def __init__(self) -> None:
        self._directory: tempfile.TemporaryDirectory[str] | None = None
        self._numbers = itertools.count(1)
        self._arguments: dict[str, str] = {}

    @classmethod
    def of(cls, contents: dict[str, bytes]) -> Files:
        """Files with these contents, by their names."""
        files = cls()
        for name, content in contents.items():
            files._path_in(name).write_bytes(content)
        return files

    @property
    def place(self) -> str:
        """Their directory; empty while there is no file."""
        return "" if self._directory is None else self._directory.name

    def contents(self) -> dict[str, bytes]:
        """The contents of all files, by their names."""
        return {path.name: path.read_bytes() for path in sorted(Path(self.place).iterdir())} if self.place else {}

    def in_words(self, message: str) -> str:
        """A message with the arguments that the arrays were given by in place of the names of the files."""
        for path, argument in self._arguments.items():
            message = message.replace(path, argument)
        return message

    def _path_in(self, name: str) -> Path:
        if self._directory is None:
            self._directory = tempfile.TemporaryDirectory(prefix="breccia-")
        return Path(self._directory.name) / name

    def _path(self, name: str, argument: str) -> Path:
        path = self._path_in(f"{next(self._numbers)}-{name}")
        self._arguments[str(path)] = argument
        return path

    def image(self, labels: Any, argument: str) -> str:
        """A file with the labels of an argument, [y, x] or [z, y, x] with the top row first."""
        path = self._path("labels.npy", argument)
        labels = np.asarray(labels)
        if labels.dtype == bool:
            labels = labels.astype(np.uint8)
        np.save(path, labels)
        return str(path)

    def table(self, columns: dict[str, NDArray[Any]], argument: str) -> str:
        """A file with the columns of numbers of an argument, to their last bit."""
        path = self._path("table.csv", argument)
        rows = zip(*(np.asarray(column).tolist() for column in columns.values()))
        lines = [",".join(columns), *(",".join(repr(number) for number in row) for row in rows)]
        path.write_text("\n".join(lines) + "\n")
        return str(path)


def text_of(value: Any) -> str:
    """A value as TOML."""
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    if isinstance(value, (str, os.PathLike)):
        return _quoted(os.fspath(value))
    if isinstance(value, dict):
        entries = (f"{_quoted(str(key))} = {text_of(entry)}" for key, entry in value.items() if entry is not None)
        return "{ " + ", ".join(entries) + " }"
    if isinstance(value, (list, tuple, np.ndarray)):
        return "[" + ", ".join(text_of(element) for element in value) + "]"
    raise InputError(f"expected what a deck can hold, got {value!r}")


def _quoted(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return '"' + "".join(f"\\u{ord(c):04x}" if ord(c) < 0x20 or ord(c) == 0x7F else c for c in escaped) + '"'


def _key(key: str) -> str:
    is_bare = key.isascii() and key.replace("-", "").replace("_", "").isalnum()
    return key if is_bare else _quoted(key)


def lines_of(table: dict[str, Any]) -> list[str]:
    """The lines of a table. Raises InputError with the key of what no deck can hold."""
    lines = []
    for key, value in table.items():
        try:
            lines += [] if value is None else [f"{_key(key)} = {text_of(value)}"]
        except InputError as error:
            raise InputError(f"{key}: {error}") from None
    return lines


def _section(heading: str, table: dict[str, Any]) -> list[str]:
    return ["", heading, *lines_of(table)]


def deck_text(deck: dict[str, Any]) -> str:
    """A deck as text, laid out as a person would."""
    lines = lines_of({key: value for key, value in deck.items() if _is_plain(key)})
    for name, material in deck.get("materials", {}).items():
        lines += _section(f"[materials.{_key(name)}]", material)
    for stage in deck.get("stages", []):
        lines += _section("[[stages]]", stage)
    lines += _section("[tests]", deck.get("tests", {}))
    for measurement in deck.get("measurements", []):
        lines += _section("[[measurements]]", measurement)
    return "\n".join(lines).lstrip("\n") + "\n"


def _is_plain(key: str) -> bool:
    return key not in ("materials", "stages", "tests", "measurements")
