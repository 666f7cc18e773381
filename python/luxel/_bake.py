# SPDX-License-Identifier: Apache-2.0
"""The light of a scene."""
from . import _core
from ._errors import Stopped
from ._options import bake_options, call, documented, given
from ._scene import scene_of
from ._solution import Solution


@documented(bake_options)
def bake(scene, error=None, *, threads=None, progress=None, **options):
    """Solves the light of a scene.

    scene: a path (text or pathlib.Path), a Scene, or an object with `vertices` and `faces`.
    error: stop at this error, such as 0.02 or "2%"; None: that of quality.

    Returns a Solution. All options are those of the command `luxel bake`, with the same meaning and defaults (None), and
    give the same light to the bit, on any number of threads. Options that take NAME=VALUE take dictionaries here, those that
    take on or off True or False, and points sequences of three numbers. Those of the scene belong to load_scene() or
    Scene.from_arrays() if a Scene is given.

    A progress function that returns False ends it with the light so far (`stop` is "stopped_by_user"), or raises Stopped
    where there is none. Ctrl-C raises KeyboardInterrupt within a second. Other threads of the program run meanwhile.
    Warnings go to the logger "luxel" of the module logging. Raises InputError with file, line and hints.
    """
    loaded, rest = scene_of(scene, options, "bake", threads, progress)
    pairs = given(bake_options(), "bake", {"error": error, **rest})
    handle = _core.bake(loaded._handle, pairs, call(threads, progress))
    if handle is None:
        raise Stopped(f"{loaded.source}: stopped before there was any light")
    return Solution(handle)
