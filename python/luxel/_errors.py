# SPDX-License-Identifier: Apache-2.0
"""The exceptions of the package, and how messages are worded for Python."""
import re

__all__ = ["Error", "InputError", "FormatError", "MismatchError", "DeviceError", "Stopped"]


class Error(Exception):
    """Base of all errors that Luxel raises.

    str(error) is one sentence: what is wrong, what was expected, what to do. `file` and `line` say where, if the cause is
    in a file: a path as text and a number from 1, else None. `hints` are keyword arguments whose change may help, as
    pairs of name and value; the value is None where it is your choice.
    """

    file = None
    line = None
    hints = ()

    def __init__(self, message, hints=(), file=None, line=None):
        super().__init__(message)
        self.hints = tuple(hints)
        self.file = file
        self.line = line


class InputError(Error, ValueError):
    """An argument or a file that a person wrote is wrong."""


class FormatError(Error):
    """A file of Luxel's own is damaged, is something else, or was written by a newer version."""


class MismatchError(Error, ValueError):
    """Two things that must belong together do not, such as a solution and a scene."""


class DeviceError(Error, OSError):
    """A disk, a device or the operating system failed."""

    def __str__(self):
        return str(self.args[0]) if self.args else ""


class Stopped(Error):
    """A progress function stopped a call before it had a result."""


_KINDS = {"usage": InputError, "input": InputError, "format": FormatError, "mismatch": MismatchError,
          "device": DeviceError, "error": Error}


def python_name(option):
    """max-edge -> max_edge."""
    return option.replace("-", "_")


def worded(text):
    """A message with arguments instead of options: --max-edge -> max_edge."""
    return re.sub(r"(?<![\w-])--([a-z][a-z0-9-]*[a-z0-9])", lambda found: python_name(found[1]), text)


def with_hints(message, hints):
    """The sentence with the arguments that may help: (max_edge=..., sky='1')."""
    if not hints:
        return message
    words = [f"{name}={value!r}" if value is not None else f"{name}=..." for name, value in hints]
    return f"{message} ({', '.join(words)})"


def python_hints(pairs):
    """Pairs of the extension as keyword arguments: names of Python, None for no value."""
    return tuple((python_name(name), value or None) for name, value in pairs if name)


def make(kind, message, pairs, file, line):
    """The exception of a kind; the extension calls it. An empty file and line 0 are unknown."""
    hints = python_hints(pairs)
    return _KINDS[kind](with_hints(worded(message), hints), hints, file or None, line or None)
