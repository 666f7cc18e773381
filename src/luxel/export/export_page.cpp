// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/export_page.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "luxel/core/bounds.h"
#include "luxel/core/compact.h"
#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/core/utf8.h"
#include "luxel/export/page_arrays.h"
#include "luxel/export/page_light.h"
#include "luxel/export/page_luminaires.h"
#include "luxel/export/page_mesh.h"
#include "luxel/export/page_template.h"
#include "luxel/export/page_textures.h"
#include "luxel/render/sky_look.h"
#include "luxel/scene/band_colours.h"
#include "luxel/scene/luminous_efficacy.h"

namespace luxel {
namespace {

// The version of the page's data; increases with each change that an older page would misread.
constexpr int data_version = 2;

Json three(const Vec3d& v) { return {v.x, v.y, v.z}; }

// An array of member(thing) for each thing.
template <typename Things, typename Member>
Json list_of(const Things& things, Member member) {
  Json list = Json::array();
  for (const auto& thing : things) list.push_back(member(thing));
  return list;
}

Json group_names(const PatchSet& patches, std::span<const GroupLight> groups) {
  if (groups.empty())
    return Json::array({patches.light_groups.size() == 1 ? valid_utf8(patches.light_groups[0]) : ""});
  return list_of(patches.light_groups, [](const std::string& name) { return valid_utf8(name); });
}

Json materials_of(const PatchSet& patches, const BandColours& colours, const PageTextures& textures,
                  bool has_groups) {
  std::size_t number = 0;
  return list_of(patches.materials, [&](const BandMaterial& m) -> Json {
    auto albedo = m.reflectance;
    for (std::size_t b = 0; m.is_diffuser() && b < albedo.size(); ++b)
      albedo[b] += m.diffuse_transmittance[b];
    const auto reflectance = patches.wavebands.empty() ? colours.rgb(albedo) : Vec3d(1.0);
    return {{"name", valid_utf8(m.name)},
            {"reflectance", three(reflectance)},
            {"emittance", three(colours.rgb(m.emittance))},
            {"group", has_groups ? m.light_group : 0u},
            {"twoSided", m.two_sided},
            {"textures", textures.description(number++)}};
  });
}

Json parts_of(const PageMesh& mesh) {
  return list_of(mesh.parts, [](const PagePart& p) -> Json {
    return {{"material", p.material},
            {"frontHidden", p.front_is_hidden},
            {"backLit", p.back_is_lit},
            {"first", p.first},
            {"count", p.count}};
  });
}

Json made_by(const Solution& solution) {
  const auto& from = solution.provenance;
  return {{"luxel", valid_utf8(from.program_version)},
          {"method", valid_utf8(from.method)},
          {"rays", from.rays},
          {"error", solution.predicted_error},
          {"seenError", solution.seen_error},
          {"meshError", solution.mesh_error}};
}

Json camera_of(const Camera& camera) {
  return {{"eye", three(camera.eye)},
          {"target", three(camera.target)},
          {"up", three(camera.up)},
          {"fov", camera.vertical_fov}};
}

Json tone_of(const ToneOptions& tone) {
  const auto op = tone.op == ToneOperator::reinhard_local ? ToneOperator::reinhard : tone.op;
  return {{"op", name(op)},
          {"exposure", tone.exposure},
          {"key", tone.key == automatic_key ? Json("auto") : Json(tone.key)},
          {"white", tone.white}};
}

struct Page {
  std::string about, numbers;
};

// Positions as whole steps from the lower corner of the scene's box: about a millionth of the box's longest
// edge, 10 micrometres in 10 m.
constexpr double steps_along_box = 1 << 20;

Json add_positions(PageArrays& arrays, const PatchSet& patches, const PageMesh& mesh) {
  Bounds box;
  for (const auto& v : mesh.vertices) box.add(patches.vertices[v.point.vertex]);
  if (mesh.vertices.empty()) box.add(Vec3(0.0f));
  const auto size = box.size();
  const auto longest = static_cast<double>(std::max({size.x, size.y, size.z}));
  const auto step = longest > 0.0 ? longest / steps_along_box : 1.0;
  std::vector<std::int32_t> places;
  for (const auto& v : mesh.vertices) {
    const auto from_corner = (Vec3d(patches.vertices[v.point.vertex]) - Vec3d(box.low)) / step;
    for (int i = 0; i < 3; ++i) places.push_back(static_cast<std::int32_t>(std::lround(from_corner[i])));
  }
  arrays.add_differences("positions", places, 3);
  return {{"low", three(Vec3d(box.low))}, {"step", step}};
}

// Corners count back from the first vertex that no triangle before has used: small numbers.
void add_triangles(PageArrays& arrays, const PageMesh& mesh) {
  std::vector<std::int32_t> corners, patch;
  std::uint32_t next = 0;
  for (const auto& t : mesh.triangles)
    for (const auto v : t) {
      corners.push_back(static_cast<std::int32_t>(next - v));
      next = std::max(next, v + 1);
    }
  for (const auto p : mesh.patch) patch.push_back(static_cast<std::int32_t>(p));
  arrays.add_differences("corners", corners, 0);
  arrays.add_differences("patches", patch, 1);
}

// Halves of `components` numbers each. Where the three colours change alike, the second and third are stored
// less the first.
void add_halves(PageArrays& arrays, std::string_view name, std::span<const std::uint16_t> halves,
                std::size_t components) {
  std::vector<std::int32_t> codes(halves.begin(), halves.end());
  for (std::size_t i = 0; i < codes.size(); i += components)
    for (std::size_t c = 1; c < 3; ++c) codes[i + c] -= codes[i];
  arrays.add_differences(name, codes, components);
}

void add_places(PageArrays& arrays, const PageMesh& mesh, std::size_t uv_sets) {
  for (std::size_t s = 0; s < uv_sets; ++s) {
    std::vector<std::int32_t> places;
    for (const auto& v : mesh.vertices) places.insert(places.end(), v.places[s].begin(), v.places[s].end());
    arrays.add_differences(fmt::format("places{}", s), places, 2);
  }
}

Page page_of(const PatchSet& patches, const Solution& solution, const SmoothLight& light,
             std::span<const GroupLight> groups, const PageOptions& options) {
  const auto colours = patches.colours();
  const PageTextures textures(patches);
  const auto mesh = make_page_mesh(patches, solution, light, textures, options.hidden_backs);
  const auto lit = make_page_light(patches, mesh, light, groups);
  const auto surface_colours = make_page_colours(patches, mesh);
  const auto errors = make_page_errors(patches, mesh, solution, groups);

  PageArrays arrays;
  const auto grid = add_positions(arrays, patches, mesh);
  add_triangles(arrays, mesh);
  add_halves(arrays, "light", lit.halves, lit.components);
  if (errors.largest > 0.0) arrays.add("errors", errors.codes);
  if (!surface_colours.reflectance.empty()) {
    add_halves(arrays, "reflecting", surface_colours.reflectance, 3);
    add_halves(arrays, "emitting", surface_colours.emittance, 3);
  }
  add_places(arrays, mesh, textures.uv_sets());
  for (std::size_t i = 0; i < textures.pictures().size(); ++i)
    arrays.add_file(fmt::format("picture{}", i), textures.pictures()[i]);

  auto luminaires = add_luminaires(arrays, patches, !groups.empty());

  const auto packed = deflated(arrays.bytes());
  const Json about = {
      {"version", data_version},
      {"title", valid_utf8(options.title)},
      {"made", made_by(solution)},
      {"camera", camera_of(options.camera)},
      {"tone", tone_of(options.tone)},
      {"origin", three(patches.origin)},
      {"groups", group_names(patches, groups)},
      {"lumens", lumens_of_groups(patches, !groups.empty())},
      {"luminaires", std::move(luminaires)},
      {"sky", three(patches.has_sky() ? colours.rgb(patches.mean_sky()) : Vec3d(0.0))},
      {"hasSky", patches.has_sky()},
      {"ground", ground_look(patches)},
      {"materials", materials_of(patches, colours, textures, !groups.empty())},
      {"parts", parts_of(mesh)},
      {"grid", grid},
      {"sets", textures.uv_sets()},
      {"placeParts", page_place_parts},
      {"pictures", textures.pictures().size()},
      {"efficacy", luminous_efficacy},
      {"light", {{"unit", lit.unit}, {"components", lit.components}}},
      {"errors", {{"largest", errors.largest}, {"perOctave", 12}}},
      {"arrays", arrays.list()},
      {"deflated", packed.size()},
  };
  return {page_json(about), base85(packed)};
}

// The text for HTML.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text)
    if (c == '&' || c == '<' || c == '>' || c == '"')
      out += fmt::format("&#{};", static_cast<int>(c));
    else
      out += c;
  return out;
}

// Puts a text in the place of a mark that the page has once.
void put(std::string& page, std::string_view mark, std::string_view text) {
  const auto at = page.find(mark);
  if (at != std::string::npos) page.replace(at, mark.size(), text);
}

}  // namespace

std::string page_is_missing() {
  if (!page_template().empty()) return {};
  return fmt::format(
      "this luxel was built without its page: {}. With Node.js, npm and a network, build it again",
      page_obstacle());
}

void export_page(const std::filesystem::path& path, const PatchSet& patches, const Solution& solution,
                 const SmoothLight& light, std::span<const GroupLight> groups, const PageOptions& options) {
  if (const auto why = page_is_missing(); !why.empty())
    throw DeviceError(path.string() + ": " + why, path.string());
  if (light.corners.size() != patches.size() ||
      solution.irradiance.back.size() != patches.size() * patches.band_count())
    throw MismatchError("the light is not of these patches: smooth the light of this scene");
  if (!groups.empty() && groups.size() != patches.group_count())
    throw MismatchError(
        fmt::format("{} light groups were given but the scene has {}", groups.size(), patches.group_count()));
  const auto page = page_of(patches, solution, light, groups, options);
  std::string html(page_template());
  // From the end backwards, so that inserted text is never searched.
  put(html, "@NUMBERS@", page.numbers);
  put(html, "@ABOUT@", page.about);
  const auto title = escaped(valid_utf8(options.title));
  for (int places = 0; places < 2; ++places) put(html, "@TITLE@", title);  // of the window, of the panel
  write_file(path, html);
}

}  // namespace luxel
