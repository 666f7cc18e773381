# SPDX-License-Identifier: Apache-2.0
"""check_words.py against small texts: each planted word is found in its scope and line, and nowhere else."""
import os
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "..", "tools"))
import check_words  # noqa: E402


class CheckWords(unittest.TestCase):
    def lines(self, name, text):
        return [line for _, line, _ in check_words.violations_of(name, text)]

    def test_identifiers_are_found_in_code_alone(self):
        self.assertEqual(self.lines("src/a.cpp", "int a;\nint slots = 0;\n"), [2])
        self.assertEqual(self.lines("src/a.cpp", "int most_rays = unshot_share + error2;\n"), [1, 1, 1])
        self.assertEqual(self.lines("src/a.cpp", 'auto a = "most_rays";  // most_rays\n'), [])
        self.assertEqual(self.lines("src/a.cpp", "std::shared_ptr<int> shared_options;\n"), [])

    def test_prose_is_found_in_comments_and_documents_alone(self):
        self.assertEqual(self.lines("src/a.h", "int a;  // rays a side\n"), [1])
        self.assertEqual(self.lines("docs/a.md", "Eight\nbytes a ray.\n"), [2])
        self.assertEqual(self.lines("src/a.cpp", 'auto a = "rays a side";\n'), [])

    def test_sentences_of_documents_begin_with_their_subject(self):
        self.assertEqual(self.lines("docs/a.md", "# What this is\nRays carry light.\n- Of these, few return. What is left stays.\n"), [3, 3])
        self.assertEqual(self.lines("docs/a.md", "The error that was asked for.\n"), [1])
        self.assertEqual(self.lines("src/a.h", "// Of all rays, those asked for.\n"), [])

    def test_sentences_may_use_words_as_verbs(self):
        self.assertEqual(self.lines("tests/a.cpp", "TEST(A, neighbours_that_share_no_index_are_split_alike)\n"), [])

    def test_options_are_found_everywhere(self):
        for name in ("docs/a.md", "bench/a.py", "tests/a.cpp"):
            self.assertEqual(self.lines(name, '"bake a.obj"\n"bake a.obj --share off"\n'), [2], name)
        self.assertEqual(self.lines("docs/a.md", "luxel lightmap a --page-size 8\n"), [])


if __name__ == "__main__":
    unittest.main()
