#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Counts what ctest --output-junit wrote: count_tests.py FILE.

Prints each skipped test with its reason, and as the last line three numbers: passed, failed, skipped. A test that could
not be started counts as failed. Read by pattern, not as XML: a test may print bytes that no XML parser accepts.
"""
import html
import re
import sys


def attribute(text, name):
    match = re.search(rf'\b{name}="([^"]*)"', text)
    return html.unescape(match[1]) if match else ""


def reason_of(body):
    """The sentence after GoogleTest's `file:line: Skipped`, else the first line printed, else ctest's own word."""
    printed = re.search(r"<system-out>(.*?)</system-out>", body, re.DOTALL)
    lines = [line.strip() for line in html.unescape(printed[1] if printed else "").splitlines()]
    for i, line in enumerate(lines[:-1]):
        if re.search(r":\d+: Skipped$", line) and lines[i + 1]:
            return lines[i + 1]
    spoken = [line for line in lines if line and not re.match(r"Running main|Note: Google|\[", line)]
    return spoken[0] if spoken else attribute(body, "message") or "no reason given"


def kind_of(status, body):
    """ctest says notrun both of a test that skipped itself and of one whose program is missing."""
    if status in ("run", "fail"):
        return "passed" if status == "run" else "failed"
    skipped_itself = status == "disabled" or attribute(body, "message").startswith("SKIP_")
    return "skipped" if skipped_itself else "failed"


def main():
    with open(sys.argv[1], encoding="utf-8", errors="replace") as file:
        text = file.read()
    count = {"passed": 0, "failed": 0, "skipped": 0}
    for case in re.finditer(r"<testcase ([^>]*?)(?:/>|>(.*?)</testcase>)", text, re.DOTALL):
        body = case[2] or ""
        kind = kind_of(attribute(case[1], "status"), body)
        count[kind] += 1
        if kind == "skipped":
            print(f"skipped: {attribute(case[1], 'name')}: {reason_of(body)}")
        elif kind == "failed":
            print(f"failed: {attribute(case[1], 'name')}")
    print(count["passed"], count["failed"], count["skipped"])


if __name__ == "__main__":
    main()
