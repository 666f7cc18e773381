// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/report_settings.h"

#include <fmt/format.h>

#include "luxel/runs/quantity.h"

namespace luxel {

void ReportSettings::declare(OptionSet& set) {
  set.heading("Report");
  set.add_text("title", "TEXT", title, "title of the page; empty: the name of the solution");
  set.add_text("project", "TEXT", project, "name of the project; empty: none");
  set.add_text("author", "TEXT", author, "name of the author; empty: none");
  set.add_text("date", "TEXT", date,
               "date on the page; empty: the day on which the solution's file was written (UTC), at most "
               "SOURCE_DATE_EPOCH where "
               "that is set");
  set.add_switch(
      "unfolded", has_unfolded,
      "a drawing of the unfolded room: isolux lines on floor, walls and ceiling of a rectangular room");
  set.add_switch("picture", has_picture, "a picture of the scene, 960 x 720 pixels");
  set.heading("Calculation planes");
  set.add_number("plane", "m", plane_height, 0.0, 1000.0, "height of the working plane above the floor");
  set.add_number("border", "m", border, 0.0, 1000.0, "strip along the walls that the plane leaves out");
  required.declare(set, true);
  set.add_number(
      "maintenance", "factor", maintenance, 0.0, 1.0,
      "maintenance factor of the working plane and of the surfaces, such as 0.8; 0: the one at the top "
      "of the --areas file, else 1");
  set.add_text("areas", "FILE", areas,
               "TOML or glTF file of calculation areas that are reported beside the working plane, as for "
               "probe; empty: none");
  set.add_text("scene", "FILE", scene, "--areas, --weather, --median-diffuse: the solved scene");
  set.heading("Glare");
  set.add_number("eye-height", "m", eye_height, 0.0, 1000.0, "height of the observers' eyes above the floor");
  set.add_text(
      "observers", "FILE", observers,
      "CSV file of further observers: x,y,z,nx,ny,nz on each line: the eye, m, and where it looks, as for "
      "ugr; empty: none");
  set.heading("Energy");
  set.add_number("hours", "h", hours, 0.0, 8784.0,
                 "hours per year at full power, for the estimate of energy; 0: no estimate");
  set.heading("Light");
  set.add_fraction("error", probe.error,
                   "standard error of the sampling per point and per observer, relative, such as 2% or 0.02");
  set.add_number("rays", "count", probe.max_rays, 1024u, 1u << 30, "maximum number of cosine rays per point");
  set.add_count("seed", probe.seed, "seed of the random numbers; other seeds give independent errors");
}

void ReportSettings::settle(bool uses_scene) {
  glare.error = probe.error;
  glare.seed = probe.seed;
  required.check(!areas.empty());
  if (areas.empty() && !scene.empty() && !uses_scene)
    throw UsageError("--scene belongs to --areas, --weather or --median-diffuse");
}

}  // namespace luxel
