# SPDX-License-Identifier: Apache-2.0
"""Runs that are killed or stopped at random moments."""

import atexit
import shutil
import signal
import subprocess
import time

from .common import Finding, folder_of_box, run

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
