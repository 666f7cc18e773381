# SPDX-License-Identifier: Apache-2.0
"""outside_project_test.py ROOT BUILD [--whole]: outside projects consume Luxel in three ways.

find_package: Luxel is installed, and an outside project builds and runs the README's program; the examples build alone.
add_subdirectory and FetchContent: the project is configured; with --whole it is built and run too, which compiles Luxel
twice (or takes it from ccache).
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile


def program_of(readme):
    """The C++ block of the README that is a whole program, #include lines and all."""
    blocks = re.findall(r"```cpp\n(.*?)```", readme, re.S)
    programs = [block for block in blocks if "int main" in block]
    assert len(programs) == 1, f"the README has {len(programs)} programs, expected one"
    return programs[0]


def run(*command, folder):
    print("+", *command, flush=True)
    subprocess.run(command, cwd=folder, check=True)


def make_project(root, project):
    """The outside project with the README's program and the scene that it reads."""
    shutil.copytree(os.path.join(root, "tests/outside"), project)
    with open(os.path.join(root, "README.md"), encoding="utf-8") as readme:
        program = program_of(readme.read())
    with open(os.path.join(project, "room.cpp"), "w", encoding="utf-8") as file:
        file.write(program)
    shutil.copy(os.path.join(root, "scenes/cornell-box.obj"), os.path.join(project, "room.obj"))
    shutil.copy(os.path.join(root, "scenes/cornell-box.mtl"), project)


def consume(project, way, builds, *options):
    """Configures the project, and builds and runs it. No build type: Luxel must not choose one for it."""
    build = "build-" + way
    run("cmake", "-S", ".", "-B", build, "-G", "Ninja", f"-DBY={way}", "-DREADME_PROGRAM=room.cpp", *options, folder=project)
    if not builds:
        return
    run("cmake", "--build", build, folder=project)
    run(os.path.join(project, build, "room"), folder=project)
    result = os.path.join(project, "room-lit.glb")
    with open(result, "rb") as glb:
        assert glb.read(4) == b"glTF", "the program wrote no GLB"
    os.remove(result)


def main(root, build, whole):
    with tempfile.TemporaryDirectory() as folder:
        prefix, project = os.path.join(folder, "prefix"), os.path.join(folder, "project")
        make_project(root, project)
        run("cmake", "--install", build, "--prefix", prefix, folder=folder)
        consume(project, "find_package", True, f"-DCMAKE_PREFIX_PATH={prefix}")
        run("cmake", "-S", os.path.join(root, "examples"), "-B", "examples", "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={prefix}",
            folder=folder)
        run("cmake", "--build", "examples", folder=folder)
        run(os.path.join(folder, "examples", "view_factors"), os.path.join(root, "scenes/plates.obj"), folder=folder)
        run(os.path.join(prefix, "bin", "luxel"), "--version", folder=project)
        if os.path.isfile(os.path.join(build, "bin", "luxel-import")):
            run(os.path.join(prefix, "libexec", "luxel", "luxel-import"), "--help", folder=project)
        launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if whole and shutil.which("ccache") else []
        # -O2 in the flags, since the project has no build type.
        for way in ("add_subdirectory", "FetchContent"):
            consume(project, way, whole, f"-DLUXEL_SOURCE_DIR={root}", "-DCMAKE_CXX_FLAGS=-O2", *launcher)


if __name__ == "__main__":
    main(os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2]), "--whole" in sys.argv[3:])
