#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the commands of the documents: check_docs_commands.py ROOT PROGRAMS.

In the ```sh blocks of README.md and docs/*.md, each command that begins with `luxel`, `build/release/bin/` or `printf` is
run, in the order of the page, in an empty folder that has the scenes and the built PROGRAMS where the reader has them. A
command that begins with `./dev` must name a verb of ./dev. A ```python block whose first line is `# NAME.py` is the file
NAME.py from the start of its page, and `python3 NAME.py` runs it. Everything else, and a block fenced ```sh no-run, is left
alone.
"""
import glob
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time

TIMEOUT = 600  # s a command
PYTHON_FILE = re.compile(r"^```python\n# (\w+\.py)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def commands_of(text):
    """(line number, command) of each command in the ```sh blocks; lines that end in a backslash are joined."""
    inside, pending, start = None, "", 0
    for number, line in enumerate(text.splitlines(), 1):
        fence = re.match(r"\s*```(.*)$", line)
        if fence:
            inside = fence[1].strip() if inside is None else None
        elif inside == "sh":
            start = start if pending else number
            pending += re.sub(r"^\s*\$ ", "", line).strip()
            if pending.endswith("\\"):
                pending = pending[:-1]
                continue
            if pending and not pending.startswith("#"):
                yield start, pending
            pending = ""


def verbs_of(dev):
    """The verbs ./dev has: its functions named verb_..."""
    with open(dev, encoding="utf-8") as file:
        return set(re.findall(r"^verb_(\w+)\(\)", file.read(), re.MULTILINE))


def make_place(folder, root, programs):
    """Files of a reader after ./dev build: the scenes, and the programs in build/release/bin."""
    scenes = os.path.join(root, "scenes")
    if os.path.isdir(scenes):
        shutil.copytree(scenes, os.path.join(folder, "scenes"))
    os.makedirs(os.path.join(folder, "build", "release"))
    os.makedirs(os.path.join(folder, "out"))
    os.symlink(programs, os.path.join(folder, "build", "release", "bin"))


def run(command, folder, programs):
    """Why the command failed, or None."""
    environment = dict(os.environ, PATH=programs + os.pathsep + os.environ["PATH"])
    try:
        done = subprocess.run(["bash", "-c", command], cwd=folder, env=environment, timeout=TIMEOUT,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    except subprocess.TimeoutExpired:
        return f"took more than {TIMEOUT} s"
    return None if done.returncode == 0 else f"gave {done.returncode}\n{done.stdout.decode(errors='replace')[-3000:]}"


def check_page(page, root, programs, verbs):
    """(line number, sentence) of each command that fails."""
    with open(page, encoding="utf-8") as file:
        text = file.read()
    with tempfile.TemporaryDirectory() as folder:
        make_place(folder, root, programs)
        scripts = dict(PYTHON_FILE.findall(text))
        for name, script in scripts.items():
            with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                file.write(script)
        for number, command in commands_of(text):
            word = command.split()[0]
            if word == "./dev":
                verb = (command.split() + ["help"])[1]
                if verb not in verbs:
                    yield number, f"`{command}`: ./dev has no verb {verb}"
            elif (word in ("luxel", "printf") or word.startswith("build/release/bin/")
                  or word == "python3" and command.split()[-1] in scripts):
                begin = time.monotonic()
                failure = run(command, folder, programs)
                print(f"  {time.monotonic() - begin:5.1f} s  {command}", flush=True)
                if failure:
                    yield number, f"`{command}` {failure}"


def main():
    root, programs = (os.path.abspath(argument) for argument in sys.argv[1:3])
    verbs = verbs_of(os.path.join(root, "dev"))
    pages = [os.path.join(root, "README.md")] + sorted(glob.glob(os.path.join(glob.escape(root), "docs", "*.md")))
    failed = False
    for page in filter(os.path.isfile, pages):
        print(os.path.relpath(page, root), flush=True)
        for number, sentence in check_page(page, root, programs, verbs):
            print(f"{os.path.relpath(page, root)}:{number}: {sentence}")
            failed = True
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
