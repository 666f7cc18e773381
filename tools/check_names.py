#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Holds names to .clang-tidy: check_names.py BUILD_FOLDER [JOBS], after a build there.

clang-tidy takes seconds a file, nearly all of them for the headers. So files that can stand in one
translation unit are read as one; where something is wrong there, its halves are read, and theirs. A file that passed
is not read again until it, a header of ours that it includes, its command or .clang-tidy changes: the stamp of
everything that passed is kept in BUILD_FOLDER/names.
"""
import concurrent.futures
import functools
import hashlib
import json
import os
import re
import shlex
import subprocess
import sys

TIDY = "clang-tidy-14"
OURS = ("include", "src", "tests", "bench", "tools", "examples")
TOGETHER = 40  # files in one unit, at most
# What a line at the left margin declares: two files that declare the same cannot stand in one unit.
TYPE = re.compile(r"^(?:class|struct|enum class|enum|using|union)\s+(\w+)\b(?!\s*;)")
TEST = re.compile(r"^((?:TYPED_)?TEST\w*\(.*\)|INSTANTIATE\w*\(.*)")
OTHER = re.compile(r"^(?=[A-Za-z])(?!using|namespace|class|struct|enum|union|TEST|TYPED_TEST|INSTANTIATE)"
                   r"[\w:<>,&*\s\[\]\"]*?\b((?:\w+::)*\w+)\s*([({=;].*)")


def headers_of_objects(build, root):
    """Object file -> the files of ours that went into it, as ninja recorded them."""
    text = subprocess.run(["ninja", "-C", build, "-t", "deps"], capture_output=True, text=True, check=True).stdout
    headers, current = {}, []
    for line in text.splitlines():
        if line.startswith("    "):
            path = os.path.normpath(os.path.join(build, line.strip()))
            if path.startswith(root + os.sep):
                current.append(path)
        elif ": #deps" in line:
            current = headers[line.split(": #deps")[0]] = []
    return headers


def object_of(entry):
    words = shlex.split(entry["command"])
    return words[words.index("-o") + 1]


def stamp_of(entry, files, rules):
    """One hash of all that decides whether a file passes."""
    stamp = hashlib.sha256(rules)
    stamp.update(entry["command"].encode())
    for path in sorted({entry["file"], *files}):
        with open(path, "rb") as file:
            stamp.update(path.encode() + b"\0" + file.read())
    return stamp.hexdigest()


def check(entry):
    """clang-tidy's complaints about one file, empty if there are none. -w: warnings are the compiler's business."""
    done = subprocess.run([TIDY, "--quiet", "--extra-arg=-w", entry["file"], "--", *flags_of(entry)],
                          capture_output=True, text=True, check=False)
    return "" if done.returncode == 0 else done.stdout or done.stderr


def flags_of(entry):
    """The compiler's flags, without what names the file and its output, headers that it has compiled, and how code is
    to be made."""
    words = shlex.split(entry["command"])
    first = next(i for i, word in enumerate(words) if word.startswith("-"))
    flags, skip = [], False
    for word in words[first:]:
        if not skip and word not in ("-c", "-o", "-MT", "-MF", "-MD", "-include", "-Winvalid-pch", entry["file"]):
            if not re.match(r"-([OfW]|pthread)", word):
                flags.append(word)
        skip = word in ("-o", "-MT", "-MF", "-include")
    return tuple(flags)


def all_flags_of(entries):
    """Those of all files, each once: where headers are, and what is defined, does not differ between them."""
    flags = {}
    for entry in entries:
        of_one = list(flags_of(entry))
        while of_one:
            flag = (of_one.pop(0), of_one.pop(0)) if of_one[0] == "-isystem" else (of_one.pop(0),)
            flags[flag] = None
    return [word for flag in flags for word in flag]


@functools.cache
def declared_in(path):
    """Names that stand for one thing in a translation unit; members of classes, with :: in them, never meet."""
    names = set()
    with open(path, encoding="utf-8") as file:
        for line in file:
            found = TYPE.match(line) or TEST.match(line) or OTHER.match(line)
            if found and "::" not in found.group(1):
                names.add(found.group(1))
            if line.startswith("enum ") and not line.startswith("enum class"):
                names.update(re.findall(r"\w+", line.partition("{")[2]))
    return names


@functools.cache
def types_in(path):
    with open(path, encoding="utf-8") as file:
        return {found.group(1): path for found in map(TYPE.match, file) if found}


def units_of(jobs):
    """Lists of jobs that are read as one: what a file declares itself, no other one or its headers do, and no two
    headers name a type alike."""
    units = []
    for job in jobs:
        headers = [path for path in job[2] if path.endswith(".h")]
        shared = set().union(*map(declared_in, headers))
        types = {name: path for header in headers for name, path in types_in(header).items()}
        own = declared_in(job[0]["file"]) - shared
        for unit in units:
            if (len(unit["jobs"]) < TOGETHER and not own & (unit["own"] | unit["shared"]) and not shared & unit["own"]
                    and all(unit["types"].get(name, path) == path for name, path in types.items())):
                break
        else:
            unit = {"jobs": [], "own": set(), "shared": set(), "types": {}}
            units.append(unit)
        unit["jobs"].append(job)
        unit["own"] |= own
        unit["shared"] |= shared
        unit["types"] |= types
    return [unit["jobs"] for unit in units]


def check_unit(unit, name):
    """The complaints about each job of a unit, empty where there are none."""
    if len(unit) == 1:
        return [check(unit[0][0])]
    path = name + ".cpp"
    with open(path, "w", encoding="utf-8") as file:
        file.writelines(f'#include "{entry["file"]}"\n' for entry, *_ in unit)
    done = subprocess.run([TIDY, "--quiet", "--extra-arg=-w", path, "--", *all_flags_of(e for e, *_ in unit)],
                          capture_output=True, text=True, check=False)
    os.remove(path)
    if done.returncode == 0:
        return [""] * len(unit)
    half = len(unit) // 2
    return check_unit(unit[:half], name + "a") + check_unit(unit[half:], name + "b")


def jobs_to_do(root, build):
    """(entry, stamp, headers) of each file of ours, in the order of compile_commands.json, each file once."""
    with open(os.path.join(build, "compile_commands.json"), encoding="utf-8") as file:
        entries = {entry["file"]: entry for entry in json.load(file)}
    with open(os.path.join(root, ".clang-tidy"), "rb") as file:
        rules = file.read()
    headers = headers_of_objects(build, root)
    folders = tuple(os.path.join(root, folder) + os.sep for folder in OURS)
    jobs = []
    for entry in entries.values():
        if entry["file"].startswith(folders) and os.path.isfile(entry["file"]):
            of_entry = headers.get(object_of(entry), [])
            jobs.append((entry, stamp_of(entry, of_entry, rules), of_entry))
    return jobs


def main():
    root = os.path.abspath(os.path.join(os.path.dirname(__file__), ".."))
    build = os.path.abspath(sys.argv[1])
    jobs = int(sys.argv[2]) if len(sys.argv) > 2 else os.cpu_count()
    passed_file = os.path.join(build, "names")
    passed = set()
    if os.path.exists(passed_file):
        with open(passed_file, encoding="utf-8") as file:
            passed = set(file.read().split())
    every = jobs_to_do(root, build)
    todo = [job for job in every if job[1] not in passed]
    complaints = []
    units = units_of(todo)
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        results = pool.map(lambda i: check_unit(units[i], os.path.join(build, f"names-{i}")), range(len(units)))
        for unit, found in zip(units, results):
            for (_, stamp, _), complaint in zip(unit, found):
                complaints += [complaint] if complaint else []
                if not complaint:
                    passed.add(stamp)
    with open(passed_file, "w", encoding="utf-8") as file:
        file.writelines(stamp + "\n" for _, stamp, _ in every if stamp in passed)
    for complaint in dict.fromkeys(complaints):
        print(complaint.strip())
    print(f"{len(every)} files, {len(todo)} of them new or changed, {len(complaints)} with complaints")
    return 1 if complaints or not every else 0


if __name__ == "__main__":
    sys.exit(main())
