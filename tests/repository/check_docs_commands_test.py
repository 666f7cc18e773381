# SPDX-License-Identifier: Apache-2.0
"""check_docs_commands.py against a small project: what the page says is run, and what fails is found."""
import os
import subprocess
import sys
import tempfile
import unittest

CHECK = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tools", "check_docs_commands.py")
# Stands in for the program: `luxel need FILE` fails unless the file is there, `luxel make FILE` makes it.
PROGRAM = '#!/bin/sh\ncase $1 in need) test -e "$2" ;; make) echo made >"$2" ;; *) exit 2 ;; esac\n'


class CheckDocsCommands(unittest.TestCase):
    def check(self, page, status, words=""):
        """The page as docs/a.md of a project in a folder whose name has a space."""
        with tempfile.TemporaryDirectory(prefix="a project ") as root:
            for name, content in {"docs/a.md": page, "bin/luxel": PROGRAM, "scenes/box.obj": "",
                                  "dev": "verb_build() {\n}\n"}.items():
                os.makedirs(os.path.dirname(os.path.join(root, name)), exist_ok=True)
                with open(os.path.join(root, name), "w", encoding="utf-8") as file:
                    file.write(content)
            os.chmod(os.path.join(root, "bin", "luxel"), 0o755)
            done = subprocess.run([sys.executable, "-B", CHECK, root, os.path.join(root, "bin")], capture_output=True,
                                  text=True, check=False)
            self.assertEqual(done.returncode, status, done.stdout + done.stderr)
            self.assertIn(words, done.stdout)

    def test_commands_run_in_the_order_of_the_page(self):
        self.check("```sh\nluxel make out/a.png\n$ luxel need \\\n  out/a.png # there now\n```\n", 0)

    def test_scenes_and_programs_lie_where_the_reader_has_them(self):
        self.check("```sh\nluxel need scenes/box.obj\nbuild/release/bin/luxel need scenes/box.obj\n```\n", 0)

    def test_a_command_that_fails_is_found_on_its_line(self):
        self.check("Text.\n```sh\nluxel need nothing\n```\n", 1, "docs/a.md:3: `luxel need nothing` gave 1")

    def test_a_verb_that_dev_lacks_is_found(self):
        self.check("```sh\n./dev build\n```\n", 0)
        self.check("```sh\n./dev dance\n```\n", 1, "no verb dance")

    def test_a_python_file_of_the_page_runs(self):
        page = "```python\n# sum.py\nimport sys\nsys.exit({})\n```\n```sh\npython3 sum.py\n```\n"
        self.check(page.format(0), 0)
        self.check(page.format(3), 1, "`python3 sum.py` gave 3")
        self.check("```sh\npython3 -m http.server\n```\n", 0)

    def test_other_blocks_and_other_commands_are_left_alone(self):
        self.check("```sh no-run\nluxel need nothing\n```\n```cpp\nluxel need nothing\n```\n```sh\nfalse\n```\n", 0)
        self.check("No block at all: luxel need nothing\n", 0)


if __name__ == "__main__":
    unittest.main()
