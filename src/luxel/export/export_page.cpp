// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/export_page.h"

#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "luxel/core/compact.h"
#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/export/page_arrays.h"
#include "luxel/export/page_light.h"
#include "luxel/export/page_mesh.h"
#include "luxel/export/page_template.h"
#include "luxel/export/utf8.h"
#include "luxel/scene/band_colours.h"
#include "luxel/scene/luminous_efficacy.h"

namespace luxel {
namespace {

// The version of the page's data; increases with each change that an older page would misread.
constexpr int data_version = 1;

Json three(const Vec3d& v) { return {v.x, v.y, v.z}; }

// The array of what is made of each thing.
template <typename Things, typename Member>
Json list_of(const Things& things, Member member) {
  Json list = Json::array();
  for (const auto& thing : things) list.push_back(member(thing));
  return list;
}

Json group_names(const PatchSet& patches, std::span<const GroupLight> groups) {
  if (groups.empty()) return Json::array({""});
  return list_of(patches.light_groups, [](const std::string& name) { return valid_utf8(name); });
}

Json materials_of(const PatchSet& patches, const BandColours& colours, bool has_groups) {
  return list_of(patches.materials, [&](const BandMaterial& m) -> Json {
    const auto reflectance = patches.wavebands.empty() ? colours.rgb(m.reflectance) : Vec3d(1.0);
    return {{"name", valid_utf8(m.name)},
            {"reflectance", three(reflectance)},
            {"emittance", three(colours.rgb(m.emittance))},
            {"group", has_groups ? m.light_group : 0u},
            {"twoSided", m.two_sided}};
  });
}

Json parts_of(const PageMesh& mesh) {
  return list_of(mesh.parts, [](const PagePart& p) -> Json {
    return {{"material", p.material}, {"backLit", p.back_is_lit}, {"first", p.first}, {"count", p.count}};
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

Page page_of(const PatchSet& patches, const Solution& solution, const SmoothLight& light,
             std::span<const GroupLight> groups, const PageOptions& options) {
  const auto colours = patches.colours();
  const auto mesh = make_page_mesh(patches, solution, light);
  const auto lit = make_page_light(patches, mesh, light, groups);
  const auto ratios = make_page_texture_ratios(patches, mesh);
  const auto errors = make_page_errors(patches, mesh, solution, groups);

  std::vector<float> positions;
  for (const auto& v : mesh.vertices) {
    const auto& p = patches.vertices[light.vertex[v.smooth]];
    positions.insert(positions.end(), {p.x, p.y, p.z});
  }
  std::vector<std::uint32_t> corners;
  for (const auto& t : mesh.triangles) corners.insert(corners.end(), t.begin(), t.end());

  PageArrays arrays;
  arrays.add("positions", positions);
  arrays.add("corners", corners);
  arrays.add("patches", mesh.patch);
  arrays.add("light", lit.halves);
  if (errors.largest > 0.0) arrays.add("errors", errors.codes);
  if (!ratios.reflectance.empty()) {
    arrays.add("reflecting", ratios.reflectance);
    arrays.add("emitting", ratios.emittance);
  }

  const Json about = {
      {"version", data_version},
      {"title", valid_utf8(options.title)},
      {"made", made_by(solution)},
      {"camera", camera_of(options.camera)},
      {"tone", tone_of(options.tone)},
      {"origin", three(patches.origin)},
      {"groups", group_names(patches, groups)},
      {"sky", three(patches.has_sky() ? colours.rgb(patches.sky) : Vec3d(0.0))},
      {"hasSky", patches.has_sky()},
      {"materials", materials_of(patches, colours, !groups.empty())},
      {"parts", parts_of(mesh)},
      {"efficacy", luminous_efficacy},
      {"light", {{"unit", lit.unit}, {"components", lit.components}}},
      {"errors", {{"largest", errors.largest}, {"perOctave", 12}}},
      {"arrays", arrays.list()},
  };
  return {page_json(about), base64(deflated(arrays.bytes()))};
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
  if (const auto why = page_is_missing(); !why.empty()) throw DeviceError(path.string() + ": " + why);
  if (light.corners.size() != patches.size() ||
      solution.irradiance.back.size() != patches.size() * patches.band_count())
    throw MismatchError("the light is not of these patches: smooth the light of this scene");
  if (!groups.empty() && groups.size() != patches.group_count())
    throw MismatchError(
        fmt::format("{} light groups were given but the scene has {}", groups.size(), patches.group_count()));
  const auto page = page_of(patches, solution, light, groups, options);
  std::string html(page_template());
  // From the end on: no text that is put in is looked through.
  put(html, "@NUMBERS@", page.numbers);
  put(html, "@ABOUT@", page.about);
  const auto title = escaped(valid_utf8(options.title));
  for (int places = 0; places < 2; ++places) put(html, "@TITLE@", title);  // of the window, of the panel
  write_file(path, html);
}

}  // namespace luxel
