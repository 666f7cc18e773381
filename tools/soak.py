#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Attacks on the built program, for hours if need be: ./dev soak [--minutes N] [ATTACK...].

Each attack goes on where it stopped: the seed of a try is its number. Totals are added up in
build/soak/totals.json; what was found is kept in build/soak/findings, with the command that shows it again.

An attack is a class: attempt(chance) makes one try with these random numbers, raises Finding, and returns what is to be
added to its totals. `at_once` tries run side by side. report(totals) is a sentence for the end.
"""

import argparse
import atexit
import json
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
STATE = ROOT / "build" / "soak"
CORES = len(os.sched_getaffinity(0))


class Finding(Exception):
    """A finding of an attack, as a sentence."""


def run(command, folder, **options):
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, errors="replace", **options)


def folder_of_box(prefix):
    """A new folder with the Cornell box in it."""
    folder = Path(tempfile.mkdtemp(prefix=prefix, dir=STATE))
    for name in ("cornell-box.obj", "cornell-box.mtl"):
        shutil.copy(ROOT / "scenes" / name, folder)
    return folder


# ---- Killed runs ----

BAKE = ["--max-edge", "0.08", "--rays", "3M", "--seed", "5", "--every", "0", "--mesh-error", "none"]


class Kills:
    """kill -9 at a random moment, again and again, until the run has ended: the same bytes, nothing left."""

    at_once = 1

    def __init__(self, luxel):
        self.luxel, self.expected, self.seconds = luxel, None, 0.0

    def command(self):
        return [self.luxel, "bake", "cornell-box.obj", *BAKE, "--checkpoint", "run.vtkhdf", "-o", "light.ply"]

    def prepare(self):
        folder = folder_of_box("kills-")
        begin = time.monotonic()
        result = run(self.command(), folder)
        if result.returncode != 0:
            raise SystemExit(f"the run that is to be killed fails by itself: {result.stderr}")
        self.seconds = time.monotonic() - begin
        self.expected = (folder / "light.ply").read_bytes()
        shutil.rmtree(folder)

    def attempt(self, chance):
        if self.expected is None:
            self.prepare()
        folder = folder_of_box("kills-")
        for attempt in range(100):
            process = subprocess.Popen(self.command(), cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
            try:
                process.wait(timeout=chance.uniform(0.0, 1.2 * self.seconds))
            except subprocess.TimeoutExpired:
                process.send_signal(signal.SIGKILL)
            message = process.communicate()[1].decode(errors="replace")
            if process.returncode == 0:
                break
            if process.returncode != -signal.SIGKILL:
                raise Finding(f"after {attempt} kills in {folder}: {message}")
        else:
            raise Finding(f"a hundred kills, and no progress: {folder}")
        if (folder / "light.ply").read_bytes() != self.expected:
            raise Finding(f"other bytes after {attempt} kills: {folder}")
        left = [path.name for path in folder.iterdir() if ".tmp" in path.name]
        if left:
            raise Finding(f"left behind after {attempt} kills: {left} in {folder}")
        shutil.rmtree(folder)
        return {"kills": attempt}

    @staticmethod
    def report(total):
        return f"{total.get('kills', 0)} kills"


# ---- Signals ----

class Signals:
    """SIGINT or SIGTERM at a random moment of many commands: each ends soon, with the documented exit code."""

    at_once = 1
    seconds = 1.0  # promised; ten times that is a finding, and the longest is kept in the totals
    bake = ["bake", "cornell-box.obj", "--max-edge", "0.01"]
    commands = (
        (*bake, "-o", "a.vtkhdf", "-o", "a.glb", "-o", "a.html", "-o", "a.png"),
        (*bake, "--mesh-error", "1%", "--checkpoint", "run.vtkhdf", "-o", "a.glb"),
        (*bake, "--method", "hemicube", "--force", "-o", "a.glb"),
        ("bake", "cornell-box.obj", "--max-edge", "0.06", "--method", "dense", "--force", "-o", "a.glb"),
        ("reference", "cornell-box.obj", "-o", "a.png"),
        ("viewfactors", "cornell-box.obj", "--max-edge", "0.02", "-o", "a.h5"),
        ("check", "cornell-box.obj", "--max-edge", "0.003"),
        ("export", "light.vtkhdf", "-o", "a.html", "-o", "a.glb"),
        ("render", "light.vtkhdf", "-o", "a.png", "--width", "4000", "--height", "3000"),
        ("lightmap", "light.vtkhdf", "-o", "a.png"),
        ("resume", "light.vtkhdf", "--error", "0.1%", "-o", "a.vtkhdf"),
    )

    def __init__(self, luxel):
        self.luxel, self.longest = luxel, 0.0
        self.folder = folder_of_box("signals-")
        atexit.register(shutil.rmtree, self.folder, ignore_errors=True)

    def attempt(self, chance):
        if not (self.folder / "light.vtkhdf").exists():
            run([self.luxel, *self.bake, "--error", "5%", "--store-transport", "-o", "light.vtkhdf"], self.folder)
        command = [self.luxel, *chance.choice(self.commands), "--quiet"]
        number = chance.choice((signal.SIGINT, signal.SIGTERM))
        with subprocess.Popen(command, cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as child:
            try:
                child.wait(chance.uniform(0.02, 10.0))
                return {}  # ended by itself
            except subprocess.TimeoutExpired:
                child.send_signal(number)
            begin = time.monotonic()
            try:
                child.wait(10.0 * self.seconds)
            except subprocess.TimeoutExpired:
                child.kill()
                raise Finding(f"`{' '.join(command)}` goes on 10 s after {number.name}") from None
        took = time.monotonic() - begin
        if took > max(self.longest, self.seconds):
            print(f"signals: {took:.2f} s after {number.name}: {' '.join(command)}", flush=True)
        self.longest = max(self.longest, took)
        if child.returncode not in (0, 3, -number):
            raise Finding(f"`{' '.join(command)}` ends with {child.returncode} after {number.name}")
        return {"signals": 1}

    @staticmethod
    def report(total):
        return f"{total.get('signals', 0)} signals"


# ---- Hours in the window ----


def random_action(chance):
    """A line or two of a script, docs/viewer.md."""
    x, y = chance.randrange(20, 620), chance.randrange(60, 460)
    fraction = f"{chance.uniform(0.1, 2.0):.2f}"
    return chance.choice((
        f"key {chance.choice('WASDQEFHKLPRTX123456789')}", f"hold {chance.choice('WASD')} 0.3", f"click {x} {y}",
        f"drag {x} {y} {chance.randrange(20, 620)} {y} {chance.choice(('left', 'right', 'middle'))}",
        f"wheel {chance.randrange(-3, 4)}", f"move {x} {y}", f"view {chance.uniform(-0.2, 0.2):.2f},0.3,1 0,0.27,0 50",
        f"set show {chance.choice(('light', 'irradiance', 'standard-error', 'patch-size', 'unshot', 'grey', 'sides'))}",
        f"set tone {chance.choice(('neutral', 'clamp', 'reinhard'))}", f"set exposure {fraction}",
        f"set {chance.choice(('wires', 'normals', 'boxes', 'rays', 'faults', 'panel', 'lux'))} {chance.choice(('on', 'off'))}",
        f"lamp lamp {fraction}", f"paint {chance.choice(('red', 'green', 'white'))} 0.{chance.randrange(1, 9)},0.5,0.5",
        f"bounces {chance.choice(('0', '1', '2', 'all'))}", "pause", "resume", "stop", f"error {chance.uniform(0.01, 0.1):.3f}",
        f"resize {chance.randrange(320, 800)} {chance.randrange(240, 600)}", "snapshot view.png", "save saved.glb",
        "save saved.vtkhdf", "picture 300 200 picture.png", "drop cornell-box.obj\nwait mesh\nwait light"))


class Window:
    """Random user actions in the window, the same ones over and over in one process: it goes on, and needs no more memory.

    A person who does something every ten seconds makes the 864 actions of a try in 2.4 hours."""

    at_once = 1
    blocks, actions = 8, 108
    tolerated = 8 * 1024 * 1024  # bytes, and a twentieth of the whole: free space between blocks in use

    def __init__(self, luxel):
        self.luxel = luxel

    def attempt(self, chance):
        folder = folder_of_box("window-")
        begin = "drop cornell-box.obj\nwait mesh\nwait light\nresize 640 480\n"
        block = begin + "\n".join(random_action(chance) for _ in range(self.actions)) + "\n"
        marks = [folder / f"mark-{number}.png" for number in range(self.blocks)]
        script = "wait view\n" + "".join(f"{block}{begin}wait 10 frames\nsnapshot {mark.name}\nwait 20 frames\n" for mark in marks)
        (folder / "script.txt").write_text(script + "close\n")
        command = [self.luxel, "view", "cornell-box.obj", "--max-edge", "0.1", "--error", "10%", "--width", "640", "--height",
                   "480", "--off-screen", "--script", "script.txt"]
        # One heap: those of single threads keep blocks that others have freed, which looks like growth.
        environment = os.environ | {"MALLOC_ARENA_MAX": "1"}
        with open(folder / "messages.txt", "wb") as messages, \
                subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=messages, env=environment) as child:
            memory = self.memory_at(marks, child)
        if child.returncode != 0:
            raise Finding(f"the window ended with {child.returncode} in {folder}: "
                          f"{(folder / 'messages.txt').read_text(errors='replace')[-500:]}")
        first, last = min(memory[1:4]), min(memory[-3:])  # the first repetition fills caches
        if last - first > self.tolerated + first // 20:
            raise Finding(f"memory grew from {first >> 20} to {last >> 20} MiB over {self.blocks - 3} repetitions: {folder}")
        shutil.rmtree(folder)
        return {"actions": self.blocks * self.actions, "grown_bytes": last - first}

    @staticmethod
    def memory_at(marks, child):
        """Bytes that the process holds when each mark appears."""
        memory, page = [], os.sysconf("SC_PAGE_SIZE")
        while child.poll() is None and len(memory) < len(marks):
            if marks[len(memory)].exists():
                memory.append(int(Path(f"/proc/{child.pid}/statm").read_text().split()[1]) * page)
            time.sleep(0.02)
        child.wait()
        return memory + [0] * (len(marks) - len(memory))

    @staticmethod
    def report(total):
        return (f"{total.get('actions', 0)} actions, memory grew by {total.get('grown_bytes', 0) / max(total['tries'], 1) / 2**20:+.1f} "
                "MiB in the mean")


# ---- Random scenes against the path tracer ----


def random_box(chance, low, high):
    size = [chance.uniform(0.1, 0.5) * (h - l) for l, h in zip(low, high)]
    at = [chance.uniform(l, h - s) for l, h, s in zip(low, high, size)]
    return at, [a + s for a, s in zip(at, size)]


def box_faces(low, high, first, inwards):
    corners = [(x, y, z) for z in (low[2], high[2]) for y in (low[1], high[1]) for x in (low[0], high[0])]
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    if not inwards:
        quads = [tuple(reversed(quad)) for quad in quads]
    return corners, [tuple(first + index for index in quad) for quad in quads]


def random_scene(chance):
    """A closed room with boxes and a lamp below the ceiling: OBJ and MTL."""
    size = [chance.uniform(2.0, 6.0) for _ in range(3)]
    lines, materials, first = ["mtllib room.mtl"], [], 1

    def add(name, low, high, inwards, reflectance, radiance=0.0):
        nonlocal first
        corners, quads = box_faces(low, high, first, inwards)
        first += len(corners)
        lines.extend(f"v {x:.6f} {y:.6f} {z:.6f}" for x, y, z in corners)
        lines.extend([f"g {name}", f"usemtl {name}"])
        lines.extend("f " + " ".join(map(str, quad)) for quad in quads)
        colour = " ".join(f"{r:.4f}" for r in reflectance)
        materials.append(f"newmtl {name}\nKd {colour}\nKe {radiance} {radiance} {radiance}\n")

    def colour():
        return [chance.uniform(0.05, 0.85) for _ in range(3)]

    add("room", (0, 0, 0), size, True, colour())
    for number in range(chance.randrange(4)):
        add(f"box{number}", *random_box(chance, (0.05, 0.05, 0.05), [0.7 * s for s in size]), False, colour())
    low = [chance.uniform(0.2, 0.5) * s for s in size[:2]] + [size[2] - 0.12]
    add("lamp", low, [low[0] + 0.4, low[1] + 0.3, size[2] - 0.02], False, [0.5] * 3, 10.0)
    return "\n".join(lines) + "\n", "\n".join(materials)


class Scenes:
    """Solver and path tracer agree within their errors, in the mean over all patches."""

    at_once = CORES
    limit = 6.0  # standard errors; from some dozen replicates, so about one false alarm in 10,000 scenes

    def __init__(self, luxel):
        self.luxel = luxel

    def attempt(self, chance):
        folder = Path(tempfile.mkdtemp(prefix="scenes-", dir=STATE))
        obj, mtl = random_scene(chance)
        (folder / "room.obj").write_text(obj)
        (folder / "room.mtl").write_text(mtl)
        common = ["room.obj", "--max-edge", "0.5", "--sky", "none", "--threads", "1", "--seed", str(chance.randrange(1 << 30))]
        self.run(["bake", *common, "--rays", "100k", "--mesh-error", "none", "--store-transport", "-o", "a.vtkhdf"], folder)
        self.run(["reference", *common, "--samples", "50", "-o", "b.vtkhdf"], folder)
        compared = json.loads(self.run(["compare", "a.vtkhdf", "b.vtkhdf", "--json"], folder))
        measured = json.loads(self.run(["measure", "a.vtkhdf", "--json"], folder))
        bias, error = self.judge(compared, measured, folder)
        shutil.rmtree(folder)
        return {"bias": bias, "squared_ratio": (bias / error) ** 2}

    @staticmethod
    def report(total):
        tries = max(total["tries"], 1)
        bias, ratio = total.get("bias", 0.0) / tries, (total.get("squared_ratio", 0.0) / tries) ** 0.5
        return f"mean bias {100.0 * bias:+.3f} %, RMS of bias over its standard error {ratio:.2f}"

    def run(self, arguments, folder):
        result = run([self.luxel, *arguments], folder)
        if result.returncode not in (0, 3):  # 3: the rays ended before the error was reached
            raise Finding(f"{' '.join(arguments)} in {folder}: ended with {result.returncode}: {result.stderr[-500:]}")
        return result.stdout

    def judge(self, compared, measured, folder):
        if measured["errors_of_means"] != "replicates":
            raise Finding(f"the errors of means come from {measured['errors_of_means']}: {folder}")
        # Patches of one solve err together; the widest of the intervals of 95 % bounds what they have in common.
        means = [surface["mean_lx"] for surface in measured["surfaces"]]
        common = max((mean["high"] - mean["low"]) / (2.0 * 1.96 * mean["value"]) for mean in means if mean["value"] > 0)
        bias, error = compared["mean_bias"], (compared["bias_error"] ** 2 + common**2) ** 0.5
        if not abs(bias) <= self.limit * error:
            raise Finding(f"bias {bias:.4f}, standard error {error:.4f}: {folder}")
        return bias, error


# ---- Damaged files ----

class Fuzz:
    """A minute of libFuzzer on one of the readers, with sanitizers; the corpus grows from try to try."""

    at_once = CORES
    seconds = 60
    binaries, state = ROOT / "build/fuzz/bin", ROOT / "build/fuzz"

    def __init__(self, _):
        self.names = sorted(path.name.removeprefix("fuzz_") for path in self.binaries.glob("fuzz_*"))
        if not self.names:
            raise SystemExit("the harnesses are not built: ./dev soak fuzz builds them")

    def attempt(self, chance):
        name = chance.choice(self.names)
        corpus, found = self.state / "corpus" / name, self.state / "found" / name
        for folder in (corpus, found):
            folder.mkdir(parents=True, exist_ok=True)
        result = run([str(self.binaries / f"fuzz_{name}"), f"-max_total_time={self.seconds}", "-max_len=16384", "-timeout=20",
                      "-rss_limit_mb=2560", f"-seed={chance.randrange(1, 1 << 31)}", f"-artifact_prefix={found}/", str(corpus),
                      str(ROOT / "tests/fuzz/corpus" / name)], ROOT,
                     env=os.environ | {"LSAN_OPTIONS": f"suppressions={ROOT / 'tests/support/lsan.supp'}"})
        if result.returncode != 0:
            raise Finding(f"fuzz_{name} ended with {result.returncode}; its file is in {found}\n{result.stderr[-4000:]}")
        done = re.search(r"Done (\d+) runs", result.stderr)
        return {"inputs": int(done[1]) if done else 0}

    @staticmethod
    def report(total):
        return f"{total.get('inputs', 0)} inputs"


ATTACKS = {"kills": Kills, "signals": Signals, "scenes": Scenes, "fuzz": Fuzz, "window": Window}
BY_DEFAULT = ("kills", "signals", "scenes")


def cpu_seconds():
    own, children = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return own.ru_utime + own.ru_stime + children.ru_utime + children.ru_stime


def several_tries(name, attack, total):
    """As many tries as run side by side; added to the totals. Returns the number of findings."""

    def attempt(number):
        try:
            return attack.attempt(random.Random(f"{name} {number}"))
        except Finding as finding:
            (STATE / "findings").mkdir(exist_ok=True)
            (STATE / "findings" / f"{name}-{number}.txt").write_text(f"{finding}\n")
            print(f"FOUND by {name}, try {number}: {finding}", flush=True)
            return {"findings": 1}

    before, found = cpu_seconds(), 0
    numbers = range(total["tries"], total["tries"] + attack.at_once)
    with ThreadPoolExecutor(attack.at_once) as pool:
        for increments in pool.map(attempt, numbers):
            found += increments.get("findings", 0)
            for key, value in increments.items():
                total[key] = total.get(key, 0) + value
    total["tries"] += attack.at_once
    total["cpu_seconds"] += cpu_seconds() - before
    if longest := getattr(attack, "longest", 0.0):
        total["longest_seconds"] = round(max(total.get("longest_seconds", 0.0), longest), 2)
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--luxel", default=str(ROOT / "build/release/bin/luxel"))
    parser.add_argument("--minutes", type=float, default=10.0, help="of this leg, at most 60")
    parser.add_argument("attacks", nargs="*", metavar="ATTACK", help=", ".join(ATTACKS))
    options = parser.parse_args()
    unknown = [name for name in options.attacks if name not in ATTACKS]
    if unknown:
        parser.error(f"there is no attack {unknown[0]}: expected {', '.join(ATTACKS)}")
    STATE.mkdir(parents=True, exist_ok=True)
    totals_file = STATE / "totals.json"
    totals = json.loads(totals_file.read_text()) if totals_file.exists() else {}
    names = options.attacks or BY_DEFAULT
    end = time.monotonic() + 60.0 * min(options.minutes, 60.0)
    attacks = {name: ATTACKS[name](os.path.abspath(options.luxel)) for name in names}
    found = 0
    while time.monotonic() < end:
        for name in names:
            found += several_tries(name, attacks[name], totals.setdefault(name, {"tries": 0, "findings": 0, "cpu_seconds": 0.0}))
            totals_file.write_text(json.dumps(totals, indent=2))
            if time.monotonic() >= end:
                break
    for name, total in totals.items():
        longest = f", the longest took {total['longest_seconds']} s" if "longest_seconds" in total else ""
        print(f"{name:8} {total['tries']:6} tries {total['findings']:3} findings {total['cpu_seconds']:8.0f} CPU s in all, "
              f"{ATTACKS[name].report(total)}{longest}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
