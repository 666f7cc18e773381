#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Holds names to .clang-tidy: check_names.py BUILD_FOLDER [JOBS], once the folder is configured.

clang-tidy takes seconds a file, nearly all of them for the headers. So files that can stand in one
translation unit are read as one; where something is wrong there, its halves are read, and theirs. A file that passed
is not read again until it, a header of ours that it includes, its command or .clang-tidy changes: the stamp of
everything that passed is kept in BUILD_FOLDER/names.
"""
import concurrent.futures
import hashlib
import json
import os
import re
import shlex
import subprocess
import sys

from compile_units import headers_of, units_of

TIDY = "clang-tidy-14"
OURS = ("include", "src", "tests", "bench", "tools", "examples")
TOGETHER = 40  # files in one unit, at most


def stamp_of(entry, files, rules):
    """One hash of everything that determines whether a file passes."""
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


def check_unit(unit, name):
    """The complaints about each file of a unit, empty where there are none. unit: their entries."""
    if len(unit) == 1:
        return [check(unit[0])]
    path = name + ".cpp"
    with open(path, "w", encoding="utf-8") as file:
        file.writelines(f'#include "{entry["file"]}"\n' for entry in unit)
    done = subprocess.run([TIDY, "--quiet", "--extra-arg=-w", path, "--", *all_flags_of(unit)],
                          capture_output=True, text=True, check=False)
    os.remove(path)
    if done.returncode == 0:
        return [""] * len(unit)
    half = len(unit) // 2
    return check_unit(unit[:half], name + "a") + check_unit(unit[half:], name + "b")


def entries_of(root, build):
    """File of ours -> its entry in compile_commands.json."""
    with open(os.path.join(build, "compile_commands.json"), encoding="utf-8") as file:
        entries = {entry["file"]: entry for entry in json.load(file)}
    folders = tuple(os.path.join(root, folder) + os.sep for folder in OURS)
    return {path: entry for path, entry in entries.items() if path.startswith(folders) and os.path.isfile(path)}


def main():
    root = os.path.abspath(os.path.join(os.path.dirname(__file__), ".."))
    build = os.path.abspath(sys.argv[1])
    jobs = int(sys.argv[2]) if len(sys.argv) > 2 else os.cpu_count()
    passed_file = os.path.join(build, "names")
    passed = set()
    if os.path.exists(passed_file):
        with open(passed_file, encoding="utf-8") as file:
            passed = set(file.read().split())
    with open(os.path.join(root, ".clang-tidy"), "rb") as file:
        rules = file.read()
    entries = entries_of(root, build)
    stamps = {path: stamp_of(entry, headers_of(path), rules) for path, entry in entries.items()}
    todo = [path for path in entries if stamps[path] not in passed]
    complaints = []
    units = [[entries[path] for path in unit] for unit in units_of(todo, TOGETHER)]
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        results = pool.map(lambda i: check_unit(units[i], os.path.join(build, f"names-{i}")), range(len(units)))
        for unit, found in zip(units, results):
            for entry, complaint in zip(unit, found):
                complaints += [complaint] if complaint else []
                if not complaint:
                    passed.add(stamps[entry["file"]])
    with open(passed_file, "w", encoding="utf-8") as file:
        file.writelines(stamp + "\n" for stamp in stamps.values() if stamp in passed)
    for complaint in dict.fromkeys(complaints):
        print(complaint.strip())
    print(f"{len(entries)} files, {len(todo)} of them new or changed, {len(complaints)} with complaints")
    return 1 if complaints or not entries else 0


if __name__ == "__main__":
    sys.exit(main())
