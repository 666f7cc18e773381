#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Accuracy of the reported time left: time_left.py [--program P] "SCENE [BAKE OPTIONS]"...

Bakes each scene with --progress json and compares the time left with what it turned out to be, in the stage "light".

  time_left.py scenes/cornell-box.obj "out/reading-room.obj --error 4%"

  seconds   the stage took
  first     when a time left was first reported, in % of the stage
  ratio     the worst ratio of the time left reported to the true one, after a tenth of the stage and until the last
            second or the last 3 % of it, whichever begins earlier; "none" where nothing was reported then
  when      at which percentage of the stage's time that was
  percent   the largest step backwards of the percentage shown, in percentage points
  rise      the largest rise of the time left over an earlier report, in % of the stage

Other work on the machine changes the figures: the time left is a prediction of wall time at the present speed.
"""
import argparse
import json
import os
import shlex
import subprocess
import sys
import tempfile
import time

STOPPED_EARLY = 3  # exit code: a run that --time or --rays ended is a result
IGNORED_SECONDS, IGNORED_SHARE = 1.0, 0.03  # of the end: whichever is longer
FIRST_SHARE = 0.1  # of the stage, which is not judged


def watched(program, scene, folder):
    """Lines of the stage "light" as (seconds since it began, share done, time left or None), and its seconds."""
    command = [program, "bake", *shlex.split(scene), "--progress", "json", "--json", "--quiet",
               "-o", os.path.join(folder, "light.vtkhdf")]
    with open(os.path.join(folder, "report.json"), "wb") as report:
        process = subprocess.Popen(command, stdout=report, stderr=subprocess.PIPE, text=True)
        lines, other = [], []
        for text in process.stderr:
            now = time.monotonic()
            if not text.startswith("{"):
                other.append(text)
                continue
            line = json.loads(text)
            if line["stage"] == "light":
                lines.append((now, line))
    if process.wait() not in (0, STOPPED_EARLY):
        raise RuntimeError(f"{' '.join(command)}:\n{''.join(other)}")
    with open(os.path.join(folder, "report.json"), encoding="utf-8") as report:
        stages = json.load(report)["stages"]
    begin = lines[0][0]
    return [(now - begin, line["done"], left_of(line, now - begin)) for now, line in lines], next(
        stage["seconds"] for stage in stages if stage["name"] == "light")


def left_of(line, seconds):
    """The time left as the console shows it, also for programs that did not write it into the line."""
    if "seconds_left" in line:
        return line["seconds_left"]
    done = line["done"]
    return seconds / done * (1 - done) if done > 0.01 and "seconds" not in line else None


def judged(lines, seconds):
    end = seconds - max(IGNORED_SECONDS, IGNORED_SHARE * seconds)
    worst, when = None, 0.0
    most_done = percent = rise = 0.0
    lowest = float("inf")
    for now, done, left in lines:
        percent = max(percent, most_done - done)
        most_done = max(most_done, done)
        if left is None:
            continue
        rise = max(rise, left - lowest)
        lowest = min(lowest, left)
        if FIRST_SHARE * seconds <= now <= end:
            ratio = max(left, 1e-3) / (seconds - now)
            if worst is None or max(ratio, 1 / ratio) > max(worst, 1 / worst):
                worst, when = ratio, now
    first = next((now for now, _, left in lines if left is not None), seconds)
    return {"seconds": f"{seconds:.1f}", "first": f"{100 * first / seconds:.0f} %",
            "ratio": "none" if worst is None else f"{worst:.2f}", "when": f"{100 * when / seconds:.0f} %",
            "percent": f"{100 * percent:.0f}", "rise": f"{100 * rise / seconds:.0f} %"}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="build/release/bin/luxel",
                        help="the luxel to run (default: %(default)s)")
    parser.add_argument("--lines", metavar="FILE",
                        help="append every line: scene, seconds, done, time left, true time left")
    parser.add_argument("scenes", nargs="+", metavar='"SCENE [OPTIONS]"')
    arguments = parser.parse_args()
    print("| scene | seconds | first | ratio | when | percent | rise |\n|---|---|---|---|---|---|---|", flush=True)
    for scene in arguments.scenes:
        with tempfile.TemporaryDirectory() as folder:
            try:
                lines, seconds = watched(arguments.program, scene, folder)
            except RuntimeError as error:
                sys.exit(str(error))
        row = judged(lines, seconds)
        file, *options = scene.split(" ", 1)
        print("|", " | ".join([" ".join([os.path.basename(file), *options]), *row.values()]), "|", flush=True)
        if arguments.lines:
            with open(arguments.lines, "a", encoding="utf-8") as out:
                for now, done, left in lines:
                    shown = "" if left is None else round(left, 2)
                    out.write(f"{scene}\t{now:.2f}\t{done:.4f}\t{shown}\t{seconds - now:.2f}\n")


if __name__ == "__main__":
    main()
