# SPDX-License-Identifier: Apache-2.0
"""check_layers.py against small trees: a clean one passes, each planted violation is found on its line."""
import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "..", "tools"))
import check_layers  # noqa: E402

LICENCE = "// SPDX-License-Identifier: Apache-2.0\n"
MODULES = "luxel_module(core LIBRARIES glm::glm)\nluxel_module(image)\nluxel_module(scene DEPENDS core)\n"


class CheckLayers(unittest.TestCase):
    def found(self, files, modules=MODULES):
        """The violations of a tree with these files beside one clean header."""
        clean = LICENCE + "#pragma once\n#include <vector>\n#include <glm/glm.hpp>\n"
        uses = LICENCE + '#include "luxel/core/vector.h"\n'
        readmes = {f"src/luxel/{module}/README.md": "" for module in ("core", "scene", "cli", "cellar", "image")}
        files = {"CMakeLists.txt": modules, "src/luxel/core/vector.h": clean, "src/luxel/scene/uses.cpp": uses,
                 **readmes, **files}
        files = {name: content for name, content in files.items() if content is not None}
        with tempfile.TemporaryDirectory() as root:
            for name, content in files.items():
                os.makedirs(os.path.dirname(os.path.join(root, name)), exist_ok=True)
                with open(os.path.join(root, name), "wb") as file:
                    file.write(content if isinstance(content, bytes) else content.encode())
            return list(check_layers.violations(root))

    def check(self, files, name, line, words, modules=MODULES):
        found = self.found(files, modules)
        self.assertEqual(len(found), 1, found)
        self.assertEqual(found[0][:2], (name, line))
        self.assertIn(words, found[0][2])

    def check_line(self, module, line, words):
        """A source file of this module whose second line is this one."""
        name = f"src/luxel/{module}/a.cpp"
        self.check({name: LICENCE + line + "\n"}, name, 2, words)

    def test_a_clean_tree_has_no_violation(self):
        uses = LICENCE + '#include "luxel/core/vector.h"\n#include <fmt/format.h>\n#include <vector>\n'
        self.assertEqual(self.found({"src/luxel/scene/a.cpp": uses, "src/luxel/cli/a.cpp": uses}), [])

    def test_a_module_includes_only_what_it_depends_on(self):
        self.check_line("image", '#include "luxel/core/vector.h"', "image may not include core")

    def test_a_dependency_that_nothing_uses_is_found(self):
        self.check({"src/luxel/scene/uses.cpp": None}, "CMakeLists.txt", 3, "scene declares core")

    def test_a_module_without_a_readme_is_found(self):
        self.check({"src/luxel/core/README.md": None}, "src/luxel/core", 1, "README.md")

    def test_a_function_of_more_than_six_parameters_is_found(self):
        self.check_line("scene", "int f(int a, const Vec3& b, std::span<const int> c, T* d, int e, int g, int h = 0);",
                        "7 parameters")
        call = "void g() {\n  f(a, b(1, 2), {c, d}, e, g, h, k);\n}\n"
        six = "int f(int a, std::map<int, int> b, int c, int d, int e, int g) {\n  return a;\n}\n"
        self.assertEqual(self.found({"src/luxel/scene/a.cpp": LICENCE + call + six}), [])

    def test_an_include_that_is_not_there_is_found(self):
        self.check_line("scene", '#include "luxel/core/nothing.h"', "does not exist")

    def test_an_outside_library_stays_at_home(self):
        self.check_line("scene", "#include <glm/glm.hpp>", "whose only home is core")
        self.check_line("scene", "#include <CLI/CLI.hpp>", "whose only home is cli")

    def test_the_system_is_called_in_one_module(self):
        self.check_line("scene", "#include <unistd.h>", "whose only home is core")

    def test_an_unknown_library_is_refused(self):
        self.check_line("scene", "#include <boost/any.hpp>", "neither of the C++ standard library")

    def test_public_headers_include_public_headers_alone(self):
        public = {"include/luxel/core/a.h": LICENCE + "#pragma once\n",
                  "include/luxel/scene/a.h": LICENCE + '#pragma once\n#include "luxel/core/a.h"\n'}
        self.assertEqual(self.found(public), [])
        name = "include/luxel/scene/a.h"
        self.check({**public, name: public[name] + '#include "luxel/core/vector.h"\n'}, name, 4, "is not public")

    def test_modules_do_not_include_the_umbrella(self):
        umbrella = {"include/luxel/luxel.h": LICENCE + "#pragma once\n"}
        uses = LICENCE + '#include "luxel/luxel.h"\n'
        self.assertEqual(self.found({**umbrella, "src/luxel/cli/a.cpp": uses}), [])
        self.check({**umbrella, "src/luxel/image/a.cpp": uses}, "src/luxel/image/a.cpp", 2, "for users of the library")

    def test_a_type_has_a_name_of_its_own(self):
        header = LICENCE + "#pragma once\nstruct Frame;\n"
        files = {"src/luxel/core/a.h": header + "struct Frame {\n};\n", "src/luxel/scene/b.h": header}
        self.assertEqual(self.found(files), [])
        files["src/luxel/scene/b.h"] = header + "class Frame {\n};\n"
        self.check(files, "src/luxel/scene/b.h", 4, "has a type Frame already")

    def test_a_file_begins_with_its_own_header(self):
        header = LICENCE + "#pragma once\n"
        files = {"src/luxel/scene/a.h": header, "src/luxel/scene/a.cpp": LICENCE + '#include "luxel/scene/a.h"\n'}
        self.assertEqual(self.found(files), [])
        files["src/luxel/scene/a.cpp"] = LICENCE + '#include <vector>\n#include "luxel/scene/a.h"\n'
        self.check(files, "src/luxel/scene/a.cpp", 2, "its own header comes first")

    def test_an_include_relative_to_the_file_is_refused(self):
        self.check_line("core", '#include "vector.h"', "from the root of the sources")

    def test_a_machine_path_is_found(self):
        self.check_line("core", 'auto p = "/' + 'tmp/x.png";', "a place on one machine")
        self.check({"docs/a.md": "see /" + "home/someone/luxel\n"}, "docs/a.md", 1, "a place on one machine")

    def test_a_folder_that_is_no_module_is_found(self):
        self.check_line("cellar", '#include "luxel/core/vector.h"', "no luxel_module(...)")

    def test_modules_depend_on_modules_above_them(self):
        files = {"src/luxel/scene/uses.cpp": None, "src/luxel/image/a.cpp": LICENCE + '#include "luxel/core/vector.h"\n'}
        self.check(files, "CMakeLists.txt", 1, "no module above it",
                   "luxel_module(image DEPENDS core)\nluxel_module(core LIBRARIES glm::glm)\n")

    def test_a_library_has_one_home(self):
        self.check({}, "CMakeLists.txt", 4, "at home in core already", MODULES + "luxel_module(import LIBRARIES glm::glm)\n")

    def test_a_library_nobody_knows_is_found(self):
        self.check({}, "CMakeLists.txt", 4, "unknown", MODULES + "luxel_module(import LIBRARIES Boost::boost)\n")

    def test_the_first_lines_name_the_licence_and_headers_open_once(self):
        self.check({"src/luxel/core/a.h": "#pragma once\n"}, "src/luxel/core/a.h", 1, "SPDX")
        self.check({"src/luxel/core/a.h": LICENCE}, "src/luxel/core/a.h", 1, "#pragma once")

    def test_a_long_file_is_found(self):
        self.check({"src/luxel/core/a.cpp": LICENCE + "int a;\n" * 400}, "src/luxel/core/a.cpp", 401, "two ideas")

    def test_a_folder_that_says_nothing_is_found(self):
        self.check({"tests/utils/a.cpp": LICENCE}, "tests/utils/a.cpp", 1, "says nothing")

    def test_large_binary_files_stay_in_the_images_of_the_documents(self):
        data = b"\0" * (201 * 1024)
        self.check({"docs/images/a.png": data, "scenes/a.bin": data}, "scenes/a.bin", 1, "binary data")


if __name__ == "__main__":
    unittest.main()
