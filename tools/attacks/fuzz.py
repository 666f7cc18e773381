# SPDX-License-Identifier: Apache-2.0
"""Damaged files."""

import os
import re

from .common import CORES, ROOT, Finding, run


class Fuzz:
    """A minute of libFuzzer on one of the readers, with sanitizers; the corpus grows from try to try."""

    at_once = CORES
    seconds = 60
    limits = (ROOT / "tests/fuzz/libfuzzer.options").read_text(encoding="ascii").split()
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
        result = run([str(self.binaries / f"fuzz_{name}"), f"-max_total_time={self.seconds}", *self.limits,
                      f"-seed={chance.randrange(1, 1 << 31)}", f"-artifact_prefix={found}/", str(corpus),
                      str(ROOT / "tests/fuzz/corpus" / name)], ROOT,
                     env=os.environ | {"LSAN_OPTIONS": f"suppressions={ROOT / 'tests/support/lsan.supp'}"})
        if result.returncode != 0:
            raise Finding(f"fuzz_{name} ended with {result.returncode}; its file is in {found}\n{result.stderr[-4000:]}")
        done = re.search(r"Done (\d+) runs", result.stderr)
        return {"inputs": int(done[1]) if done else 0}

    @staticmethod
    def report(total):
        return f"{total.get('inputs', 0)} inputs"
