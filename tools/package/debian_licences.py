# SPDX-License-Identifier: Apache-2.0
"""Licences of installed Debian packages as SPDX expressions, from their copyright files (DEP-5)."""
import os
import re

# Debian's short names that SPDX has under another one.
SPDX = {"Apache-2": "Apache-2.0", "Artistic": "Artistic-1.0-Perl", "BSD-2-clause": "BSD-2-Clause", "BSD-2-Clause": "BSD-2-Clause",
        "BSD-3-clause": "BSD-3-Clause", "BSD-3-Clause": "BSD-3-Clause", "BSL-1": "BSL-1.0", "Boost-1.0": "BSL-1.0",
        "CC0": "CC0-1.0", "Expat": "MIT", "expat": "MIT", "MIT": "MIT", "X11": "X11", "ISC": "ISC", "Zlib": "Zlib", "zlib": "Zlib", "Libpng": "Libpng",
        "libpng": "Libpng", "FTL": "FTL", "OFL-1.1": "OFL-1.1", "MPL-2.0": "MPL-2.0", "Python": "Python-2.0"}
SPDX.update({name: name for name in ("Apache-2.0", "Artistic-2.0", "BSL-1.0", "CC0-1.0", "CC-BY-3.0", "CC-BY-4.0", "CC-BY-SA-3.0",
                                     "CC-BY-SA-4.0", "MPL-1.1", "curl", "Unlicense")})
for version in ("1", "2", "2.0", "2.1", "3", "3.0"):
    for family in ("GPL", "LGPL", "AGPL"):
        full = version if "." in version else version + ".0"
        SPDX[f"{family}-{version}"] = f"{family}-{full}-only"
        SPDX[f"{family}-{version}+"] = f"{family}-{full}-or-later"


def copyright_file(package):
    path = f"/usr/share/doc/{package}/copyright"
    return path if os.path.isfile(path) else None


def paragraphs(text):
    """The paragraphs of a copyright file, each a dictionary of its fields."""
    for block in re.split(r"\n[ \t]*\n", text):
        fields = re.split(r"^([A-Za-z-]+):[ \t]*", "\n".join(line for line in block.split("\n") if not line.startswith("#")),
                          flags=re.MULTILINE)
        if len(fields) > 1:
            yield {name.capitalize(): value.strip() for name, value in zip(fields[1::2], fields[2::2])}


def term(name, texts, extracted):
    """One licence of an expression; one that SPDX does not list gets an identifier of our own, with its text."""
    if name in SPDX:
        return SPDX[name]
    identifier = "LicenseRef-Debian-" + re.sub(r"[^A-Za-z0-9.-]", "-", name)
    extracted.append({"licenseId": identifier, "name": name,
                      "extractedText": texts.get(name) or f"Named '{name}' in the copyright file of the package."})
    return identifier


def expression(line, texts, extracted):
    """A License line of DEP-5 ("GPL-2+ or Artistic, and Expat") in SPDX's words; `and` binds closer, a comma parts."""
    parts = [part for part in re.split(r",\s*(?:and\s+)?", line) if part]
    if len(parts) > 1:
        return " AND ".join(f"({expression(part, texts, extracted)})" for part in parts)
    words = re.split(r"\s+(and/or|and|or)\s+", line.strip())
    return " ".join(term(word, texts, extracted) if at % 2 == 0 else {"and": "AND"}.get(word, "OR")
                    for at, word in enumerate(words))


def licence_of(package):
    """SPDX expression of a package's files, packaging aside, and the licences in it that SPDX does not list."""
    path = copyright_file(package)
    if path is None:
        return "NOASSERTION", []
    with open(path, encoding="utf-8", errors="replace") as file:
        text = file.read()
    if not re.match(r"Format(-Specification)?:", text):
        return "NOASSERTION", []
    found, texts, extracted = [], {}, []
    rows = list(paragraphs(text))
    for row in rows:
        if "License" in row and "\n" in row["License"]:
            name, body = row["License"].split("\n", 1)
            texts.setdefault(name.strip(), re.sub(r"^ ", "", body, flags=re.MULTILINE).strip())
    for row in rows:
        if "License" not in row or "Files" not in row or all(file.startswith("debian/") for file in row["Files"].split()):
            continue
        line = row["License"].split("\n")[0].strip()
        part = expression(line, texts, extracted) if line else ""
        if part and part not in found:
            found.append(part)
    if not found:
        return "NOASSERTION", []
    return " AND ".join(f"({part})" if " " in part and len(found) > 1 else part for part in found), extracted
