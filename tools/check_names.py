#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Holds names to .clang-tidy: check_names.py BUILD_FOLDER [JOBS], after a build there.

clang-tidy takes seconds a file, nearly all of them for the headers. So files that can stand in one
translation unit are read as one, and one by one only where something is wrong there. A file that passed is not read
again until it, a header of ours that it includes, its command or .clang-tidy changes: the stamp of everything that
passed is kept in BUILD_FOLDER/names.
"""
import concurrent.futures
import hashlib
import json
import os
import re
import shlex
import subprocess
import sys

TIDY = "clang-tidy-14"
OURS = ("src", "tests", "bench", "tools")
TOGETHER = 12  # files in one unit, at most
# What a line at the left margin declares: two files that declare the same cannot stand in one unit.
DECLARED = [re.compile(r"^(?:class|struct|enum class|enum|using|union)\s+(\w+)"), re.compile(r"^TEST\w*\((.*)\)"),
            re.compile(r"^(?=[A-Za-z])(?!TEST|using|namespace|class|struct|enum|union)[\w:<>,&*\s\[\]\"]*?\b(\w+)\s*[({=;]")]


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
    """The compiler's flags, without what names the file and its output, or headers that it has compiled."""
    words = shlex.split(entry["command"])
    first = next(i for i, word in enumerate(words) if word.startswith("-"))
    flags, skip = [], False
    for word in words[first:]:
        if not skip and word not in ("-c", "-o", "-MT", "-MF", "-MD", "-include", "-Winvalid-pch", entry["file"]):
            flags.append(word)
        skip = word in ("-o", "-MT", "-MF", "-include")
    return tuple(flags)


def declared_in(path):
    names = set()
    with open(path, encoding="utf-8") as file:
        for line in file:
            names.update(found.group(1) for found in (rule.match(line) for rule in DECLARED) if found)
    return names


def units_of(jobs):
    """Lists of jobs that are read as one: with the same flags, that declare different names."""
    units = []
    for job in jobs:
        names, kind = declared_in(job[0]["file"]), flags_of(job[0])
        for unit in units:
            if unit["kind"] == kind and len(unit["jobs"]) < TOGETHER and not names & unit["names"]:
                break
        else:
            unit = {"kind": kind, "jobs": [], "names": set()}
            units.append(unit)
        unit["jobs"].append(job)
        unit["names"] |= names
    return [unit["jobs"] for unit in units]


def check_unit(unit, number, build):
    """The complaints about each job of a unit, empty where there are none."""
    if len(unit) > 1:
        path = os.path.join(build, f"names-{number}.cpp")
        with open(path, "w", encoding="utf-8") as file:
            file.writelines(f'#include "{entry["file"]}"\n' for entry, _ in unit)
        done = subprocess.run([TIDY, "--quiet", "--extra-arg=-w", path, "--", *flags_of(unit[0][0])],
                              capture_output=True, text=True, check=False)
        os.remove(path)
        if done.returncode == 0:
            return [""] * len(unit)
    return [check(entry) for entry, _ in unit]


def jobs_to_do(root, build):
    """(entry, stamp) of each file of ours, in the order of compile_commands.json, each file once."""
    with open(os.path.join(build, "compile_commands.json"), encoding="utf-8") as file:
        entries = {entry["file"]: entry for entry in json.load(file)}
    with open(os.path.join(root, ".clang-tidy"), "rb") as file:
        rules = file.read()
    headers = headers_of_objects(build, root)
    folders = tuple(os.path.join(root, folder) + os.sep for folder in OURS)
    return [(entry, stamp_of(entry, headers.get(entry.get("output", ""), []), rules))
            for entry in entries.values() if entry["file"].startswith(folders) and os.path.isfile(entry["file"])]


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
        results = pool.map(lambda i: check_unit(units[i], i, build), range(len(units)))
        for unit, found in zip(units, results):
            for (_, stamp), complaint in zip(unit, found):
                complaints += [complaint] if complaint else []
                if not complaint:
                    passed.add(stamp)
    with open(passed_file, "w", encoding="utf-8") as file:
        file.writelines(stamp + "\n" for _, stamp in every if stamp in passed)
    for complaint in dict.fromkeys(complaints):
        print(complaint.strip())
    print(f"{len(every)} files, {len(todo)} of them new or changed, {len(complaints)} with complaints")
    return 1 if complaints or not every else 0


if __name__ == "__main__":
    sys.exit(main())
