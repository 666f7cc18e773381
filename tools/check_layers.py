#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the sources against the project's structure: check_layers.py [ROOT].

The luxel_module(...) lines of CMakeLists.txt define the modules, their order, the modules that each includes, and the
home of each outside library. Prints each violation as file:line: sentence. Exit status: 1 if there is one.
"""
import os
import re
import subprocess
import sys


def read_libraries():
    """Target, without its namespace -> the includes it provides, allowed in its home module only."""
    with open(os.path.join(os.path.dirname(__file__), "..", "cmake", "outside_libraries.txt"), encoding="utf-8") as file:
        lines = [line.split() for line in file if line.strip() and not line.startswith("#")]
    return {target.split("::")[-1]: pattern for target, pattern in lines}


LIBRARIES = read_libraries()
# The program and the Python module are no luxel_module(...): each links these in its own CMakeLists.txt and may include
# all modules. JSON has two homes: the library's core/json.h, and the program. Assimp is linked by the program luxel-import,
# a folder of module import.
TOPMOST = ("cli", "python")
HOMES_OUTSIDE_MODULES = {"CLI11": "cli", "nlohmann_json": "cli", "pybind11": "python", "assimp": "import"}
# What signs results with the program's version.
USES_VERSION = TOPMOST + ("runs",)
EVERYWHERE = r"fmt/"
# Embree requires two bits of the SSE control register to be set in each thread.
INTRINSICS = {"xmmintrin.h", "pmmintrin.h", "immintrin.h"}
# POSIX and Linux, in one module: a port to another system begins there.
SYSTEM = {"fcntl.h", "malloc.h", "poll.h", "unistd.h", "termios.h", "sys/file.h", "sys/ioctl.h", "sys/mman.h", "sys/prctl.h",
          "sys/resource.h", "sys/stat.h", "sys/types.h", "sys/wait.h"}
SYSTEM_HOME = "core"
STANDARD = set("""algorithm any array atomic barrier bit bitset cassert ccomplex cctype cerrno cfenv cfloat charconv chrono
cinttypes climits clocale cmath compare complex concepts condition_variable coroutine csetjmp csignal cstdarg cstddef
cstdint cstdio cstdlib cstring ctime cuchar cwchar cwctype deque exception execution filesystem format forward_list
fstream functional future initializer_list iomanip ios iosfwd iostream istream iterator latch limits list locale map
memory memory_resource mutex new numbers numeric optional ostream queue random ranges ratio regex scoped_allocator
semaphore set shared_mutex source_location span sstream stack stdexcept stop_token streambuf string string_view
syncstream system_error thread tuple type_traits typeindex typeinfo unordered_map unordered_set utility valarray variant
vector version""".split())

SOURCE = (".h", ".cpp", ".py", ".sh", ".mjs", ".cmake")
LICENSED = (".h", ".cpp", ".py", ".sh", ".mjs")
MACHINE_PATH = re.compile(r"(?<![\w.}>~])/(?:work|root|home|tmp)/")
FACELESS = {"util", "utils", "common", "misc"}
PUBLIC = "include/luxel/"  # the folder of the public headers, which outside projects include
MAX_PUBLIC = 60
MAX_LINES = 400
MAX_PARAMETERS = 6
# A type with or without a name and a default: "const Solution& light", "int count = 1", "Vec3*".
PARAMETER = re.compile(r"(?:const\s+)?(?:[\w:]+|std::function)(?:<.*>)?(?:\s*const)?"
                       r"(?:\s*[&*]+\s*\w*|\s+\w+)?(?:\[\w*\])?(?:\s*=.*)?$", re.DOTALL)
ONE_FILE_EACH = "integrations/"  # an add-on is installed in other programs as one file, however long
MAX_BINARY = 200 * 1024


class Module:
    def __init__(self, name, line, arguments):
        self.name, self.line, self.lists = name, line, {"DEPENDS": [], "LIBRARIES": []}
        into = None
        for word in arguments.split():
            if word in self.lists:
                into = self.lists[word]
            elif into is not None:
                into.append(word.split("::")[-1])
        self.depends, self.libraries = self.lists["DEPENDS"], self.lists["LIBRARIES"]


def read_modules(text):
    """The luxel_module(...) lines in their order, each with its line number."""
    text = re.sub(r"#[^\n]*", "", text)
    found = re.finditer(r"^\s*luxel_module\(\s*(\w+)([^)]*)\)", text, re.MULTILINE)
    return [Module(m[1], text.count("\n", 0, m.start(1)) + 1, m[2]) for m in found]


def files_of(root):
    """Everything git tracks or would track; without git, everything outside of the folders a build makes."""
    command = ["git", "-c", f"safe.directory={root}", "-C", root, "ls-files", "-z", "-co", "--exclude-standard"]
    try:
        names = subprocess.run(command, capture_output=True, check=True).stdout.decode().split("\0")
    except (OSError, subprocess.CalledProcessError):
        names = []
        for folder, folders, files in os.walk(root):
            folders[:] = [f for f in folders if f not in (".git", "build", "out", "node_modules")]
            names += [os.path.relpath(os.path.join(folder, f), root) for f in files]
    return sorted(n for n in names if n and os.path.isfile(os.path.join(root, n)))


def check_modules(modules):
    """Each module stands on modules above it, each library has one home that this script knows."""
    above, home = set(), {}
    for module in modules:
        for depend in module.depends:
            if depend not in above:
                yield "CMakeLists.txt", module.line, f"{module.name} depends on {depend}, which is no module above it"
        for library in module.libraries:
            if library not in LIBRARIES:
                yield ("CMakeLists.txt", module.line,
                       f"which includes {library} brings is unknown: add it to cmake/outside_libraries.txt")
            if library in home:
                yield "CMakeLists.txt", module.line, f"{library} is at home in {home[library]} already, not in {module.name}"
            home.setdefault(library, module.name)
        above.add(module.name)


class Includes:
    """The permitted includes, derived from the modules."""

    def __init__(self, root, modules):
        self.root = root
        self.modules = {module.name: module for module in modules}
        self.used = set()  # pairs of a module and one that it includes, as far as complaint() has seen
        homes = {library: module.name for module in reversed(modules) for library in module.libraries}
        self.homes = [(pattern, library, homes.get(library, "no module")) for library, pattern in LIBRARIES.items()
                      if library in homes or library not in HOMES_OUTSIDE_MODULES]
        self.homes += [(LIBRARIES[library], library, home) for library, home in HOMES_OUTSIDE_MODULES.items()]

    def complaint(self, module, include, quoted):
        """The violation of an include line of a module, or None."""
        if include.startswith("luxel/"):
            return self.complaint_about_ours(module, include)
        if re.match(EVERYWHERE, include) or include in STANDARD or include in INTRINSICS:
            return None
        if include in SYSTEM:
            return None if module == SYSTEM_HOME else f"<{include}> is of the system, whose only home is {SYSTEM_HOME}, not {module}"
        homes = [(library, home) for pattern, library, home in self.homes if re.match(pattern, include)]
        if homes:
            welcome = [home for _, home in homes]
            return None if module in welcome else (f"<{include}> is of {homes[0][0]}, whose only home is "
                                                 f"{' and '.join(welcome)}, not {module}")
        if quoted:
            return f'"{include}" should be written from the root of the sources: "luxel/{module}/..."'
        return f"<{include}> is neither of the C++ standard library nor of a library with a home module"

    def complaint_about_ours(self, module, include):
        if not any(os.path.isfile(os.path.join(self.root, folder, include)) for folder in ("include", "src")):
            return f'"{include}" does not exist'
        if include.count("/") == 1:  # luxel/luxel.h and luxel/version.h belong to no module
            return None if module in USES_VERSION else f'"{include}" is for users of the library: include the headers of modules'
        other = include.split("/")[1]
        if other == module or module in TOPMOST and other not in TOPMOST:
            return None
        if other in TOPMOST:
            return f"{other} is a program: nothing includes it"
        if module not in self.modules:
            return f"src/luxel/{module} is no luxel_module(...) of CMakeLists.txt"
        if other in self.modules[module].depends:
            self.used.add((module, other))
            return None
        return f"{module} may not include {other}: its DEPENDS are {' '.join(self.modules[module].depends) or 'empty'}"


def check_unused(modules, used):
    """A declared dependency that no include uses. used: see Includes."""
    for module in modules:
        for depend in module.depends:
            if (module.name, depend) not in used:
                yield "CMakeLists.txt", module.line, f"{module.name} declares {depend} and includes nothing of it"


def check_readmes(root, modules):
    """Each module's folder has a description."""
    for name in [module.name for module in modules] + list(TOPMOST):
        if not os.path.isdir(os.path.join(root, "src/luxel", name)):
            continue
        if not os.path.isfile(os.path.join(root, "src/luxel", name, "README.md")):
            yield f"src/luxel/{name}", 1, "the folder lacks a README.md: what comes in, what goes out, what to read first"


def check_includes(name, lines, includes):
    match = re.match(r"(?:src|include)/luxel/(\w+)/", name)
    if not match:
        return
    for number, line in enumerate(lines, 1):
        include = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
        complaint = include and includes.complaint(match[1], include[2], include[1] == '"')
        if complaint:
            yield name, number, complaint


def check_types(root):
    """Type names are unique: two types of one name in one namespace are a silent error where both are linked."""
    homes = {}
    for name in files_of(root):
        if not re.match(r"(src|include)/luxel/.*\.h$", name):
            continue
        with open(os.path.join(root, name), encoding="utf-8") as file:
            for number, line in enumerate(file, 1):
                found = re.match(r"(?:class|struct|enum class|enum|using|union)\s+(\w+)\b(?!\s*;)", line)
                if not found or found[1] == "namespace":
                    continue
                if homes.setdefault(found[1], name) != name:
                    yield name, number, f"{homes[found[1]]} has a type {found[1]} already"


def check_own_header(root, name, lines):
    """A source begins with its own header, which is thus compiled without preceding includes."""
    own = re.sub(r"^src/(.*)\.cpp$", r"\1.h", name)
    if own == name or not any(os.path.isfile(os.path.join(root, folder, own)) for folder in ("include", "src")):
        return
    for number, line in enumerate(lines, 1):
        if re.match(r"\s*#\s*include", line):
            if f'"{own}"' not in line:
                yield name, number, f'its own header comes first: #include "{own}"'
            return


def split_parameters(text):
    """The parts between commas that stand in no brackets."""
    parts, depth = [""], 0
    for character in text:
        depth += (character in "([{<") - (character in ")]}>")
        if character == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += character
    return [part.strip() for part in parts]


def check_parameters(name, lines):
    """Functions with many parameters take a struct of them."""
    text = re.sub(r"//[^\n]*|'(?:\\.|[^'\\\n])'|\"(?:\\.|[^\"\\\n])*\"", "", "\n".join(lines))
    opened = []
    for place, character in enumerate(text):
        if character == "(":
            opened.append(place)
        elif character == ")" and opened:
            begin = opened.pop()
            inside = text[begin + 1:place]
            is_function = re.match(r"\s*(?:[;{:=]|const\b|override\b|->|noexcept\b)", text[place + 1:])
            if inside.count(",") < MAX_PARAMETERS or not is_function:
                continue
            parts = split_parameters(inside)
            named = sum(re.search(r"[\w>&*]\s+[&*]*\w+", part) is not None for part in parts)
            if len(parts) > MAX_PARAMETERS and 2 * named > len(parts) and all(map(PARAMETER.match, parts)):
                yield (name, text.count("\n", 0, begin) + 1,
                       f"{len(parts)} parameters: more than {MAX_PARAMETERS} become a struct with named members")


def check_text(name, lines):
    """Rules for every text file of any module."""
    if name.endswith(SOURCE) and len(lines) > MAX_LINES and not name.startswith(ONE_FILE_EACH):
        yield name, len(lines), f"the file has {len(lines)} lines, the longest may have {MAX_LINES}: it holds two ideas"
    if name.endswith(LICENSED) and not any("SPDX-License-Identifier: Apache-2.0" in line for line in lines[:3]):
        yield name, 1, "the first lines lack SPDX-License-Identifier: Apache-2.0"
    if name.endswith(".h") and "#pragma once" not in lines:
        yield name, 1, "the header lacks #pragma once"
    if name != "LICENSE" and not name.endswith(".json"):
        for number, line in enumerate(lines, 1):
            path = MACHINE_PATH.search(line)
            if path:
                yield name, number, f"{path[0]} is a place on one machine: name it from the root of the project"


def check_file(root, name, includes):
    faceless = FACELESS.intersection(name.split("/")[:-1])
    if faceless:
        yield name, 1, f"a folder named {faceless.pop()} says nothing about what is in it"
    with open(os.path.join(root, name), "rb") as file:
        content = file.read()
    if b"\0" in content[:8000]:
        if len(content) > MAX_BINARY and not name.startswith("docs/images/"):
            yield name, 1, f"{len(content) // 1024} KB of binary data: only docs/images holds more than {MAX_BINARY // 1024}"
        return
    lines = content.decode(errors="replace").splitlines()
    yield from check_text(name, lines)
    if name.endswith((".h", ".cpp")):
        yield from check_includes(name, lines, includes)
        yield from check_own_header(root, name, lines)
        if name.startswith(("src/", "include/")):
            yield from check_parameters(name, lines)


def check_public(root):
    """Public headers include public headers alone, and there are not too many of them."""
    public = [name for name in files_of(root) if name.startswith(PUBLIC) and name.endswith(".h")]
    if len(public) > MAX_PUBLIC:
        yield PUBLIC, 1, f"{len(public)} public headers: {MAX_PUBLIC} is the limit"
    for name in public:
        with open(os.path.join(root, name), encoding="utf-8") as file:
            for number, line in enumerate(file, 1):
                include = re.match(r'#include "(luxel/.+)"', line)
                if include and not os.path.isfile(os.path.join(root, "include", include[1])):
                    yield name, number, f'"{include[1]}" is not public: no outside project has it'


def violations(root):
    with open(os.path.join(root, "CMakeLists.txt"), encoding="utf-8") as file:
        modules = read_modules(file.read())
    if not modules:
        yield "CMakeLists.txt", 1, "there is no luxel_module(...) line"
    yield from check_modules(modules)
    yield from check_readmes(root, modules)
    includes = Includes(root, modules)
    for name in files_of(root):
        yield from check_file(root, name, includes)
    yield from check_unused(modules, includes.used)
    yield from check_public(root)
    yield from check_types(root)


def main():
    root = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(__file__), ".."))
    found = list(violations(root))
    for name, line, sentence in found:
        print(f"{name}:{line}: {sentence}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
