# SPDX-License-Identifier: Apache-2.0
"""What paraview_test.py has pvbatch do: in_paraview.py MACRO_FOLDER SOLUTION PICTURE. Shows the solution, and prints what
ParaView has: lumens on the fronts and on the backs drawn, both ends of the scale, and the title of the legend; and the same
lumens by the state file."""
import json
import os
import sys

folder, solution, picture = sys.argv[1:]
sys.path.insert(0, folder)

import luxel_light  # noqa: E402
from paraview import simple  # noqa: E402

view = luxel_light.show(simple.VTKHDFReader(FileName=[solution]))
view.ViewSize = [640, 480]
simple.SaveScreenshot(picture, view)
shown = [display.Input for display in view.Representations if getattr(display, "Visibility", 0) and hasattr(display, "Input")]


def lumens_of(source):
    return float(luxel_light.fetched(source, "Illuminance") @ luxel_light.fetched(source, luxel_light.AREA))


table = simple.GetColorTransferFunction("Illuminance")
found = {"lumens": [lumens_of(source) for source in shown], "low": table.RGBPoints[0], "high": table.RGBPoints[-4],
         "title": simple.GetScalarBar(table, view).Title}
simple.ResetSession()
simple.LoadState(os.path.join(folder, "luxel_light.pvsm"), filenames=[{"name": "solution", "id": "10", "FileName": [solution]}])
view = simple.GetActiveView()
simple.ResetCamera(view)
simple.SaveScreenshot(picture.replace(".png", "-state.png"), view)
found["lumens_of_state"] = [lumens_of(simple.FindSource(name)) for name in ("Illuminance of fronts", "Lit backs")]
print(json.dumps(found))
