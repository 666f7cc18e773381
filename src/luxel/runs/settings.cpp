// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/settings.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "luxel/runs/glass_option.h"
#include "luxel/runs/quantity.h"

namespace luxel {
namespace {

constexpr float far = 1e9f;  // m; larger than any scene

// "auto" or a number: `word` is what auto means in the library's own options.
template <typename Value, typename Parse>
Declaration number_or_auto(const char* name, const char* unit, Value& value, Value word, Parse parse,
                           const char* help) {
  return {name, unit, help,
          [=, &value](const std::string& text) { value = text == "auto" ? word : parse(name, text); },
          [=, &value] { return value == word ? std::string("auto") : fmt::format("{}", value); }};
}

float parse_edge(const std::string& name, const std::string& text) {
  const auto value = parse_number(text);
  if (value && *value >= 0.0f && *value < far) return *value;
  throw UsageError(fmt::format("--{}: expected auto, 0 (no splitting) or metres, not '{}'", name, text));
}

float parse_fov(const std::string& name, const std::string& text) {
  const auto value = parse_number(text);
  if (value && *value >= 1.0f && *value <= 170.0f) return *value;
  throw UsageError(fmt::format("--{}: expected auto or degrees from 1 to 170, not '{}'", name, text));
}

float parse_key(const std::string& name, const std::string& text) {
  const auto value = parse_number(text);
  if (value && *value >= 0.001f && *value <= 1.0f) return *value;
  throw UsageError(fmt::format("--{}: expected auto or a number from 0.001 to 1, not '{}'", name, text));
}

int parse_bands(const std::string& text) {
  const auto value = parse_number(text);
  if (value && *value >= static_cast<float>(min_bands) && *value <= static_cast<float>(max_bands) &&
      *value == std::floor(*value))
    return static_cast<int>(*value);
  throw UsageError(fmt::format("--bands: expected auto or a whole number from {} to {}, not '{}'", min_bands,
                               max_bands, text));
}

LuminaireGrid parse_luminaire_grid(const std::string& text) {
  const auto at = text.rfind('@'), colon = text.rfind(':', at), times = text.find('x', colon);
  const auto refuse = [&] {
    throw UsageError(fmt::format(
        "--luminaire-grid: expected a photometric file, numbers of columns and rows and a height in metres, "
        "such as panel.ies:3x4@2.8, not '{}'",
        text));
  };
  if (at == std::string::npos || colon == std::string::npos || colon == 0 || !(times < at)) refuse();
  LuminaireGrid grid{.file = text.substr(0, colon)};
  const auto count = [&](std::size_t from, std::size_t to) {
    const auto value = parse_number(text.substr(from, to - from));
    if (!value || !(*value >= 1.0f && *value <= 1000.0f) || *value != std::floor(*value)) refuse();
    return static_cast<std::size_t>(*value);
  };
  grid.columns = count(colon + 1, times);
  grid.rows = count(times + 1, at);
  const auto height = parse_double(text.substr(at + 1));
  if (!height || !(std::abs(*height) <= far)) refuse();
  grid.height = *height;
  return grid;
}

Declaration glass_declaration(std::vector<GlassOption>& glass) {
  Declaration declaration{
      "glass", "NAME=TAU",
      "visible transmittance of panes at normal incidence, one number or red,green,blue, of materials (with "
      "* "
      "and ?), which become panes of glass; TAU alone: of all panes; NAME=tn:T: as transmissivity; "
      "NAME=diffuse:TAU: a surface that scatters the light it transmits, such as a blind, fabric or opal "
      "glass; see docs/glass.md; repeatable",
      [&glass](const std::string& text) { glass.push_back(parse_glass(text)); },
      [&glass] {
        std::vector<std::string> texts;
        for (const auto& option : glass) texts.push_back(glass_as_text(option));
        return fmt::format("{}", fmt::join(texts, "\n"));
      }};
  declaration.many = true;
  return declaration;
}

}  // namespace

void SceneSettings::declare_scene(OptionSet& set, const char* what_it_takes) {
  set.set_positional("SCENE", file, what_it_takes, ".obj .gltf .glb .ply .stl .fbx .dae .3ds");
  set.heading("Scene");
  set.add_number("scale", "m", load.scale, 1e-9, far, "metres per unit of the file");
  set.add_number("max-reflectance", "0..1", load.max_reflectance, 0.0f, 0.999f,
                 "maximum reflectance; higher ones are lowered to it");
  set.add_flag("allow-outside", load.allow_outside,
               "read files that the scene names (buffers, materials, textures, luminaires) from outside its "
               "folder, too");
  set.add_texts("one-sided", "NAME", load.one_sided, "materials (with * and ?) whose backs absorb light");
  set.add(glass_declaration(load.glass));
  set.add_texts("flip", "NAME", load.flip, "materials (with * and ?) whose faces are flipped");
  set.add_number("weld", "m", load.weld, 0.0f, static_cast<float>(far),
                 "merge vertices closer than this; 0 disables it");
  set.add_flag("orient", load.orient, "flip faces so that each connected component has consistent winding");
}

void SceneSettings::declare(OptionSet& set, const char* what_it_takes) {
  declare_scene(set, what_it_takes);
  set.heading("Patches");
  set.add(number_or_auto("max-edge", "m", patches.max_edge, automatic_edge, parse_edge,
                         "maximum edge length of patches; 0 leaves the triangles uncut"));
}

void SceneSettings::declare_contacts(OptionSet& set) {
  set.add_switch("contacts", patches.contacts,
                 "cut patches where surfaces touch or intersect, so that no light leaks there, and along "
                 "edges of shadows of suns, other punctual lights and small lamps");
  set.add(
      {"max-contacts", "count",
       "maximum number of lines, and of patches added, where surfaces touch or intersect; more is refused; "
       "auto: 12 patches per triangle, at least 200k, and triangles with the densest lines stay whole",
       [this](const std::string& text) {
         patches.max_contacts = text == "auto" ? 0 : parse_count("max-contacts", text);
       },
       [this] {
         return patches.max_contacts == 0 ? std::string("auto") : std::to_string(patches.max_contacts);
       }});
  set.add_number("contact-gap", "m", patches.contact_gap, 0.0f, 1.0f,
                 "maximum distance of surfaces that touch (at most a hundredth of their shortest edge)");
}

void SceneSettings::declare_sky(OptionSet& set) { daylight.declare(set); }

LoadOptions SceneSettings::load_options() const {
  auto options = load;
  options.sky = daylight.even_radiance();
  options.daylight = daylight.daylight();
  return options;
}

void SceneSettings::declare_luminaires(OptionSet& set) {
  Declaration lists{
      "luminaires", "FILE",
      "CSV list of luminaires: IES or EULUMDAT files and their places; see docs/luminaires.md; repeatable",
      [this](const std::string& text) { load.luminaires.emplace_back(text); },
      [this] {
        std::vector<std::string> names;
        for (const auto& path : load.luminaires) names.push_back(path.string());
        return fmt::format("{}", fmt::join(names, "\n"));
      }};
  lists.many = true;
  lists.endings = ".csv";
  set.add(std::move(lists));
  Declaration grids{
      "luminaire-grid", "FILE:NxM@HEIGHT",
      "N x M luminaires of an IES or EULUMDAT file, spaced evenly over the scene, that aim down "
      "from this height on the up axis, such as panel.ies:3x4@2.8; repeatable",
      [this](const std::string& text) { load.luminaire_grids.push_back(parse_luminaire_grid(text)); },
      [this] {
        std::vector<std::string> texts;
        for (const auto& g : load.luminaire_grids)
          texts.push_back(fmt::format("{}:{}x{}@{}", g.file.string(), g.columns, g.rows, g.height));
        return fmt::format("{}", fmt::join(texts, "\n"));
      }};
  grids.many = true;
  set.add(std::move(grids));
}

void SceneSettings::declare_spectra(OptionSet& set) {
  set.add({"spectral", "FILE",
           "solve by wavelength, with measured spectra of materials, lamps and sky from a CSV file; see "
           "docs/spectra.md",
           [this](const std::string& text) { load.spectra = text; },
           [this] { return load.spectra.string(); }});
  set.add({"bands", "count", "with --spectral: number of evenly spaced wavelengths; auto: those of the file",
           [this](const std::string& text) { load.bands = text == "auto" ? 0 : parse_bands(text); },
           [this] { return load.bands == 0 ? std::string("auto") : fmt::format("{}", load.bands); }});
}

void SceneSettings::check() const {
  if (load.bands > 0 && load.spectra.empty()) throw UsageError("--bands needs --spectral FILE");
  daylight.check();
}

RefineOptions RefineSettings::options(std::size_t patches) const {
  RefineOptions options{.mesh_error = mesh_error, .max_patches = max_patches};
  if (mesh_error != automatic) return options;
  // An error of the mesh as large as that of the light, for about the cost of the light.
  constexpr std::size_t enough = 100'000, more_where_it_pays = 150'000;
  options.mesh_error = 0.02;
  options.usual_patches = std::max(enough, patches + patches / 2);
  options.max_patches = std::min(max_patches, std::max(options.usual_patches, patches + more_where_it_pays));
  options.max_levels = 16;
  options.max_cost = 0.5;
  // The same for each --quality, --error and --seed, as the mesh is: that of the light at its default.
  options.light.ray_budget = 400'000'000;
  return options;
}

void RefineSettings::declare(OptionSet& set) {
  set.add({"mesh-error", "fraction",
           "refine patches until the error that their size leaves is below this, in the measure of --error; "
           "auto: 2%, with at most half as many rays as the light takes, or 20 million, and half as many "
           "patches again, or 100,000, more where that pays; none where --max-edge, --rays or --time is "
           "given, and in the viewer; none disables refinement",
           [this](const std::string& text) {
             const auto fraction = text == "none"   ? std::optional(0.0)
                                   : text == "auto" ? std::optional(automatic)
                                                    : parse_fraction(text);
             if (!fraction || (*fraction == 0.0 && text != "none"))
               throw UsageError(
                   fmt::format("--mesh-error: expected a fraction above 0 and below 1, such as 2%, auto "
                               "or none, not '{}'",
                               text));
             mesh_error = *fraction;
           },
           [this] {
             return mesh_error == automatic ? "auto" : mesh_error == 0.0 ? "none" : as_fraction(mesh_error);
           }});
  set.add({"max-patches", "count", "with --mesh-error: maximum number of patches, such as 200k",
           [this](const std::string& text) { max_patches = parse_count("max-patches", text); },
           [this] { return fmt::format("{}", max_patches); }});
}

void PictureSettings::declare_camera(OptionSet& set) {
  set.heading("Picture");
  set.add_point("eye", "x,y,z m", eye, "position of the camera");
  set.add_point("target", "x,y,z m", target, "point at the centre of the picture");
  set.add(number_or_auto("fov", "degrees", vertical_fov, automatic_fov, parse_fov, "vertical field of view"));
}

void PictureSettings::declare_view(OptionSet& set) {
  declare_camera(set);
  set.add_number("width", "pixels", render.width, 1, 32768,
                 "width of the picture; width times height at most 268 million");
  set.add_number("height", "pixels", render.height, 1, 32768, "height of the picture");
}

void PictureSettings::declare(OptionSet& set) {
  declare_view(set);
  set.add_number("samples", "count", render.samples_per_side, 1, 64,
                 "N for N x N rays per pixel; below 8, twice as many rows and columns where edges pass");
}

void PictureSettings::declare_gather(OptionSet& set) {
  set.add_number(
      "gather", "count", gather, 0, 65536,
      "rays per pixel of a final gather at the visible points, instead of --samples; 0 disables it");
}

void PictureSettings::declare_quantity(OptionSet& set) {
  set.add_choice("quantity", {"radiance", "luminance", "illuminance"}, quantity,
                 "what the picture shows: the light as it is seen, or in false colours with a scale its "
                 "luminance (cd/m²) or the illuminance of the surfaces (lx); an .exr or .hdr has the values");
  set.add_number("max-value", "cd/m² or lx", max_value, 0.0, 1e9,
                 "--quantity: value at the end of the scale; 0: chosen from the picture");
}

void PictureSettings::check() const {
  if (quantity == "illuminance" && gather > 0)
    throw UsageError("--gather does not apply to --quantity illuminance: leave one of them out");
  for (const auto& point : {eye, target})
    if (point && glm::length(*point) > far)
      throw UsageError(fmt::format("--eye and --target: expected points within {:g} m of the origin", far));
  if (eye && target && *eye == *target)
    throw UsageError("--eye and --target are the same point: the camera has no direction");
  constexpr std::int64_t max_pixels = 1 << 28;
  if (std::int64_t{render.width} * render.height > max_pixels)
    throw UsageError(
        fmt::format("--width {} --height {}: expected at most {} pixels, which take 4 GB of memory",
                    render.width, render.height, max_pixels));
}

void LookSettings::declare_up(OptionSet& set) { set.add_choice("up", {"auto", "y", "z"}, up, "the up axis"); }

void LookSettings::declare_title(OptionSet& set) {
  set.add_text("title", "TEXT", title, "title of a page (.html); empty: the name of the file");
}

void LookSettings::declare(OptionSet& set) {
  set.heading("Look");
  declare_up(set);
  set.add_number("crease-angle", "degrees", smooth.crease_angle, 0.0f, 180.0f,
                 "maximum angle between neighbours that are shaded smoothly");
  set.add(
      {"tone", "neutral|reinhard|reinhard-local|maximum|clamp", "tone mapping",
       [this](const std::string& text) {
         const auto op = tone_operator(text);
         if (!op)
           throw UsageError(fmt::format(
               "--tone: expected one of neutral, reinhard, reinhard-local, maximum, clamp, not '{}'", text));
         tone.op = *op;
       },
       [this] { return std::string(name(tone.op)); }});
  set.add_number("exposure", "stops", tone.exposure, -30.0f, 30.0f,
                 "exposure correction; positive is brighter");
  set.add(number_or_auto(
      "key", "0..1", tone.key, automatic_key, parse_key,
      "display value of the average luminance; auto: 0.18 for Reinhard's operators, for neutral "
      "0.25 to 0.5 depending on the bright parts"));
  set.add_number("white", "keyed", tone.white, 0.0f, 1e6f,
                 "smallest luminance, after scaling by the key, that is shown as white; 0: none");
}

void RunSettings::declare(OptionSet& set, const std::string& kinds) {
  set.heading(heading);
  if (!kinds.empty()) {
    Declaration output{"output", "FILE", "file to write; its extension selects the format: " + kinds,
                       [this](const std::string& text) { outputs.push_back(text); },
                       [this] { return fmt::format("{}", fmt::join(outputs, "\n")); }};
    output.letter = 'o';
    output.many = true;
    output.is_output = true;
    output.endings = kinds;
    set.add(std::move(output));
  }
  set.add_number("threads", "count", threads, 0, 4096,
                 "number of threads; 0: all cores; results do not depend on it");
  set.add_output("json-file", report, "write the result as JSON to this file");
  set.add_flag("json", json, "print the result as JSON");
  if (kinds.find(".glb") != std::string::npos || kinds.find(".png") != std::string::npos)
    set.add_flag("open", opens,
                 "open the written picture, page or mesh with the desktop's program for it (xdg-open)");
  set.add_flag("verbose", verbose, "print more about the light, and the time and the rays of each stage");
  set.add_flag("quiet", quiet, "print nothing but errors, and what --json and --progress json print");
  set.add_choice("progress", {"auto", "json"}, progress,
                 "progress on the standard error; auto: for people, on a terminal; json: a line of JSON "
                 "several times per "
                 "second, for programs");
}

}  // namespace luxel
