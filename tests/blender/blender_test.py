# SPDX-License-Identifier: Apache-2.0
"""blender_test.py LUXEL BLENDER CHECK: the add-on in Blender; the checks are those of in_blender.py. All but one need no
window.

Ends with 77, and a line that says why, where there is no Blender.
"""
import os
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))


def main(luxel, blender, check):
    if not os.path.exists(blender):
        print("skipped: there is no Blender: apt-get install blender")
        return 77
    begin = [blender, "--background"]
    if check == "window":
        if shutil.which("xvfb-run") is None:
            print("skipped: there is no screen to open a window on: apt-get install xvfb xauth")
            return 77
        # -a alone looks for a free number and takes it later: two tests that begin at once would meet.
        begin = ["xvfb-run", "-a", "-n", str(10000 + os.getpid() % 9000), "-s", "-screen 0 1024x768x24", blender,
                 "--enable-event-simulate"]
    with tempfile.TemporaryDirectory() as folder:
        # Blender looks for its Python's libraries by the PATH: another python3 on it would lead it astray.
        words = {**os.environ, "PATH": "/usr/bin:/bin", "PYTHONDONTWRITEBYTECODE": "1", "TMPDIR": folder,
                 "BLENDER_USER_SCRIPTS": os.path.join(folder, "scripts"),
                 "BLENDER_USER_CONFIG": os.path.join(folder, "config")}
        done = subprocess.run([*begin, "--factory-startup", "--python-exit-code", "1", "--python",
                               os.path.join(HERE, "in_blender.py"), "--", luxel, check, folder], env=words, check=False)
    return done.returncode


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
