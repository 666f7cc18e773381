#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Cost of the Python module over the command: python_overhead.py [--pairs N] [--threads N] SCENE [BAKE OPTIONS]...

Bakes one scene by `luxel bake` and by `luxel.bake()` in a new interpreter, N times in turn, and compares the processor
time of the whole processes (user and system, all threads), which other work on the machine disturbs less than elapsed
time. Both write a solution file, which must have the same bytes. After ./dev python:

  bench/python_overhead.py scenes/cornell-box.obj --error 1%

Prints the ratio of each pair, their median and range, and their mean with its standard error; and what starting the
interpreter and `import luxel` take, which no longer bake takes more of.
"""
import argparse
import filecmp
import json
import os
import resource
import statistics
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
BAKE = ("import json, sys, luxel\n"
        "scene, out, options = sys.argv[1], sys.argv[2], json.loads(sys.argv[3])\n"
        "luxel.bake(scene, **options).save(out)\n")


def processor_seconds(words, environment):
    """CPU seconds of a process that has ended, with its threads."""
    def used():
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        return usage.ru_utime + usage.ru_stime
    before = used()
    subprocess.run(words, env=environment, stdout=subprocess.DEVNULL, check=True)
    return used() - before


def arguments_of(flags, threads):
    """--max-edge 0.1 -> {"max_edge": "0.1"}, as JSON for BAKE."""
    if len(flags) % 2 or not all(flag.startswith("--") for flag in flags[::2]):
        sys.exit(f"python_overhead.py: expected pairs of --OPTION and value, found {' '.join(flags)}")
    given = {flag[2:].replace("-", "_"): value for flag, value in zip(flags[::2], flags[1::2])}
    return json.dumps({**given, "threads": threads})


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=os.path.join(ROOT, "build/release/bin/luxel"))
    parser.add_argument("--module", default=os.path.join(ROOT, "build/python"), help="folder of the Python package")
    parser.add_argument("--python", default="/usr/bin/python3")
    parser.add_argument("--pairs", type=int, default=8)
    parser.add_argument("--threads", type=int, default=1, help="of both; one thread varies least (default 1)")
    parser.add_argument("scene")
    settings, flags = parser.parse_known_args()
    environment = {**os.environ, "PYTHONPATH": settings.module}
    with tempfile.TemporaryDirectory() as folder:
        outs = [os.path.join(folder, name) for name in ("command.vtkhdf", "python.vtkhdf")]
        command = [settings.program, "bake", settings.scene, *flags, "--threads", str(settings.threads), "--quiet",
                   "-o", outs[0]]
        module = [settings.python, "-c", BAKE, settings.scene, outs[1], arguments_of(flags, settings.threads)]
        start = min(processor_seconds([settings.python, "-c", "import luxel"], environment) for _ in range(5))
        pairs = []
        for number in range(settings.pairs):
            words = (command, module) if number % 2 == 0 else (module, command)  # neither is always the second
            first, second = (processor_seconds(each, environment) for each in words)
            pairs.append((first, second) if number % 2 == 0 else (second, first))
            print(f"command {pairs[-1][0]:.2f} s, Python {pairs[-1][1]:.2f} s, ratio {pairs[-1][1] / pairs[-1][0]:.4f}",
                  flush=True)
        same = filecmp.cmp(*outs, shallow=False)
    ratios = [python / program for program, python in pairs]
    error = statistics.stdev(ratios) / len(ratios) ** 0.5 if len(ratios) > 1 else float("nan")
    print(f"ratio: median {statistics.median(ratios):.4f} ({min(ratios):.4f} to {max(ratios):.4f}), "
          f"mean {statistics.mean(ratios):.4f} ± {error:.4f}; starting Python with luxel {start:.2f} s; "
          f"files {'are the same' if same else 'DIFFER'}")
    return 0 if same else 1


if __name__ == "__main__":
    sys.exit(main())
