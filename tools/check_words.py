#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Refuses words that the project has replaced by the field's terms: check_words.py [ROOT].

RULES lists patterns with a scope: `identifier` (C++ code without comments and strings), `option` (options of the command
in any text), `prose` (comments, Markdown) and `document` (Markdown). ALLOWED lists what a pattern matches by accident.
Prints each violation as file:line: sentence. Exit status: 1 if there is one.
"""
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from check_layers import files_of  # noqa: E402

UNIT = ("side|replicate|ray|unit|pixel|texel|row|patch|receiver|chunk|block|sample|node|core|rank|thread|vertex|triangle|"
        "element|factor|bounce|round|sweep|frame|group|job|run|report|second|watt")
QUANTITY = (r"rays?|hits|samples|bytes|lines|paths|texels|metres|microseconds|nanoseconds|seconds|factors|points|rows|"
            r"numbers|vertices|triangles|patches|pixels|sides|lumens|doublings|[µumn]s")

# Scope, pattern, the term to use.
RULES = [
    ("identifier", r"\w*[sS]lots?(?![a-z])\w*", "receiver, or row"),
    ("identifier", r"(\w*_)?shares?(_\w*)?|\w*Shares?(?![a-z])\w*", "fraction, partition, all_gather, smoothing or texture ratio"),
    ("identifier", r"(most|least|fewest)_\w*", "max_, min_"),
    ("identifier", rf"\w*({QUANTITY})_a_({UNIT})_?", "per"),
    ("identifier", r"\w*(error|light|bias|noise)2_?", "squared_error, ..."),
    ("identifier", r"Kept\w*|\w*_kept_\w*", "round trip, stored"),
    ("identifier", r"\w*(twisted|sewn|crowded)\w*", "inconsistent winding, welded, non-manifold"),
    ("identifier", r"\w*dark_sides\w*", "unreached sides"),
    ("identifier", r"\w*take_up\w*", "restore, resume"),
    ("identifier", r"\w*[hH]abits\w*|MeshProgram", "export profile, target application"),
    ("identifier", r"PieceMesh|VertexFan|Rims?", "fragment mesh, one-ring, boundary loop"),
    ("option", r"--(share|keep-transport|keep-topology|keep-above|report|page)(?![\w-])",
     "--smoothing, --store-transport, --preserve-topology, --min-factor, --json-file, --page-size"),
    ("prose", r"\bslots?\b", "receiver, or row"),
    ("prose", rf"(?<![\w-])({QUANTITY}) an? ({UNIT})(?![\w-])", "per"),
    ("prose", r"\b(crowded edges?|dark sides?|twisted|sewn)\b", "non-manifold edge, unreached side, inconsistent winding, welded"),
    ("prose", r"\b(rules|checks) of the house\b", "checks of the repository"),
    ("document", r"(?m)(?:^(?:[-*] |\d\. )?|(?<=[.:] ))(?:Of|What|Likewise) ", "the subject first"),
    ("document", r"\b(likewise|nobody|somebody|brilliant|anew)\b", "a plain word: also, as above, very bright, again"),
    ("document", r"\b(is|are|was|were) (told|said)\b", "reported, stated"),
    ("document", r"\b[Ff]orecasts?\b", "estimate, prediction"),
    ("document", r"\b(the|a|an|their|its) shares? of\b|\bshares of\b", "fraction"),
    ("document", r"\blamps? without a surface\b", "punctual light"),
    ("document", r"\bpass(es|ed)? over\b", "ignore"),
    ("document", r"\basked for\b", "requested"),
    ("document", r"\b(gives?|gave|giving) way\b", "lower thread priority"),
    ("document", r"\b(one|entry|line|row|list) an? (round|bounce|step|kind|line|mesh|sample|texel|side|patch|file)\b", "per"),
    ("document", r"\bput together again\b", "join"),
    ("document", r"\b(hold|holds|held) (it|them|itself) (to|against)\b", "compare"),
    ("document", r"\ball the same\b", "anyway"),
]
ALLOWED = re.compile(r"shared_\w+|make_shared\w*|texture slots?|share_clipboard|least_squares")
MAX_WORDS = 4  # longer identifiers are sentences, the names of tests, in which "share" and "kept" are verbs
# Files that must name the old words.
EXEMPT = {"tools/check_words.py", "tests/repository/check_words_test.py", "tools/compare_outputs.py",
          "src/luxel/solution/solution_layout.h"}
FOLDERS = ("include/", "src/", "tests/", "bench/", "tools/", "docs/", "examples/", "integrations/", "web/")
COMPILED = [(scope, re.compile(rf"(?<!\w)(?:{pattern})(?!\w)" if scope == "identifier" else pattern), term)
            for scope, pattern, term in RULES]
# Comments, strings and characters.
TOKEN = re.compile(r"""//[^\n]*|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])'""", re.DOTALL)


def scopes_of(name, text):
    """The parts of a file by scope; each keeps its line numbers."""
    if not name.endswith((".h", ".cpp")):
        document = text if name.endswith(".md") else ""
        return {"prose": document, "document": document, "option": text}
    code, prose, end = [], [], 0
    for token in TOKEN.finditer(text):
        between = text[end:token.start()]
        code += [between, blank(token[0])]
        prose += [blank(between), token[0] if token[0].startswith("//") else blank(token[0])]
        end = token.end()
    return {"identifier": "".join(code) + text[end:], "prose": "".join(prose), "option": text}


def blank(text):
    return re.sub(r"[^\n]", " ", text)


def violations_of(name, text):
    parts = scopes_of(name, text)
    for scope, pattern, term in COMPILED:
        part = parts.get(scope, "")
        for match in pattern.finditer(part):
            begin = part.rfind("\n", 0, match.start()) + 1
            around = part[max(begin, match.start() - 12):match.end() + 12]
            if ALLOWED.search(around):
                continue
            if scope == "identifier" and match[0].count("_") >= MAX_WORDS:
                continue
            yield name, part.count("\n", 0, match.start()) + 1, f"'{match[0].strip()}': write {term}"


def violations(root):
    for name in files_of(root):
        if name in EXEMPT or not (name.startswith(FOLDERS) or name.endswith(".md")):
            continue
        if not name.endswith((".h", ".cpp", ".md", ".py", ".js", ".mjs", ".cmake", ".txt")):
            continue
        with open(os.path.join(root, name), encoding="utf-8", errors="replace") as file:
            yield from violations_of(name, file.read())


def main():
    root = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(__file__), ".."))
    found = list(violations(root))
    for name, line, sentence in found:
        print(f"{name}:{line}: {sentence}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
