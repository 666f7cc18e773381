#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Noise and cost of Luxel's pictures: picture_noise.py [OPTIONS] "SCENE [BAKE OPTIONS]"...

Bakes each scene with two seeds, everything else as it is when nobody asks for anything, and compares the two pictures.
The noise of a pixel is the difference between the seeds over the root of 2, in codes of 8-bit sRGB (0 to 255, not
rounded), in the channel where it is largest. Both pictures are shown with one exposure, so that exposure is no noise.

  picture_noise.py scenes/cornell-box.obj "out/window-room.obj --sky 1"
  picture_noise.py --bake "--error 2% --time 5min" out/bar.obj
  picture_noise.py --reference 8 scenes/cornell-box.obj

--reference N also compares the mean of N seeds with a converged picture: the mean of two runs of other seeds, each with
half of 64 times the rays (or --reference-factor) and without the smoothing of neighbours (--smoothing off). "edges" are the
pixels within 2 of a place where the converged picture changes by more than 4 codes from one pixel to the next: rims of
shadows and contacts, and with them the outlines of things. Needs numpy (Debian: python3-numpy).
"""
import argparse
import json
import os
import shlex
import subprocess
import sys
import tempfile

try:
    import numpy as np

    import pictures
except ImportError as error:
    sys.exit(f"{error}: install Debian's python3-numpy and run this with /usr/bin/python3")

NOISE_LIMIT = 2.0  # codes, that a pixel's noise may be
BIAS_LIMIT = 3.0  # codes, that the mean of seeds may be from the converged picture
EDGE_STEP, EDGE_REACH = 4.0, 2  # codes from pixel to pixel, and pixels around
FIRST_REFERENCE_SEED = 1001
STOPPED_EARLY = 3  # exit code: a run that --time or --rays ended is a result


class Bakes:
    """Runs of the program on one scene."""

    def __init__(self, program, scene, options, size, keep):
        self.command = [program, "bake", scene, *options, "--width", str(size[0]), "--height", str(size[1])]
        self.keep, self.name = keep, os.path.splitext(os.path.basename(scene))[0]

    def run(self, seed, *options):
        """The picture of one seed and the run's report, which gets `cpu_seconds` of the whole process."""
        picture = os.path.join(self.keep, f"{self.name}-{seed}.exr")
        command = [*self.command, *options, "--seed", str(seed), "-o", picture, "--json", "--quiet"]
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as warnings:
            with subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=out, stderr=warnings) as child:
                _, status, usage = os.wait4(child.pid, 0)
                child.returncode = os.waitstatus_to_exitcode(status)
            out.seek(0)
            warnings.seek(0)
            if child.returncode not in (0, STOPPED_EARLY):
                sys.exit(f"{shlex.join(command)}\nended with {child.returncode}\n{warnings.read().decode()}")
            report = json.load(out)
        report["cpu_seconds"] = usage.ru_utime + usage.ru_stime
        return pictures.read_exr(picture), report


def largest_channel(difference):
    return np.abs(difference).max(axis=2)


def preparation(report):
    """Seconds on the clock before the first ray."""
    return sum(s["seconds"] for s in report["stages"] if s["name"] in ("load", "patches", "hierarchy", "lamps"))


def noise_row(name, bakes):
    (a, one), (b, other) = bakes.run(1), bakes.run(2)
    exposure = pictures.exposure_of((a + b) / 2)
    noise = largest_channel(pictures.codes(a, exposure) - pictures.codes(b, exposure)) / np.sqrt(2)
    pictures.write_png(os.path.join(bakes.keep, f"{bakes.name}.png"), pictures.codes(a, exposure))
    error = one["solve"]["error"]
    return {"scene": name, "patches": one["solution"]["patches"],
            "rays": (one["solution"]["rays"] + other["solution"]["rays"]) / 2,
            "preparation": preparation(one), "cpu_seconds": (one["cpu_seconds"] + other["cpu_seconds"]) / 2,
            "stated_error": error["reached"], "stop_reason": error["stop_reason"],
            "off": float(np.mean(noise > NOISE_LIMIT)), "noise_99": float(np.percentile(noise, 99))}


def edges(shown):
    """Mask of the pixels near an edge."""
    steep = np.zeros(shown.shape[:2], bool)
    for axis in (0, 1):
        step = largest_channel(np.diff(shown, axis=axis)) > EDGE_STEP
        first, last = [(slice(None),) * axis + (cut,) for cut in (slice(None, -1), slice(1, None))]
        steep[first] |= step
        steep[last] |= step
    for _ in range(EDGE_REACH):
        near = steep.copy()
        near[1:] |= steep[:-1]
        near[:-1] |= steep[1:]
        near[:, 1:] |= steep[:, :-1]
        near[:, :-1] |= steep[:, 1:]
        steep = near
    return steep


def reference_row(name, bakes, count, factor):
    runs = [bakes.run(seed) for seed in range(1, count + 1)]
    rays = str(int(factor / 2 * runs[0][1]["solution"]["rays"]))
    converged = [bakes.run(seed, "--smoothing", "off", "--error", "0", "--rays", rays)
                 for seed in (FIRST_REFERENCE_SEED, FIRST_REFERENCE_SEED + 1)]
    truth = (converged[0][0] + converged[1][0]) / 2
    exposure = pictures.exposure_of(truth)
    shown = pictures.codes(truth, exposure)
    # One exposure: the error of the mean of two is half their difference.
    doubt = largest_channel(pictures.codes(converged[0][0], exposure) -
                            pictures.codes(converged[1][0], exposure)) / 2
    error = largest_channel(pictures.codes(np.mean([p for p, _ in runs], axis=0), exposure) - shown)
    at_edge = edges(shown)
    pictures.write_png(os.path.join(bakes.keep, f"{bakes.name}-converged.png"), shown)
    off = error > BIAS_LIMIT
    return {"scene": name, "seeds": count, "factor": factor, "edge_share": float(at_edge.mean()),
            "off": float(off.mean()), "off_at_edges": float(off[at_edge].mean()) if at_edge.any() else 0.0,
            "off_elsewhere": float(off[~at_edge].mean()) if not at_edge.all() else 0.0,
            "reference_noise_99": float(np.percentile(doubt, 99))}


def percent(value):
    return f"{100 * value:.3g} %"


NOISE_COLUMNS = {
    "scene": lambda r: r["scene"], "patches": lambda r: f"{r['patches']:,}", "Mrays": lambda r: f"{r['rays'] / 1e6:.1f}",
    "stated error": lambda r: percent(r["stated_error"]),
    "ended by": lambda r: r["stop_reason"],
    "preparation, s": lambda r: f"{r['preparation']:.2f}", "CPU s": lambda r: f"{r['cpu_seconds']:.1f}",
    f"pixels above {NOISE_LIMIT:g} codes": lambda r: percent(r["off"]),
    "99 % of pixels below, codes": lambda r: f"{r['noise_99']:.1f}"}
REFERENCE_COLUMNS = {
    "scene": lambda r: r["scene"], "seeds": lambda r: str(r["seeds"]), "rays of the converged": lambda r: f"{r['factor']:g} x",
    f"pixels above {BIAS_LIMIT:g} codes": lambda r: percent(r["off"]), "of edges": lambda r: percent(r["off_at_edges"]),
    "elsewhere": lambda r: percent(r["off_elsewhere"]), "edges": lambda r: percent(r["edge_share"]),
    "noise of the converged, 99 %, codes": lambda r: f"{r['reference_noise_99']:.1f}"}


def print_heading(columns):
    print("| " + " | ".join(columns) + " |\n" + "|---" * len(columns) + "|", flush=True)


def print_row(columns, row):
    print("| " + " | ".join(show(row) for show in columns.values()) + " |", flush=True)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="+", metavar="'SCENE [BAKE OPTIONS]'")
    parser.add_argument("--bake", default="", metavar="OPTIONS", help="options of `luxel bake` for all scenes")
    parser.add_argument("--program", default="build/release/bin/luxel", help="default: %(default)s")
    parser.add_argument("--width", type=int, default=960, help="of the picture, pixels; default: %(default)s")
    parser.add_argument("--height", type=int, default=720, help="default: %(default)s")
    parser.add_argument("--reference", type=int, default=0, metavar="N", help="seeds whose mean is held against a converged picture")
    parser.add_argument("--reference-factor", type=float, default=64, help="rays of the converged picture over those of a seed; default: %(default)s")
    parser.add_argument("--keep", metavar="DIR", help="where pictures stay; default: nowhere")
    parser.add_argument("--json", metavar="FILE", help="write the numbers as JSON too")
    return parser.parse_args()


def main():
    chosen = arguments()
    with tempfile.TemporaryDirectory() as scratch:
        keep = chosen.keep or scratch
        os.makedirs(keep, exist_ok=True)
        work = []
        for text in chosen.scenes:
            scene, *options = shlex.split(text)
            bakes = Bakes(chosen.program, scene, [*shlex.split(chosen.bake), *options], (chosen.width, chosen.height), keep)
            work.append((" ".join([bakes.name, *options]), bakes))
        rows = {"noise": [], "reference": []}
        print_heading(NOISE_COLUMNS)
        for name, bakes in work:
            rows["noise"].append(noise_row(name, bakes))
            print_row(NOISE_COLUMNS, rows["noise"][-1])
        if chosen.reference:
            print()
            print_heading(REFERENCE_COLUMNS)
        for name, bakes in work if chosen.reference else ():
            rows["reference"].append(reference_row(name, bakes, chosen.reference, chosen.reference_factor))
            print_row(REFERENCE_COLUMNS, rows["reference"][-1])
        if chosen.json:
            with open(chosen.json, "w", encoding="utf-8", newline="\n") as file:
                json.dump(rows, file, indent=2)


if __name__ == "__main__":
    main()
