# SPDX-License-Identifier: Apache-2.0
"""Hours in the window."""

import os
import shutil
import subprocess
import time
from pathlib import Path

from .common import Finding, folder_of_box


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
