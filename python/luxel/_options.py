# SPDX-License-Identifier: Apache-2.0
"""Keyword arguments become the options of the commands, which have them declared."""
import difflib
import functools
import inspect
import logging
import os
import textwrap

from . import _core
from ._errors import InputError, python_hints, python_name, with_hints, worded

log = logging.getLogger("luxel")

# What belongs to the command's files and console. The package has methods and arguments instead.
_CONSOLE = {"output", "json", "json-file", "open", "quiet", "verbose", "progress", "each-step", "threads"}
_DISPLAY_HEADINGS = {"Mesh (.glb)"}
_DISPLAY = {"tone", "exposure", "key", "white", "samples"}
_KEYWORDS = {"for": "for_", "as": "as_", "from": "from_"}  # words of Python

RUN = ("threads", "progress")
RUN_TEXT = """    threads: number of threads; None: all cores. Results do not depend on it.
    progress: called several times per second with (stage, done, rays, error): the name of the stage, the part of it that
        is done (0 to 1), rays traced and the standard error so far (0: not known yet). Returning False stops the call."""


@functools.lru_cache(maxsize=None)
def options_of(command):
    """Options of a command by their names in Python."""
    table = {}
    for option in _core.options_of(command):
        name = option["name"]
        if name not in _CONSOLE:
            table[_KEYWORDS.get(name, python_name(name))] = option
    return table


def scene_options():
    """Those that say how a scene is read and lit."""
    return options_of("scene")


@functools.lru_cache(maxsize=None)
def bake_options():
    """All options of a bake that change its light or its run."""
    return {name: o for name, o in options_of("bake").items()
            if o["heading"] not in _DISPLAY_HEADINGS and o["name"] not in _DISPLAY}


def _number(value):
    return repr(float(value)) if isinstance(value, float) else str(value)


def _words(option, value):
    """One value as the command would read it."""
    if isinstance(value, (bool,)) or type(value).__name__ == "bool_":
        if option["is_flag"]:
            return "true" if value else "false"
        return "on" if value else "off"
    if isinstance(value, (str, os.PathLike)):
        return os.fspath(value)
    if hasattr(value, "isoformat"):  # a date and time
        return value.isoformat()
    if isinstance(value, (tuple, list)) or hasattr(value, "tolist") and getattr(value, "ndim", 0) == 1:
        return ",".join(_number(v) for v in (value.tolist() if hasattr(value, "tolist") else value))
    if hasattr(value, "item"):
        value = value.item()
    if isinstance(value, (int, float)):
        return _number(value)
    raise TypeError(f"expected text, a number or a sequence of numbers, not {type(value).__name__}")


def _several(option, value):
    """The values of an option that may be given several times."""
    if isinstance(value, dict):
        return [f"{key}={_words(option, v)}" for key, v in value.items()]
    if isinstance(value, (str, os.PathLike, int, float)):
        return [_words(option, value)]
    return [_words(option, v) for v in value]


def given(table, function, arguments):
    """Keyword arguments as pairs of option and text; None stands for the default."""
    pairs = []
    for name, value in arguments.items():
        option = table.get(name)
        if option is None:
            near = difflib.get_close_matches(name, table, 1)
            raise TypeError(f"{function}() has no argument '{name}'"
                            + (f"; did you mean '{near[0]}'?" if near else f"; help(luxel.{function}) lists them"))
        if value is None:
            continue
        try:
            texts = _several(option, value) if option["many"] else [_words(option, value)]
        except TypeError as error:
            raise TypeError(f"{name}: {error}") from None
        pairs += [(option["name"], text) for text in texts]
    return pairs


def _report(level, text, pairs):
    if log.isEnabledFor(level):
        log.log(level, "%s", with_hints(worded(text), python_hints(pairs)))


def call(threads=None, progress=None):
    """What a long call runs with."""
    if progress is not None and not callable(progress):
        raise TypeError(f"progress: expected a function, not {type(progress).__name__}")
    count = 0 if threads is None else int(threads)
    if not 0 <= count <= 4096:
        raise InputError(f"threads: expected a number from 1 to 4096, or None for all cores, not {threads}")
    return _core.Call(count, progress, _report)


def _entry(name, option):
    unit = f" [{option['unit']}]" if option["unit"] else ""
    many = " Several as a list." if option["many"] else ""
    default = option["default"] or "none"
    text = f"{name}{unit}: {worded(option['help'])}; default {default}.{many}"
    return textwrap.fill(text, 110, initial_indent="    ", subsequent_indent="        ")


def documented(table, before=(), after=RUN):
    """Decorator: gives a function that takes **options their real signature, and a list of them in its text."""

    def decorate(function):
        parameters = [p for p in inspect.signature(function).parameters.values() if p.kind is not p.VAR_KEYWORD]
        known = {p.name for p in parameters}
        parameters += [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=None)
                       for name in table() if name not in known]
        function.__signature__ = inspect.Signature(parameters)
        lines, heading = [], None
        for name, option in table().items():
            if option["heading"] != heading:
                heading = option["heading"]
                lines += ["", f"{heading}:"]
            lines.append(_entry(name, option))
        lines += ["", "Run:", RUN_TEXT]
        function.__doc__ = inspect.cleandoc(function.__doc__) + "\n" + "\n".join(lines) + "\n"
        return function

    return decorate
