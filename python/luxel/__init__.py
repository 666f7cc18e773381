# SPDX-License-Identifier: Apache-2.0
"""Luxel: global illumination of diffuse scenes by the radiosity method, with an error bar on every number.

    import luxel
    solution = luxel.bake("room.obj", error=0.02)
    print(solution.mean("floor"))              # lx, with a 95 % interval
    solution.irradiance                        # (patches, 3) float32, W/m², read-only, no copy
    solution.irradiance_error                  # its standard errors
    solution.write("room.glb")

begin with              to
bake, Solution          solve the light of a file or a Scene; its arrays, measures, pictures and files
Scene, load_scene       make a scene of arrays or of a file
load, merge             read solutions, and combine independent ones
view_factors            view factors as a sparse matrix
daylight                daylight factors, and a year of daylight
load_photometry         photometric files of luminaires

Metres, watts, linear sRGB. Calls are repeatable: the same input, options and seed give the same bits on any number of
threads. Long calls run without Python's lock, end within a second after Ctrl-C, and take threads= and progress=. Errors are
exceptions below luxel.Error; warnings go to the logger "luxel". docs/python.md is the guide.
"""
from ._bake import bake
from ._core import version as __version__
from ._daylight import Daylight, DaylightFactors, daylight
from ._errors import DeviceError, Error, FormatError, InputError, MismatchError, Stopped
from ._factors import ViewFactors, load_view_factors, view_factors
from ._measures import Interval, Lightmap, Plane, Probes, Spheres, SurfaceMeasure
from ._photometry import Photometry, PlaneFigures, load_photometry
from ._progress import ProgressBar
from ._scene import Material, Scene, load_scene
from ._solution import Relighter, Solution, load, merge

__all__ = [
    "Daylight", "DaylightFactors", "DeviceError", "Error", "FormatError", "InputError", "Interval", "Lightmap", "Material",
    "MismatchError", "Photometry", "Plane", "PlaneFigures", "Probes", "ProgressBar", "Relighter", "Scene", "Solution",
    "Spheres", "Stopped", "SurfaceMeasure", "ViewFactors", "__version__", "bake", "daylight", "load", "load_photometry",
    "load_scene", "load_view_factors", "merge", "view_factors",
]

for _name in __all__:  # so that help() and tracebacks say luxel.bake
    if getattr(globals()[_name], "__module__", "").startswith("luxel."):
        globals()[_name].__module__ = "luxel"
del _name
