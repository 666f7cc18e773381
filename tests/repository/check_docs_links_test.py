# SPDX-License-Identifier: Apache-2.0
"""check_docs_links.py against small documents: each planted violation is found in its line, and nothing else."""
import os
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "..", "tools"))
import check_docs_links  # noqa: E402

FILES = {"README.md", "docs/a.md", "docs/b.md", "src/luxel/core/trig.h", "docs/images/a.png"}


class CheckDocsLinks(unittest.TestCase):
    def lines(self, text, other="# B\n\n## The error bar\n"):
        documents = {"docs/a.md": text, "docs/b.md": other}
        return [line for line, _ in check_docs_links.violations_of("docs/a.md", documents, FILES)]

    def test_links_lead_to_files(self):
        self.assertEqual(self.lines("[b](b.md)\n[c](c.md)\n![a](images/a.png) ![b](images/b.png)\n"), [2, 3])
        self.assertEqual(self.lines("[r](../README.md) [web](https://example.org/c.md)\n"), [])

    def test_anchors_lead_to_headings(self):
        self.assertEqual(self.lines("# A\n[e](b.md#the-error-bar)\n[n](b.md#noise) [a](#a) [z](#z)\n"), [3, 3])
        self.assertEqual(self.lines("[n](b.md#noise)\n", "# B\n```sh\n# noise\n```\n"), [1])

    def test_named_sources_exist(self):
        self.assertEqual(self.lines("`core/trig.h` and `trig.h`\n`core/sine.h`\n`sine.cpp`\n"), [2, 3])

    def test_named_folders_exist(self):
        self.assertEqual(self.lines("`src/luxel/core`, `src/luxel/`, `src/luxel/core/trig`\n`src/luxel/sine`\n"), [2])

    def test_each_page_is_in_the_nav_once(self):
        def lines(nav):
            return [line for line, _ in check_docs_links.nav_violations(nav, FILES | {"CHANGELOG.md"})]

        self.assertEqual(lines("nav:\n  - A: a.md\n  - More:\n      - B: b.md\n      - Changes: CHANGELOG.md\n"), [])
        self.assertEqual(lines("nav:\n  - A: a.md\n  - C: c.md\n  - Again: a.md\n"), [3, 4, 1])

    def test_code_is_no_link(self):
        self.assertEqual(self.lines("```cpp\na[i](c.md)\n```\n[c](c.md)\n"), [4])


if __name__ == "__main__":
    unittest.main()
