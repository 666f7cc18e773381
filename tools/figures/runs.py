# SPDX-License-Identifier: Apache-2.0
"""Runs the program and keeps its times: what a figure is made of is what a user would have typed."""
import json
import os
import subprocess
import sys


class Luxel:
    """The built program; what it writes by the way lies in `place`, what it measured is returned."""

    def __init__(self, programs, place, small=False):
        self.programs, self.place, self.small = programs, place, small
        os.makedirs(place, exist_ok=True)

    def at(self, name):
        return os.path.join(self.place, name)

    def run(self, *words):
        """The report of `luxel WORDS...`, with `cpu_seconds` of the whole process, all threads together."""
        command = [os.path.join(self.programs, "luxel"), *map(str, words), "--quiet", "--json"]
        before = os.times()
        done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
        after = os.times()
        if done.returncode != 0:
            sys.exit(f"{' '.join(command)}\ngave {done.returncode}\n{done.stderr}")
        report = json.loads(done.stdout)
        report["cpu_seconds"] = (after.children_user + after.children_system -
                                 before.children_user - before.children_system)
        return report

    def do(self, *words):
        """`luxel WORDS...`, of a command that has no report."""
        command = [os.path.join(self.programs, "luxel"), *map(str, words)]
        done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            sys.exit(f"{' '.join(command)}\ngave {done.returncode}\n{done.stderr}")

    def bench(self, file, *sections):
        command = [os.path.join(self.programs, "luxel-bench"), file, *(["--small"] if self.small else []), *sections]
        subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, check=True)

    def choose(self, full, small):
        """The size of a figure, or a tiny one that only shows that the commands are right."""
        return small if self.small else full


def keep_json(path, value):
    with open(path, "w", encoding="utf-8", newline="\n") as file:
        json.dump(value, file, indent=2)
        file.write("\n")
