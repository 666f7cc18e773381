# SPDX-License-Identifier: Apache-2.0
"""outside_project_test.py ROOT BUILD: installs Luxel, and has an outside project build and run the README's program."""
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


def main(root, build):
    def run(*command, folder):
        print("+", *command, flush=True)
        subprocess.run(command, cwd=folder, check=True)

    with tempfile.TemporaryDirectory() as folder:
        prefix, project = os.path.join(folder, "prefix"), os.path.join(folder, "project")
        os.makedirs(project)
        with open(os.path.join(root, "README.md"), encoding="utf-8") as readme:
            program = program_of(readme.read())
        with open(os.path.join(project, "room.cpp"), "w", encoding="utf-8") as file:
            file.write(program)
        shutil.copy(os.path.join(root, "tests/outside/CMakeLists.txt"), project)
        for name in ("cornell-box.obj", "cornell-box.mtl"):
            shutil.copy(os.path.join(root, "scenes", name), project)
        os.rename(os.path.join(project, "cornell-box.obj"), os.path.join(project, "room.obj"))
        run("cmake", "--install", build, "--prefix", prefix, folder=folder)
        run("cmake", "-S", ".", "-B", "build", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
            f"-DCMAKE_PREFIX_PATH={prefix}", "-DREADME_PROGRAM=room.cpp", folder=project)
        run("cmake", "--build", "build", folder=project)
        run(os.path.join(project, "build", "room"), folder=project)
        with open(os.path.join(project, "room-lit.glb"), "rb") as glb:
            assert glb.read(4) == b"glTF", "the program wrote no GLB"
        run(os.path.join(prefix, "bin", "luxel"), "--version", folder=project)


if __name__ == "__main__":
    main(os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2]))
