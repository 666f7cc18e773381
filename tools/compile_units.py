#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Groups source files that can be compiled as one: compile_units.py LIMIT FILE...

Prints the number of a unit per file, in the order of the files. At most LIMIT files share a unit. Two files share none if
both declare the same name at the left margin, or if one declares what a header of the other does: then the compiler would
refuse them, or resolve a call to the other's function.
"""
import functools
import os
import re
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
# Where quoted includes are found, as the build has it.
FOLDERS = [os.path.join(ROOT, folder) for folder in ("include", "src", "tests", "tools", "")]
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)
# What a line at the left margin declares. The same alias may stand in a unit twice.
ALIAS = re.compile(r"^(?:using (?:\w+::)+(\w+)|using (\w+) = .*|namespace (\w+) = .*);$")
TYPE = re.compile(r"^(?:class|struct|enum class|enum|using|union)\s+(\w+)\b(?!\s*;)")
FURTHER = re.compile(r", (\w+)(?:\(| = )")  # const Vec3 up(0, 0, 1), north(0, 1, 0);
TEST = re.compile(r"^((?:TYPED_)?TEST\w*\(.*\)|INSTANTIATE\w*\(.*)")
OTHER = re.compile(r"^(?=[A-Za-z])(?!using|namespace|class|struct|enum|union|static_assert|TEST|TYPED_TEST|INSTANTIATE)"
                   r"[\w:<>,&*\s\[\]\"]*?\b((?:\w+::)*\w+)\s*([({=;].*)")


@functools.cache
def text_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


@functools.cache
def includes_of(path):
    """The headers of ours that a file names."""
    found = []
    for name in INCLUDE.findall(text_of(path)):
        found += [path for path in (os.path.join(folder, name) for folder in FOLDERS) if os.path.isfile(path)][:1]
    return found


@functools.cache
def headers_of(path):
    """The headers of ours that a file includes, itself or through others."""
    headers, todo = set(), list(includes_of(path))
    while todo:
        header = todo.pop()
        if header not in headers:
            headers.add(header)
            todo += includes_of(header)
    return frozenset(headers)


@functools.cache
def declared_in(path):
    """Names that stand for one thing in a translation unit; members of classes, with :: in them, never meet."""
    names = set()
    for line in text_of(path).splitlines():
        if ALIAS.match(line):
            continue
        found = TYPE.match(line) or TEST.match(line) or OTHER.match(line)
        if found and "::" not in found.group(1):
            names.add(found.group(1))
        if line.startswith("const"):
            names.update(FURTHER.findall(line))
        if line.startswith("enum ") and not line.startswith("enum class"):
            names.update(re.findall(r"\w+", line.partition("{")[2]))
    return names


@functools.cache
def types_in(path):
    return {found.group(1): path for found in map(TYPE.match, text_of(path).splitlines()) if found}


@functools.cache
def aliases_in(path):
    """Alias -> its line."""
    return {found.group(found.lastindex): found.group() for found in map(ALIAS.match, text_of(path).splitlines()) if found}


def units_of(paths, limit):
    """Lists of files that can be read as one: what a file declares itself, no other one or its headers do, and no two
    headers name a type alike, nor two files different things by one alias."""
    units = []
    for path in paths:
        headers = headers_of(path)
        shared = set().union(*map(declared_in, headers))
        types = {name: header for header in headers for name, header in types_in(header).items()}
        own = declared_in(path) - shared
        aliases = aliases_in(path)
        shared |= aliases.keys()
        types |= aliases
        for unit in units:
            if (len(unit["files"]) < limit and not own & (unit["own"] | unit["shared"]) and not shared & unit["own"]
                    and all(unit["types"].get(name, header) == header for name, header in types.items())):
                break
        else:
            unit = {"files": [], "own": set(), "shared": set(), "types": {}}
            units.append(unit)
        unit["files"].append(path)
        unit["own"] |= own
        unit["shared"] |= shared
        unit["types"] |= types
    return [unit["files"] for unit in units]


def main():
    limit, files = int(sys.argv[1]), [os.path.abspath(path) for path in sys.argv[2:]]
    number = {path: i for i, unit in enumerate(units_of(files, limit)) for path in unit}
    for path in files:
        print(number[path])


if __name__ == "__main__":
    main()
