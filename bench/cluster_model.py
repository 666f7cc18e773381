#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Model of a solve on many ranks, tested on 2 to 4 of this machine: cluster_model.py [--program P] [SCENE OPTIONS]...

  cluster_model.py "scenes/cornell-box.obj --max-edge 0.02 --error-measure power --error 0.5%"

The pieces are measured in short runs, with twice the error and four times, on one to three ranks of one thread:

  processor seconds per patch and round that every rank spends, so that they do not fall with the ranks
  bytes that each of P ranks receives: a number per patch and round and a number per patch and sweep, both times
  1 - 1/P; and a number per ray of each answer, times (1 - 1/P) / P, since a ray also counts for the patch that it meets

A run of one rank at the full error gives rays, rounds, sweeps and processor seconds, which do not depend on the number of
ranks. From these the model predicts each rank's rays, bytes and processor seconds (without those of waiting) for 2, 3 and 4
ranks, the wall time of the light for 2, and all of it for up to 1,000 ranks of 64 threads. Printed is the predicted value
over the mean of the ranks, and over that of the rank with most and with least. Needs numpy.
"""
import argparse
import json
import math
import os
import shlex
import subprocess
import tempfile

import numpy as np

DEFAULT_CASES = ["scenes/cornell-box.obj --max-edge 0.02 --error-measure power --error 0.4%",
                 "scenes/cornell-box.obj --max-edge 0.01 --error 2%"]
REPETITIONS = 3  # the fastest counts: other work on the machine only slows runs down
SHORT = (4.0, 2.0)  # errors of the short runs, over the full one
ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

MEMORY_SPEED = 5e9  # bytes/s between ranks of one machine
NETWORK_SPEED = 10e9  # bytes/s into a node: 100 Gbit/s, less overhead
LATENCY = 5e-6  # s of a message between nodes
THREADS = 64  # of a rank of the cluster
BLOCK = 1024  # patch sides that one rank has at least


def solve(program, words, ranks, folder):
    """The fastest of some runs: figures of the light, of each rank and of the whole."""
    best = None
    for _ in range(REPETITIONS):
        report = os.path.join(folder, "a.json")
        launch = ["mpirun", "--oversubscribe", "--bind-to", "none", "-n", str(ranks)] if ranks > 1 else []
        subprocess.run([*launch, program, "bake", *words, "--mesh-error", "none", "--threads", "1", "--quiet",
                        "-o", os.path.join(folder, "a.vtkhdf"), "--json-file", report],
                       check=True, stdout=subprocess.DEVNULL,
                       env=os.environ | {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"})
        with open(report, encoding="utf-8") as file:
            run = json.load(file)
        seconds = next(stage["seconds"] for stage in run["stages"] if stage["name"] == "light")
        # A process that is alone has one thread, so its processor seconds are those of the light.
        each = run["solve"]["ranks"]["each"] if ranks > 1 else [{"processor_seconds": seconds}]
        busy = sum(rank["processor_seconds"] for rank in each) / ranks
        if best is None or busy < best["busy"]:
            best = {"busy": busy, "seconds": seconds, "each": each, "rays": run["solution"]["rays"],
                    "patches": run["solution"]["patches"], "rounds": len(run["solve"]["rounds"]),
                    "sweeps": sum(entry["sweeps"] for entry in run["solve"]["rounds"]),
                    "answered_rays": sum(entry["rays"] for entry in run["solve"]["rounds"]),
                    "exchanges": each[0].get("exchanges", 0)}
        else:
            best["seconds"] = min(best["seconds"], seconds)
    return best


def byte_terms(run, ranks):
    """What the bytes that a rank receives are proportional to: see above."""
    of_others = 1.0 - 1.0 / ranks
    return [run["patches"] * run["rounds"] * of_others, run["patches"] * run["sweeps"] * of_others,
            run["answered_rays"] * of_others / ranks]


def factors_of(terms, values):
    """By least squares, none below 0: a term that would be is left out."""
    terms, used = np.array(terms), np.ones(len(terms[0]), bool)
    while True:
        factors = np.zeros(len(used))
        factors[used] = np.linalg.lstsq(terms[:, used], np.array(values), rcond=None)[0]
        if factors.min() >= 0.0:
            return factors
        used[factors.argmin()] = False


def mean(rank_records, key):
    return sum(record[key] for record in rank_records) / len(rank_records)


def measured_pieces(program, words, folder):
    at = words.index("--error") + 1
    error = float(words[at].rstrip("%"))
    runs = []
    for factor in SHORT:
        short = [*words[:at], f"{factor * error}%", *words[at + 1:]]
        runs.append([solve(program, short, ranks, folder) for ranks in (1, 2, 3)])
    alike = sum(max(0.0, 2.0 * two["busy"] - one["busy"]) for one, two, _ in runs)
    patch = alike / sum(two["patches"] * two["rounds"] for _, two, _ in runs)
    some = [(run, ranks) for _, *of_several in runs for run, ranks in zip(of_several, (2, 3))]
    factors = factors_of([byte_terms(run, ranks) for run, ranks in some],
                         [mean(run["each"], "received_bytes") for run, _ in some])
    two = runs[-1][1]
    return {"patch": patch, "bytes": factors, "exchanges": two["exchanges"] / (two["rounds"] + two["sweeps"])}


def prediction(pieces, one, ranks):
    alike = pieces["patch"] * one["patches"] * one["rounds"]
    received = float(pieces["bytes"] @ byte_terms(one, ranks))
    busy = (one["busy"] - alike) / ranks + alike
    return {"rays": one["rays"] / ranks, "received_bytes": received, "processor_seconds": busy,
            "seconds": busy + received / MEMORY_SPEED}


def compare(pieces, one, ranks, run):
    expected = prediction(pieces, one, ranks)
    text = []
    for key in ("rays", "received_bytes", "processor_seconds"):
        values = [rank[key] for rank in run["each"]]
        whole = expected[key] / mean(run["each"], key)
        text.append(f"{whole:.3f} ({expected[key] / max(values):.2f}, {expected[key] / min(values):.2f})")
    wall = f"{expected['seconds'] / run['seconds']:6.2f}" if ranks == 2 else ""
    print(f"{ranks:5} {text[0]:>20} {text[1]:>20} {text[2]:>20} {wall:>10}", flush=True)


def on_a_cluster(pieces, one, patches):
    """Prints the predicted seconds for a larger scene, with 1, 10 and 100 times the rays per patch of the case."""
    print(f"\n{patches:.0e} patches, {THREADS} threads a rank, predicted seconds\n"
          f"{'rays x':>7} {'ranks':>6} {'light':>8} {'rays':>8} {'in every':>9} {'exchange':>9} {'latency':>8}")
    larger = patches / one["patches"]
    for finer in (1, 10, 100):
        more = math.log2(finer) / 2.0  # of rounds, which grow fourfold at most
        rounds = one["rounds"] + more
        run = {"patches": patches, "rounds": rounds, "sweeps": one["sweeps"] * rounds / one["rounds"],
               "answered_rays": one["answered_rays"] * finer * larger}
        alike = pieces["patch"] * patches * rounds / THREADS
        dealt = (one["busy"] - pieces["patch"] * one["patches"] * one["rounds"]) * finer * larger / THREADS
        for ranks in (1, 10, 100, 1000):
            working = min(ranks, max(1, 2 * patches // BLOCK))
            exchange = float(pieces["bytes"] @ byte_terms(run, ranks)) / NETWORK_SPEED
            latency = pieces["exchanges"] * (rounds + run["sweeps"]) * math.ceil(math.log2(ranks)) * LATENCY
            print(f"{finer:7} {ranks:6} {dealt / working + alike + exchange + latency:8.2f} {dealt / working:8.2f} "
                  f"{alike:9.2f} {exchange:9.2f} {latency:8.3f}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=os.path.join(ROOT, "build/release/bin/luxel"))
    parser.add_argument("cases", nargs="*", metavar="SCENE OPTIONS", default=DEFAULT_CASES)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        for case in options.cases:
            words = shlex.split(case)
            if "--error" not in words:
                parser.error(f"'{case}' has no --error, which the short runs are made with")
            pieces = measured_pieces(options.program, words, folder)
            one = solve(options.program, words, 1, folder)
            print(f"\n{case}\n{one['patches']} patches, {1e-6 * one['rays']:.1f} Mrays, {one['rounds']} rounds, "
                  f"{one['sweeps']} sweeps, {one['busy']:.2f} s on one rank\n"
                  f"in every rank {1e6 * pieces['patch']:.2f} us per patch and round; bytes: {pieces['bytes'][0]:.0f} per patch "
                  f"and round, {pieces['bytes'][1]:.0f} per patch and sweep, {pieces['bytes'][2]:.1f} per ray and answer; "
                  f"{pieces['exchanges']:.0f} exchanges per round or sweep\n\n"
                  f"predicted over measured: the mean of the ranks (that with most, with least)\n"
                  f"{'ranks':>5} {'rays':>20} {'bytes':>20} {'processor s':>20} {'wall time':>10}")
            for ranks in (2, 3, 4):
                compare(pieces, one, ranks, solve(options.program, words, ranks, folder))
            for patches in (10**6, 10**7):
                on_a_cluster(pieces, one, patches)


if __name__ == "__main__":
    main()
