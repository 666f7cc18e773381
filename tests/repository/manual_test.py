# SPDX-License-Identifier: Apache-2.0
"""The manual as a site: manual_test.py ROOT. Builds it without a warning, and checks that each link of each page leads to
a file and to a place in it, that no page loads anything from outside, and that KaTeX draws every equation.

Exit status 77 (skipped) without MkDocs, its theme Material or KaTeX. Equations are checked only with Node.js."""
import glob
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from html.parser import HTMLParser
from urllib.parse import unquote, urlsplit

ROOT = os.path.abspath(sys.argv.pop(1))
KATEX = "/usr/share/javascript/katex/katex.min.js"
SKIPPED = 77
LOADED = {("script", "src"), ("img", "src"), ("link", "href")}  # by the browser without a click
# Draws the equations of the standard input, an array; prints those that KaTeX refuses.
DRAW = """
const katex = require(process.argv[1]);
for (const { page, tex } of JSON.parse(require("fs").readFileSync(0)))
  try { katex.renderToString(tex, { throwOnError: true, strict: "error" }); }
  catch (error) { console.log(page + ": " + error.message); }
"""


class Page(HTMLParser):
    """The links, places and equations of a page."""

    def __init__(self, text):
        super().__init__()
        self.links, self.loads, self.places, self.equations, self.depth = [], [], set(), [], 0
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        self.places |= {attributes[name] for name in ("id", "name") if attributes.get(name)}
        for name in ("href", "src"):
            if attributes.get(name) is not None:
                (self.loads if (tag, name) in LOADED else self.links).append(attributes[name])
        if self.depth or "arithmatex" in (attributes.get("class") or "").split():
            self.equations += [] if self.depth else [""]
            self.depth += 1

    def handle_endtag(self, tag):
        self.depth = max(0, self.depth - 1)

    def handle_data(self, data):
        if self.depth:
            self.equations[-1] += data


def build(site):
    """MkDocs' warnings, or None where it is not there."""
    if not shutil.which("mkdocs") or not os.path.exists(KATEX):
        return None
    done = subprocess.run(["mkdocs", "build", "--strict", "--quiet", "--site-dir", site], cwd=ROOT, capture_output=True,
                          text=True, check=False)
    if "Unrecognised theme" in done.stderr:
        return None
    return done.stdout + done.stderr if done.returncode else ""


class Manual(unittest.TestCase):
    def test_it_is_built_without_a_warning(self):
        self.assertEqual(WARNINGS, "")

    def test_each_link_leads_somewhere(self):
        for path, page in PAGES.items():
            for link in page.links + page.loads:
                parts = urlsplit(link)
                if parts.scheme or parts.netloc or link == "":
                    continue
                target = os.path.normpath(os.path.join(os.path.dirname(path), unquote(parts.path))) if parts.path else path
                if os.path.isdir(target):
                    target = os.path.join(target, "index.html")
                self.assertTrue(os.path.exists(target), f"{os.path.basename(path)} links to {link}")
                if parts.fragment and target in PAGES:
                    self.assertIn(unquote(parts.fragment), PAGES[target].places, f"{os.path.basename(path)}: {link}")

    def test_nothing_is_loaded_from_outside(self):
        for path, page in PAGES.items():
            for load in page.loads:
                self.assertEqual(urlsplit(load).netloc, "", f"{os.path.basename(path)} loads {load}")

    def test_the_theory_has_equations(self):
        self.assertGreater(len(PAGES[os.path.join(SITE, "theory.html")].equations), 50)

    @unittest.skipUnless(shutil.which("node"), "there is no Node.js")
    def test_every_equation_is_drawn(self):
        equations = [{"page": os.path.basename(path), "tex": tex.strip()[2:-2]}  # \( ... \) or \[ ... \]
                     for path, page in PAGES.items() for tex in page.equations]
        done = subprocess.run(["node", "-e", DRAW, KATEX], input=json.dumps(equations), capture_output=True, text=True,
                              check=False)
        self.assertEqual((done.returncode, done.stdout + done.stderr), (0, ""))


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as SITE:
        WARNINGS = build(SITE)
        if WARNINGS is None:
            print("skipped: MkDocs, its theme Material or KaTeX is not installed")
            sys.exit(SKIPPED)
        PAGES = {}
        for found in set(glob.glob(os.path.join(SITE, "*.html"))) - {os.path.join(SITE, "404.html")}:  # of servers
            with open(found, encoding="utf-8") as html:
                PAGES[found] = Page(html.read())
        unittest.main()
