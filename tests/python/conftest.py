# SPDX-License-Identifier: Apache-2.0
"""What the tests of the Python package share."""
import math
import os
import pathlib

import numpy as np
import pytest

import luxel

SOURCES = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("LUXEL_PROGRAM")

CUBE = np.array([[x, y, z] for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)])
# Wound so that fronts face inwards.
INSIDE = np.array([[3, 1, 0], [2, 3, 0], [7, 6, 4], [5, 7, 4], [5, 4, 0], [1, 5, 0],
                   [7, 3, 2], [6, 7, 2], [6, 2, 0], [4, 6, 0], [7, 5, 1], [3, 7, 1]])


def furnace(reflectance=0.5, emission=1.0):
    """A closed cube whose walls all glow alike: the irradiance is pi * emission / (1 - reflectance) everywhere."""
    return luxel.Scene.from_arrays(CUBE, INSIDE, luxel.Material("wall", reflectance, emission))


def light_of_furnace(reflectance, emission):
    return math.pi * emission / (1.0 - reflectance)


@pytest.fixture(scope="session")
def box_file():
    return SOURCES / "scenes" / "cornell-box.obj"


@pytest.fixture(scope="session")
def box(box_file):
    """A quick bake of the Cornell box that keeps its transport. Tests must not close it."""
    return luxel.bake(box_file, error=0.1, max_edge=0.3, store_transport=True, threads=2)


@pytest.fixture(scope="session")
def program():
    if not PROGRAM:
        pytest.skip("LUXEL_PROGRAM does not name the command")
    return PROGRAM
