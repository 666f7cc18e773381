#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that documents refer to things that exist: check_docs_links.py [ROOT].

In each Markdown file, a link must lead to a file, and its anchor to a heading of that file; a source file named in
backticks, as `solve/sampled.cpp`, must exist, below the root or one of FOLDERS, and so must a folder, as
`src/luxel/solve`, or a file without its ending where the name begins at the root. Each page of docs/ must be in the nav of
mkdocs.yml once, and each page of the nav must exist.
Prints each violation as file:line: sentence. Exit status: 1 if there is one.
"""
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from check_layers import files_of  # noqa: E402

FOLDERS = ("", "src/luxel/", "include/luxel/", "include/", "src/", "tests/", "web/")
LINK = re.compile(r"\]\(([^()\s]+)\)")
NAV = "mkdocs.yml"
NAV_PAGE = re.compile(r"^ *- [^:#]*: (\S+\.md)$", re.MULTILINE)
SOURCE = re.compile(r"`([a-z_]+(?:/[a-z_]+)*\.(?:h|cpp|py|mjs|cmake))`")

FOLDER = re.compile(r"`((?:src|include|tests|tools|examples|integrations)/[a-z_]+(?:/[a-z_]+)*)/?`")


def without_code(text):
    """The text with fenced blocks blanked; line numbers stay."""
    return re.sub(r"^```.*?^```", lambda block: "\n" * block[0].count("\n"), text, flags=re.DOTALL | re.MULTILINE)


def parents_of(file):
    """All folders that a file is in."""
    while file := os.path.dirname(file):
        yield file


def anchor_of(heading):
    """The anchor that Markdown readers make of a heading."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def anchors_of(text):
    return {anchor_of(heading) for heading in re.findall(r"^#+ (.*)$", without_code(text), re.MULTILINE)}


def violations_of(name, documents, files):
    """(line number, sentence) of each violation in a document. documents: text by name; files: the names of all files."""
    text = without_code(documents[name])
    names = {os.path.basename(file) for file in files}
    folders = {parent for file in files for parent in parents_of(file)}
    for match in LINK.finditer(text):
        line = text.count("\n", 0, match.start()) + 1
        path, _, anchor = match[1].partition("#")
        if ":" in path:
            continue
        target = os.path.normpath(os.path.join(os.path.dirname(name), path)) if path else name
        if target not in files and target not in folders:
            yield line, f"'{match[1]}': there is no file {target}"
        elif anchor and target in documents and anchor not in anchors_of(documents[target]):
            yield line, f"'{match[1]}': {target} has no heading of this name"
    for match in SOURCE.finditer(text):
        source = match[1]
        exists = any(folder + source in files for folder in FOLDERS) if "/" in source else source in names
        if not exists:
            yield text.count("\n", 0, match.start()) + 1, f"`{source}`: there is no such file"
    for match in FOLDER.finditer(text):
        if match[1] not in folders and not any(file.startswith(match[1]) for file in files):
            yield text.count("\n", 0, match.start()) + 1, f"`{match[1]}`: there is no such folder"


def nav_violations(nav, files):
    """(line number, sentence) of each disagreement of mkdocs.yml, its text, with the pages."""
    lines = {}
    for match in NAV_PAGE.finditer(nav):
        line = nav.count("\n", 0, match.start()) + 1
        if match[1] in lines:
            yield line, f"{match[1]} is in the nav already, on line {lines[match[1]]}"
        if f"docs/{match[1]}" not in files and match[1] not in files:
            yield line, f"there is no page docs/{match[1]}"
        lines.setdefault(match[1], line)
    for file in sorted(files):
        if re.fullmatch(r"docs/[^/]+\.md", file) and file[len("docs/"):] not in lines:
            yield 1, f"{file} is not in the nav"


def violations(root):
    files = set(files_of(root))
    documents = {}
    for name in sorted(files):
        if name.endswith(".md"):
            with open(os.path.join(root, name), encoding="utf-8") as file:
                documents[name] = file.read()
    if NAV in files:
        with open(os.path.join(root, NAV), encoding="utf-8") as file:
            for line, sentence in nav_violations(file.read(), files):
                yield NAV, line, sentence
    for name in documents:
        for line, sentence in violations_of(name, documents, files):
            yield name, line, sentence


def main():
    root = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(__file__), ".."))
    found = list(violations(root))
    for name, line, sentence in found:
        print(f"{name}:{line}: {sentence}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
