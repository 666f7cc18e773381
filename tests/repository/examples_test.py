# SPDX-License-Identifier: Apache-2.0
"""examples_test.py ROOT EXAMPLES LUXEL: runs the example programs and checks what they compute."""
import os
import re
import struct
import subprocess
import sys
import tempfile


def numbers(pattern, text):
    """The numbers that the pattern's groups have, line by line."""
    found = [tuple(float(number) for number in match) for match in (m.groups() for m in re.finditer(pattern, text))]
    assert found, f"expected {pattern} in:\n{text}"
    return found


def main(root, examples, luxel):
    scenes = os.path.join(root, "scenes")
    with tempfile.TemporaryDirectory() as folder:
        def run(*command):
            print("+", *command, flush=True)
            output = subprocess.run(command, cwd=folder, check=True, capture_output=True, text=True).stdout
            print(output, end="", flush=True)
            return output

        def example(name, *arguments):
            return run(os.path.join(examples, name), *arguments)

        # The lamp has 1 m² and 60 W/m² of red; a room of 4 x 3 x 5 m is cut into several hundred patches.
        [(patches, rays, error)] = numbers(r"patches (\d+), rays (\d+), error ([\d.]+)", example("bake_from_arrays"))
        assert patches > 500 and rays > 0 and 0.0 < error <= 0.02, (patches, rays, error)
        with open(os.path.join(folder, "bake_from_arrays.png"), "rb") as png:
            assert struct.unpack(">II", png.read(24)[16:24]) == (640, 480), "the picture has another size"
        with open(os.path.join(folder, "bake_from_arrays.glb"), "rb") as glb:
            assert glb.read(4) == b"glTF", "the mesh is no GLB"

        dimmed = numbers(r"dimmer ([\d.]+): ([\d.]+) W/m2", example("relight_in_a_loop", os.path.join(scenes, "cornell-box.obj")))
        full = dimmed[0][1]
        assert len(dimmed) == 6 and full > 0.0, dimmed
        for dimmer, light in dimmed:
            assert abs(light - dimmer * full) < 1e-4 * full, f"dimmer {dimmer}: {light}, expected {dimmer * full}"

        factors = example("view_factors", os.path.join(scenes, "plates.obj"))
        [(exact,)] = numbers(r"in closed form: ([\d.]+)", factors)
        for (factor,) in numbers(r"(?:hot -> cold|cold -> hot): ([\d.]+)", factors):
            assert abs(factor - exact) < 2e-5, f"{factor}, expected {exact}"

        run(luxel, "bake", os.path.join(scenes, "cornell-box.obj"), "--max-edge", "0.05", "--error", "5%", "-o", "box.vtkhdf")
        text = example("read_solution", "box.vtkhdf")
        assert text.startswith("method sampled, "), text
        areas = dict(re.findall(r"^(\w+): ([\d.]+) m2", text, re.M))
        # The right wall of the box is 0.5488 x 0.5592 m.
        assert abs(float(areas["green"]) - 0.5488 * 0.5592) < 1e-3, areas
        refused = subprocess.run([os.path.join(examples, "read_solution"), "nothing.vtkhdf"], cwd=folder, capture_output=True,
                                 text=True, check=False)
        assert refused.returncode == 1 and "nothing.vtkhdf" in refused.stderr, refused


if __name__ == "__main__":
    main(*(os.path.abspath(argument) for argument in sys.argv[1:4]))
