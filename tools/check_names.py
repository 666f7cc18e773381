#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Holds names to .clang-tidy: check_names.py BUILD_FOLDER [JOBS], after a build there.

clang-tidy takes seconds a file. A file that passed is not read again until it, a header of ours that it includes, its
command or .clang-tidy changes: the stamp of everything that passed is kept in BUILD_FOLDER/names.
"""
import concurrent.futures
import hashlib
import json
import os
import subprocess
import sys

TIDY = "clang-tidy-14"
OURS = ("src", "tests", "bench", "tools")


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


def check(entry, build):
    """clang-tidy's complaints about one file, empty if there are none. -w: warnings are the compiler's business."""
    done = subprocess.run([TIDY, "--quiet", "-p", build, "--extra-arg=-w", entry["file"]],
                          capture_output=True, text=True, check=False)
    return "" if done.returncode == 0 else done.stdout or done.stderr


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
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for (_, stamp), complaint in zip(todo, pool.map(lambda job: check(job[0], build), todo)):
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
