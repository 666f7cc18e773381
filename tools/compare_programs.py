#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures Luxel beside other programs, at equal processor time: compare_programs.py BIN FOLDER [--quick] [SCENE...].

BIN has luxel and luxel-scenes. Writes FOLDER/comparison.json, .md, .svg and -pictures.png. Each scene has diffuse
surfaces, lamps with an area and an even sky; each program renders the same camera to linear radiance. The truth is the
mean of long runs of `luxel reference` and of Cycles, whose agreement is reported. A program that is not installed has a
row that states so. --quick: one tiny run of each, to see that all work; its numbers mean little.
Needs Debian's python3-numpy and python3-matplotlib.
"""
import argparse
import datetime
import json
import os
import platform
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
try:
    from comparison import programs, results
    from comparison.scenes import Scene
except ImportError as missing:
    sys.exit(f"compare_programs.py: {missing}: install Debian's python3-numpy and run it by /usr/bin/python3")

SCENES = ("cornell-box", "study", "stairwell", "art-gallery")
BUDGETS = (2, 5, 10, 20)  # s of processor time
LIMIT = 30  # s of processor time: after a run this long, a program's slower settings are not tried


def machine():
    """The processor's name and its number of cores."""
    name = platform.machine()
    if os.path.exists("/proc/cpuinfo"):
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            name = next((line.split(":")[1].strip() for line in file if line.startswith("model name")), name)
    return f"{name}, {os.cpu_count()} cores"


def truth_of(scene, luxel, cycles, wanted):
    """The truth, and the pictures' makers. Without Cycles: of Luxel alone, which is stated."""
    makers = [luxel] if cycles.problem() else [luxel, cycles]
    pairs = []
    for maker in makers:
        pairs.append([maker.render(scene, wanted.truth, seed)[0] for seed in (1001, 1002)])
        print(f"  truth by {maker.name}", flush=True)
    truth = results.Truth(pairs, scene.surfaces(wanted.width, wanted.height))
    return truth, {"by": " and ".join(maker.name for maker in makers), "samples": 2 * wanted.truth, **truth.agreement()}, \
        [("truth", sum(sum(pair) for pair in pairs) / (2 * len(pairs)))]


def measure(program, problem, scene, truth, wanted):
    """All runs of one program, and its last picture."""
    found, picture = {"program": program.name, "problem": problem, "runs": []}, None
    if problem is None:
        try:
            for label, setting in program.ladder(wanted.quick):
                picture, seconds = program.render(scene, setting, seed=1)
                found["runs"].append({"setting": label, "cpu_seconds": seconds, **truth.errors(picture)})
                print(f"  {program.name}, {label}: {seconds:.1f} s, {results.percent(found['runs'][-1]['rms'])}", flush=True)
                if seconds > LIMIT:
                    break
        except (RuntimeError, ValueError, OSError) as fault:
            found["problem"] = f"failed: {str(fault).splitlines()[0]}"
    if found["problem"]:
        print(f"  {program.name}: {found['problem']}", flush=True)
    return found, picture


def compare(wanted, folder):
    job = programs.Job(folder, wanted.width, wanted.height, wanted.threads)
    every = programs.all_of(job, os.path.join(wanted.bin, "luxel"))
    if every[0].problem():
        raise RuntimeError(f"luxel is {every[0].problem()}")
    problems = [program.problem() for program in every]
    measured = {"date": datetime.date.today().isoformat(), "machine": machine(), "threads": wanted.threads,
                "width": wanted.width, "height": wanted.height, "quick": wanted.quick, "budgets_s": BUDGETS, "scenes": []}
    pictures = []
    for name in wanted.scenes:
        print(name, flush=True)
        model = job.at(f"made-{name}.obj")
        subprocess.run([os.path.join(wanted.bin, "luxel-scenes"), name, model], check=True)
        scene = Scene(name, model)
        truth, agreement, row = truth_of(scene, every[1], every[2], wanted)
        found = {"scene": name, "triangles": len(scene.triangles), "compared_fraction": float(truth.surfaces.mean()),
                 "truth": agreement, "programs": []}
        for program, problem in zip(every, problems):
            of_program, picture = measure(program, problem, scene, truth, wanted)
            found["programs"].append(of_program)
            if picture is not None:
                row.append((f"{program.name}, {of_program['runs'][-1]['setting']}", picture))
        measured["scenes"].append(found)
        pictures.append(row)
        write(measured, pictures, wanted.folder)  # after each scene, so that a stopped run leaves what it has


def write(measured, pictures, folder):
    with open(os.path.join(folder, "comparison.json"), "w", encoding="utf-8") as file:
        json.dump(measured, file, indent=1)
    with open(os.path.join(folder, "comparison.md"), "w", encoding="utf-8") as file:
        file.write(results.markdown(measured))
    try:
        results.chart(measured, os.path.join(folder, "comparison.svg"))
        results.side_by_side(pictures, os.path.join(folder, "comparison-pictures.png"))
    except ImportError:
        print("  without chart and pictures: install Debian's python3-matplotlib")


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("bin")
    options.add_argument("folder")
    options.add_argument("scenes", nargs="*", metavar="SCENE", help=f"of luxel-scenes (default: {' '.join(SCENES)})")
    options.add_argument("--quick", action="store_true", help="one tiny run of each program, in the Cornell box")
    options.add_argument("--size", default="320x240", help="of the pictures, pixels (default: 320x240)")
    options.add_argument("--threads", type=int, default=os.cpu_count(), help="of each program (default: one per core)")
    options.add_argument("--truth", type=int, default=2048, help="paths per pixel of each of the four runs (default: 2048)")
    wanted = options.parse_intermixed_args()
    wanted.bin, wanted.folder = os.path.abspath(wanted.bin), os.path.abspath(wanted.folder)
    if wanted.quick:
        wanted.size, wanted.truth = "48x36", 64
    try:
        wanted.width, wanted.height = (int(word) for word in wanted.size.split("x"))
    except ValueError:
        options.error(f"--size {wanted.size}: expected WIDTHxHEIGHT, such as 320x240")
    wanted.scenes = wanted.scenes or (SCENES[:1] if wanted.quick else SCENES)
    os.makedirs(wanted.folder, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        try:
            compare(wanted, folder)
        except (RuntimeError, ValueError, subprocess.CalledProcessError) as fault:
            sys.exit(f"compare_programs.py: {fault}")
    print(f"written: {wanted.folder}/comparison.md, .json, .svg and comparison-pictures.png")


if __name__ == "__main__":
    main()
