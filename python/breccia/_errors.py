"""The exceptions of Breccia. Their messages are those of the command line."""


class Error(Exception):
    """Base of every error that Breccia reports. The message is complete."""

    exit_code = 1  #: that of the command


class InputError(Error, ValueError):
    """A mistake in what was asked: a bad deck, data file or argument. The message has a line for every mistake."""

    exit_code = 2

    @property
    def mistakes(self) -> list[str]:
        """The mistakes, one text each."""
        return str(self).splitlines()


class NumericalError(Error, ArithmeticError):
    """The calculation cannot continue: instability, no convergence, an impossible packing."""

    exit_code = 3


class FileError(Error, OSError):
    """A file cannot be read or written."""

    exit_code = 4


class Interrupted(Error):
    """A limit of time has ended a run in a directory, from which resume=True continues. (Ctrl-C is KeyboardInterrupt.)"""

    exit_code = 130
