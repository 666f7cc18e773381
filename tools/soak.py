#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Attacks on the built program, for hours if need be: ./dev soak [--minutes N] [ATTACK...].

Each attack goes on where it stopped: the seed of a try is its number. Totals are added up in
build/soak/totals.json; what was found is kept in build/soak/findings, with the command that shows it again. Legs of
different attacks may run side by side.

An attack is a class in attacks/: attempt(chance) makes one try with these random numbers, raises Finding, and returns what is
to be added to its totals. `at_once` tries run side by side. report(totals) is a sentence for the end.
"""

import argparse
import fcntl
import json
import os
import random
import resource
import sys
import time
from concurrent.futures import ThreadPoolExecutor

from attacks.common import ROOT, STATE, Finding
from attacks.fuzz import Fuzz
from attacks.scenes import Scenes
from attacks.stops import Kills, Signals
from attacks.window import Window

ATTACKS = {"kills": Kills, "signals": Signals, "scenes": Scenes, "fuzz": Fuzz, "window": Window}
BY_DEFAULT = ("kills", "signals", "scenes")
TOTALS = STATE / "totals.json"


def read_totals():
    return json.loads(TOTALS.read_text()) if TOTALS.exists() else {}


def lock(attack):
    """For the life of this process; another leg of the attack would try the same numbers."""
    file = open(STATE / f"{attack}.lock", "w")
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        sys.exit(f"soak: another leg of {attack} is running: wait for its end")
    return file


def keep(name, total):
    """Only the totals of this attack: others may be added to at the same time."""
    with open(STATE / "totals.lock", "w") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        written = TOTALS.with_suffix(".new")
        written.write_text(json.dumps(read_totals() | {name: total}, indent=2))
        written.replace(TOTALS)


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
    names = options.attacks or BY_DEFAULT
    locks = [lock(name) for name in dict.fromkeys(names)]
    totals = read_totals()
    end = time.monotonic() + 60.0 * min(options.minutes, 60.0)
    attacks = {name: ATTACKS[name](os.path.abspath(options.luxel)) for name in names}
    found = 0
    while time.monotonic() < end:
        for name in names:
            found += several_tries(name, attacks[name], totals.setdefault(name, {"tries": 0, "findings": 0, "cpu_seconds": 0.0}))
            keep(name, totals[name])
            if time.monotonic() >= end:
                break
    for name, total in read_totals().items():
        longest = f", the longest took {total['longest_seconds']} s" if "longest_seconds" in total else ""
        print(f"{name:8} {total['tries']:6} tries {total['findings']:3} findings {total['cpu_seconds']:8.0f} CPU s in all, "
              f"{ATTACKS[name].report(total)}{longest}")
    for file in locks:
        file.close()
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
