// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/export_page.h"

#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "luxel/core/compact.h"
#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/export/page_arrays.h"
#include "luxel/export/page_light.h"
#include "luxel/export/page_mesh.h"
#include "luxel/export/page_template.h"
#include "luxel/export/utf8.h"
#include "luxel/scene/luminous_efficacy.h"

namespace luxel {
namespace {

// What the page is told about itself; a change that an older page would misread counts it up.
constexpr int data_version = 1;

std::string three(const Vec3d& v) { return fmt::format("[{},{},{}]", v.x, v.y, v.z); }

// [{...},{...}] of things that each give a text.
template <typename Things, typename Text>
std::string list_of(const Things& things, Text text) {
  std::vector<std::string> texts;
  for (const auto& thing : things) texts.push_back(text(thing));
  return fmt::format("[{}]", fmt::join(texts, ","));
}

std::string group_names(const PatchSet& patches, std::span<const GroupLight> groups) {
  if (groups.empty()) return "[\"\"]";
  return list_of(patches.light_groups, [](const std::string& name) { return page_string(name); });
}

std::string materials_of(const PatchSet& patches, const BandColours& colours, bool has_groups) {
  return list_of(patches.materials, [&](const BandMaterial& m) {
    const auto reflectance = patches.wavebands.empty() ? colours.rgb(m.reflectance) : Vec3d(1.0);
    return fmt::format(R"({{"name":{},"reflectance":{},"emittance":{},"group":{},"twoSided":{}}})",
                       page_string(m.name), three(reflectance), three(colours.rgb(m.emittance)),
                       has_groups ? m.light_group : 0u, m.two_sided);
  });
}

std::string parts_of(const PageMesh& mesh) {
  return list_of(mesh.parts, [](const PagePart& p) {
    return fmt::format(R"({{"material":{},"backLit":{},"first":{},"count":{}}})", p.material, p.back_is_lit,
                       p.first, p.count);
  });
}

std::string made_by(const Solution& solution) {
  const auto& from = solution.provenance;
  return fmt::format(R"({{"luxel":{},"method":{},"rays":{},"error":{},"seenError":{},"meshError":{}}})",
                     page_string(from.program_version), page_string(from.method), from.rays,
                     solution.predicted_error, solution.seen_error, solution.mesh_error);
}

std::string camera_of(const Camera& camera) {
  return fmt::format(R"({{"eye":{},"target":{},"up":{},"fov":{}}})", three(camera.eye), three(camera.target),
                     three(camera.up), camera.vertical_fov);
}

std::string tone_of(const ToneOptions& tone) {
  const auto op = tone.op == ToneOperator::reinhard_local ? ToneOperator::reinhard : tone.op;
  return fmt::format(R"({{"op":{},"exposure":{},"key":{},"white":{}}})", page_string(name(op)), tone.exposure,
                     tone.key, tone.white);
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

  auto about = fmt::format(R"({{"version":{},"title":{},"made":{},"camera":{},"tone":{},"origin":{},)",
                           data_version, page_string(options.title), made_by(solution),
                           camera_of(options.camera), tone_of(options.tone), three(patches.origin));
  about += fmt::format(R"("groups":{},"sky":{},"hasSky":{},"materials":{},"parts":{},"efficacy":{},)",
                       group_names(patches, groups),
                       three(patches.has_sky() ? colours.rgb(patches.sky) : Vec3d(0.0)), patches.has_sky(),
                       materials_of(patches, colours, !groups.empty()), parts_of(mesh), luminous_efficacy);
  about += fmt::format(R"("light":{{"unit":{},"components":{}}},"errors":{{"largest":{},"perOctave":12}},)"
                       R"("arrays":[{}]}})",
                       lit.unit, lit.components, errors.largest, arrays.list());
  return {std::move(about), base64(deflated(arrays.bytes()))};
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
      solution.irradiance_back.size() != patches.size() * patches.band_count())
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
