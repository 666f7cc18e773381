# SPDX-License-Identifier: Apache-2.0
"""Shows a solution file of Luxel in ParaView: illuminance in lux in false colours, with a legend.

As a macro: Macros > Import new macro..., this file; open room.vtkhdf, then click luxel_light in the tool bar.
Without a window: pvbatch luxel_light.py room.vtkhdf room.png [linear|log]

A front has the light of the front, a back that of the back; a back that no light reaches is not drawn, so that closed
rooms are visible from outside. The scale is adjusted in the colour map editor. docs/paraview.md has pictures.
"""
import sys

import numpy as np

try:
    import h5py  # Debian's ParaView finds python3-h5py
except ImportError:
    h5py = None
from paraview import servermanager, simple

SCALE = "linear"  # or "log": two decades up to the same upper end
LUMENS_PER_WATT = 179.0  # src/luxel/scene/luminous_efficacy.h
LUMINANCE = (0.2126, 0.7152, 0.0722)  # of linear sRGB, ITU-R BT.709
COLOUR_MAP = "Viridis (matplotlib)"  # equal steps look equal, in grey too
SHOWN_SHARE = 0.97  # of the lit area is below the upper end of the scale, as on the HTML page
DECADES = 2.0  # of the logarithmic scale
# The arrays of VTKHDF/CellData that are read: docs/solution-file.md.
SIDES = {"front": "irradiance_front", "back": "irradiance_back"}
AREA = "area"


def stored(path):
    """What only Luxel's own group of the file has: linear sRGB of each band of a spectrum, and the camera. Empty without
    h5py."""
    if h5py is None:
        return {}
    with h5py.File(path) as file:
        found = {"linear_srgb": file["Luxel/linear_srgb"][:]} if "Luxel/linear_srgb" in file else {}
        if "Luxel/view" in file:
            found["view"] = {name: np.ravel(file["Luxel/view"][name][()]).tolist()
                             for name in ("eye", "target", "up", "vertical_fov")}
        if "Luxel/up" in file:
            found["up"] = file["Luxel/up"][:].tolist()
    return found


def quantity_of(components, linear_srgb=None):
    """Name and unit of what is shown, and a factor per band. linear_srgb: of each band, for a spectrum. Without it three
    bands are red, green and blue, and the watts of another number of bands are added up."""
    if linear_srgb is not None:
        return "Illuminance", "lx", [LUMENS_PER_WATT * float(factor) for factor in linear_srgb @ np.array(LUMINANCE)]
    if components == 3:
        return "Illuminance", "lx", [LUMENS_PER_WATT * part for part in LUMINANCE]
    return "Irradiance", "W/m²", [1.0] * components


def expression_of(array, factors):
    """The sum over bands, for ParaView's calculator, which names the components of three X, Y, Z, of others by number."""
    if len(factors) == 1:
        return f'{factors[0]:.9g}*"{array}"'
    names = "XYZ" if len(factors) == 3 else range(len(factors))
    return "+".join(f'{factor:.9g}*"{array}_{name}"' for factor, name in zip(factors, names))


def round_up(value):
    """The next number above of the form 1, 2, 3, 5, 7 times a power of ten."""
    if value <= 0.0:
        return 1.0
    power = 10.0 ** np.floor(np.log10(value))
    return next(step * power for step in (1, 2, 3, 5, 7, 10) if step * power >= value * (1.0 - 1e-9))


def upper_end(values, areas):
    """Round, and above SHOWN_SHARE of the lit area."""
    is_lit = values > 0.0
    if not is_lit.any():
        return 1.0
    order = np.argsort(values[is_lit])
    covered = np.cumsum(areas[is_lit][order])
    return round_up(values[is_lit][order][np.searchsorted(covered, SHOWN_SHARE * covered[-1])])


def light_of_side(source, array, name, factors):
    calculator = simple.Calculator(Input=source, registrationName=f"{name}: {array}")
    calculator.AttributeType = "Cell Data"
    calculator.ResultArrayName = name
    calculator.Function = expression_of(array, factors)
    return calculator


def lit_only(source, name):
    """The cells that light reaches."""
    lit = simple.Threshold(Input=source, registrationName=f"{name}: lit backs")
    lit.Scalars = ["CELLS", name]
    lit.ThresholdMethod, lit.LowerThreshold, lit.UpperThreshold = "Between", np.finfo(np.float32).tiny, 1e30
    return lit


def show_side(source, name, view, hidden_side):
    display = simple.Show(source, view)
    display.Representation = "Surface"  # no edges
    simple.ColorBy(display, ("CELLS", name))
    display.BackfaceRepresentation = hidden_side
    display.Ambient, display.Diffuse, display.Specular = 1.0, 0.0, 0.0  # colours are numbers: no shading
    return display


def fetched(source, name):
    cells = servermanager.Fetch(source).GetCellData()
    array = cells.GetArray(name)
    return np.array([array.GetValue(i) for i in range(array.GetNumberOfValues())])


def colour_scale(name, unit, top, scale, view):
    table = simple.GetColorTransferFunction(name)
    table.ApplyPreset(COLOUR_MAP, True)
    table.UseLogScale = 0
    table.RescaleTransferFunction(top / 10.0 ** DECADES if scale == "log" else 0.0, top)
    if scale == "log":
        table.MapControlPointsToLogSpace()
        table.UseLogScale = 1
    bar = simple.GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = f"{name}, {unit}", ""
    bar.AutomaticLabelFormat = 0
    bar.LabelFormat = bar.RangeLabelFormat = "%.4g"
    bar.Visibility = 1


def place_camera(view, camera, up):
    """The view of `luxel render` where the file has it, otherwise all of the scene from its front."""
    if camera:
        view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = camera["eye"], camera["target"], camera["up"]
        view.CameraViewAngle = camera["vertical_fov"][0]
        return
    z_is_up = abs(up[2]) > abs(up[1])
    view.CameraViewUp, view.CameraFocalPoint = up, [0.0, 0.0, 0.0]
    view.CameraPosition = [0.0, -1.0, 0.0] if z_is_up else [0.0, 0.0, 1.0]
    simple.ResetCamera(view)


def show(source, scale=SCALE):
    """Shows the solution of a source in the active view. Returns the view."""
    source.UpdatePipeline()
    cells = source.CellData
    missing = [array for array in (*SIDES.values(), AREA) if array not in cells.keys()]
    if missing:
        raise RuntimeError(f"the active source has no cell array {', '.join(missing)}: select a solution file of Luxel "
                           "(.vtkhdf) in the pipeline browser")
    own = stored(source.FileName if isinstance(source.FileName, str) else source.FileName[0])
    name, unit, factors = quantity_of(cells[SIDES["front"]].GetNumberOfComponents(), own.get("linear_srgb"))
    view = simple.GetActiveViewOrCreate("RenderView")
    simple.Hide(source, view)
    front = light_of_side(source, SIDES["front"], name, factors)
    back = light_of_side(source, SIDES["back"], name, factors)
    show_side(front, name, view, "Cull Backface")
    areas, of_front, of_back = fetched(source, AREA), fetched(front, name), fetched(back, name)
    if (of_back > 0.0).any():
        show_side(lit_only(back, name), name, view, "Cull Frontface")
    top = upper_end(np.concatenate([of_front, of_back]), np.concatenate([areas, areas]))
    colour_scale(name, unit, top, scale, view)
    simple.SetActiveSource(front)
    place_camera(view, own.get("view"), own.get("up", [0.0, 1.0, 0.0]))
    simple.Render(view)
    return view


def main(words):
    """words: those of the command line; in a macro there are none, and the active source is shown."""
    if not words or not words[0].endswith(".vtkhdf"):
        source = simple.GetActiveSource()
        if source is None:
            raise RuntimeError("open a solution file of Luxel (.vtkhdf) first")
        show(source)
        return
    view = show(simple.VTKHDFReader(FileName=[words[0]]), words[2] if len(words) > 2 else SCALE)
    view.ViewSize = [1200, 900]
    simple.SaveScreenshot(words[1], view)


if __name__ == "__main__":
    main(sys.argv[1:])
