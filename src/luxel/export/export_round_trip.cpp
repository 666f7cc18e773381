// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/export_round_trip.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/ending_of.h"
#include "luxel/core/error.h"
#include "luxel/core/hint.h"
#include "luxel/core/output_file.h"
#include "luxel/export/back_gap.h"
#include "luxel/export/bright_pictures.h"
#include "luxel/export/light_metadata.h"
#include "luxel/export/lit_mesh.h"
#include "luxel/export/mapped_surfaces.h"
#include "luxel/export/opening_bodies.h"
#include "luxel/export/quantise.h"
#include "luxel/export/round_trip_colours.h"
#include "luxel/export/round_trip_materials.h"
#include "luxel/export/round_trip_primitive.h"
#include "luxel/export/scene_gltf.h"
#include "luxel/export/unwrapped_obj.h"
#include "luxel/export/write_glb.h"
#include "luxel/image/image_file.h"
#include "luxel/import/gltf_writer.h"
#include "luxel/import/is_gltf.h"
#include "luxel/patch/side.h"
#include "luxel/solution/back_is_lit.h"
#include "luxel/surface/vertex_fit.h"

namespace luxel {
namespace {

// Returns the scene's own file, or a file made from the scene. order: see round_trip_parts().
std::unique_ptr<GltfFile> file_of(const Scene& scene, const Vec3& up, std::vector<std::uint32_t>& order) {
  if (is_gltf(scene.source)) return std::make_unique<GltfFile>(scene.source, known_extensions());
  auto made = gltf_of(scene, up);
  order = std::move(made.order);
  return std::make_unique<GltfFile>(std::move(made.bytes), "scene.glb", known_extensions());
}

// State common to all forms: the file's parts are processed one by one.
class RoundTripExport {
 public:
  RoundTripExport(const RoundTripInput& input, const RoundTripOptions& options)
      : input_(input),
        options_(options),
        file_(file_of(input.scene, options.up, order_)),
        parts_(round_trip_parts(*file_, input.scene,
                                is_gltf(input.scene.source) ? options.metres_per_unit : 1.0, order_)),
        of_triangles_(input.patches, input.scene.triangles.size()),
        back_is_lit_(lit_backs(input.patches, input.solution)),
        curve_(curve_for(input.patches, input.solution, options.tone)),
        copy_(*file_),
        materials_(copy_, options.program) {}

  const ToneCurve& curve() const { return curve_; }
  RoundTripScene round_trip() const { return {input_.scene, input_.patches, of_triangles_, back_is_lit_}; }

  // surfaces_of(part): the surfaces made from it. light(part, surface, path): adds the light to a primitive.
  template <typename SurfacesOf, typename Light>
  void put(const SurfacesOf& surfaces_of, const Light& light);
  void describe(const char* form, Json light);
  // Returns false, and writes nothing, where the monitor stops the work.
  bool write(const std::filesystem::path& path, const Context& context) const {
    if (context.report({"write", 0.0}) == Next::stop) return false;
    const bool is_own_unit = is_gltf(input_.scene.source);  // else the copy is in metres
    write_glb(path, copy_, options_.program, options_.compression,
              is_own_unit ? options_.metres_per_unit : 1.0);
    return true;
  }

  // Writes COLOR_0 and _IRRADIANCE. light: see vertex_colours().
  void colour(const RoundTripPart& part, const RoundTripSurface& surface, const std::string& path,
              const SideValues& light);
  // code(pixel): its encoded value. Returns the textures; none where the monitor stops the work.
  template <typename Code>
  std::vector<std::size_t> add_pages(const std::vector<Image>& pages, const char* name, const Code& code,
                                     const Context& context);
  // surfaces_on(): the surfaces made from a part. add_coordinates(): the number of the added texture
  // coordinates.
  std::vector<RoundTripSurface> surfaces_on(const RoundTripPages& pages, const RoundTripPart& part,
                                            const PageCuts& cuts) const;
  std::size_t add_coordinates(const RoundTripPages& pages, const RoundTripSurface& surface,
                              const std::string& path);
  void put_out_lamps();
  // Writes which page of a lightmap a primitive's coordinates are on, beside the primitive's own extras.
  void note_page(const std::string& path, std::uint32_t page, std::size_t set) {
    if (!copy_.has(path + "/extras")) copy_.put(path + "/extras", Json::object());
    if (!copy_.has(path + "/extras/0"))
      copy_.put(path + "/extras/luxel_lightmap", {{"page", page + 1}, {"texCoord", set}});
  }
  // The surfaces as an OBJ file, see unwrapped_obj.h.
  std::string obj(const RoundTripPages& pages) const {
    const PageCuts cuts(round_trip(), pages.atlas);
    UnwrappedObj made(input_.scene, options_.metres_per_unit);
    for (const auto& part : parts_)
      if (is_opaque(input_.scene, part))
        for (const auto& surface : surfaces_on(pages, part, cuts)) made.add(part, surface);
    return made.text();
  }

  RoundTripMaterials& materials() { return materials_; }
  const BandMaterial& material_of(const RoundTripPart& part) const {
    const auto number = input_.scene.triangle_material[part.triangles.front()];
    return input_.patches.materials[static_cast<std::size_t>(number)];
  }

 private:
  static std::vector<bool> lit_backs(const PatchSet& patches, const Solution& solution) {
    std::vector<bool> lit(patches.size());
    for (std::size_t p = 0; p < lit.size(); ++p) lit[p] = back_is_lit(solution, p);
    return lit;
  }
  void take_off(const std::map<std::size_t, std::vector<std::size_t>>& gone);
  JsonValue material_json(const RoundTripPart& part) const {
    const auto index = part.drawn.primitive["material"];
    return index ? file_->object(index, "materials") : index;
  }

  const RoundTripInput& input_;
  const RoundTripOptions& options_;
  std::vector<std::uint32_t> order_;  // see round_trip_parts()
  std::unique_ptr<GltfFile> file_;
  std::vector<RoundTripPart> parts_;
  PatchesOfTriangles of_triangles_;
  std::vector<bool> back_is_lit_;
  ToneCurve curve_;
  GltfWriter copy_;
  RoundTripMaterials materials_;
  std::optional<BrightPictures> pictures_;  // of vertex colours alone
  const float gap_ = back_gap(input_.patches, options_.program);
};

// Further primitives of a mesh follow its own.
template <typename SurfacesOf, typename Light>
void RoundTripExport::put(const SurfacesOf& surfaces_of, const Light& light) {
  // All copies are made before the first one is changed.
  std::vector<bool> taken(copy_.size("/meshes"));
  std::map<std::size_t, std::size_t> mesh_of;  // [node]
  for (const auto& part : parts_)
    if (const auto node = part.drawn.placed.number; !mesh_of.contains(node))
      mesh_of[node] = mesh_of_node(copy_, node, taken);
  std::map<std::size_t, std::vector<std::size_t>> gone;  // [node]: primitives, ascending
  for (const auto& part : parts_) {
    if (!is_opaque(input_.scene, part)) continue;
    const auto mesh = mesh_of.at(part.drawn.placed.number);
    const auto own = primitive_path(mesh, part.drawn.number);
    const auto surfaces = surfaces_of(part);
    if (surfaces.empty()) gone[part.drawn.placed.number].push_back(part.drawn.number);
    std::vector<std::string> paths;
    for (std::size_t s = 0; s < surfaces.size(); ++s)
      paths.push_back(
          s == 0 ? own
                 : primitive_path(mesh, copy_.append_copy(fmt::format("/meshes/{}/primitives", mesh), own)));
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
      put_surface(copy_, *file_, part, surfaces[s], paths[s], gap_);
      light(part, surfaces[s], paths[s]);
      if (surfaces.size() > 1 && surfaces.back().back) materials_.one_sided(paths[s]);
    }
  }
  take_off(gone);
}

// Removes primitives without a surface: they have no area, or others with the same place carry their light.
void RoundTripExport::take_off(const std::map<std::size_t, std::vector<std::size_t>>& gone) {
  for (const auto& [node, primitives] : gone) {
    const auto place = fmt::format("/nodes/{}", node);
    const auto mesh = copy_.index_at(place + "/mesh");
    const bool all = primitives.size() == copy_.size(fmt::format("/meshes/{}/primitives", mesh));
    // A mesh must not be empty: an invisible one stays, but must not keep attributes that only its material
    // needs.
    for (auto i = primitives.rbegin(); i != primitives.rend(); ++i)
      copy_.erase(primitive_path(mesh, *i) + (all ? "/material" : ""));
    if (!all) continue;
    for (const auto* member : {"/mesh", "/skin", "/weights"}) copy_.erase(place + member);
  }
}

void RoundTripExport::colour(const RoundTripPart& part, const RoundTripSurface& surface,
                             const std::string& path, const SideValues& light) {
  const auto profile = profile_of(options_.program);
  const auto colours = input_.patches.colours();
  auto material = material_of(part);
  const bool has_picture = RoundTripMaterials::is_textured(material_json(part)) &&
                           material.textures.reflectance && input_.patches.has_colours();
  const auto picture = has_picture ? mean_of_picture(input_.patches, of_triangles_, part) : Vec3(1.0f);
  if (has_picture)
    for (int b = 0; b < 3; ++b)
      material.reflectance[static_cast<std::size_t>(b)] = material.textures.reflectance_factor[b];
  const auto vertices = vertex_colours(*file_, part, surface, {material, picture}, light, colours);
  if (has_picture && !pictures_) pictures_.emplace(copy_, input_.patches, input_.solution, curve_);
  const auto gain = has_picture ? pictures_->gain(material.textures.reflectance->texture) : Vec3(1.0f);
  const auto mean = gain * picture;
  std::vector<Rgba16> shown;
  for (const auto& radiance : vertices.radiance) {
    const auto colour = curve_(radiance);
    const auto seen = is_proportional(curve_) ? colour / mean : colour_over_picture(colour, mean);
    shown.push_back(quantise(profile.colours_are_srgb ? srgb_codes(seen) : seen));
  }
  const auto attributes = path + "/attributes/";
  copy_.put(attributes + "COLOR_0", copy_.add_colours(shown));
  if (profile.keeps_irradiance)
    copy_.put(attributes + "_IRRADIANCE", copy_.add_vectors(std::span<const Vec3>(vertices.irradiance)));
  const auto changed = materials_.shadeless(path, part.drawn.primitive["material"]);
  if (changed && has_picture) pictures_->put(*changed, material.textures.reflectance->texture);
}

template <typename Code>
std::vector<std::size_t> RoundTripExport::add_pages(const std::vector<Image>& pages, const char* name,
                                                    const Code& code, const Context& context) {
  std::vector<std::size_t> textures;
  const auto sampler = copy_.append(
      "/samplers", {{"magFilter", 9729}, {"minFilter", 9987}, {"wrapS", 33071}, {"wrapT", 33071}});
  for (std::size_t p = 0; p < pages.size(); ++p) {
    auto page = pages[p];
    for (auto& pixel : page.pixels) pixel = code(pixel);
    const auto png = png_of(page, {}, context);
    if (png.empty()) return {};
    const auto image = copy_.add_picture(png, "image/png", fmt::format("{} {}", name, p + 1));
    textures.push_back(copy_.append("/textures", {{"source", image}, {"sampler", sampler}}));
  }
  return textures;
}

// The file's own coordinates are those of fronts, with one page per node or one for all.
std::vector<RoundTripSurface> RoundTripExport::surfaces_on(const RoundTripPages& pages,
                                                           const RoundTripPart& part,
                                                           const PageCuts& cuts) const {
  if (!pages.as_file_has_it) return mapped_surfaces(round_trip(), part, pages.atlas, cuts);
  auto surfaces = uncut_surfaces(round_trip(), part);
  if (surfaces.size() > 1) surfaces.resize(1);
  if (surfaces.empty()) return surfaces;
  for (const auto t : part.triangles)
    if (of_triangles_.begin(t) < of_triangles_.end(t)) {
      surfaces[0].page = pages.atlas.page_of(SideId(of_triangles_.begin(t), false));
      break;
    }
  return surfaces;
}

// Sets are numbered without a gap, and programs expect a lightmap in the second.
std::size_t RoundTripExport::add_coordinates(const RoundTripPages& pages, const RoundTripSurface& surface,
                                             const std::string& path) {
  if (pages.as_file_has_it) return 1;
  const auto set = [&](std::size_t n) { return fmt::format("{}/attributes/TEXCOORD_{}", path, n); };
  const auto accessor = copy_.add_vectors(std::span<const Vec2>(surface.uv));
  std::size_t number = 0;
  while (copy_.has(set(number))) ++number;
  if (number == 0) copy_.put(set(number++), accessor);
  copy_.put(set(number), accessor);
  return number;
}

// Removes the lamps: the light is on the surfaces already.
void RoundTripExport::put_out_lamps() {
  for (std::size_t n = 0; n < copy_.size("/nodes"); ++n) {
    copy_.erase(fmt::format("/nodes/{}/extensions/KHR_lights_punctual", n));
    copy_.erase(fmt::format("/nodes/{}/extensions/EXT_lights_ies", n));
  }
}

void RoundTripExport::describe(const char* form, Json light) {
  copy_.put("/asset/extras/luxel", light_metadata(form, options_.program, std::move(light), input_.solution));
  // A file of Luxel's own has a root that is turned and put in its place.
  const auto number = copy_.has("/scene") ? copy_.index_at("/scene") : 0;
  const auto scene = copy_.has("/scenes") ? fmt::format("/scenes/{}/nodes", number) : std::string();
  add_opening_bodies(copy_, input_.patches, curve_,
                     is_gltf(input_.scene.source)
                         ? NodeParent{scene, options_.metres_per_unit, input_.patches.origin}
                         : NodeParent{"/nodes/0/children"});
}

// material(part, surface, path, coordinates): changes the material of a primitive whose page coordinates are
// those.
template <typename Material>
void put_pages(RoundTripExport& output, const RoundTripPages& pages, const Material& material) {
  const PageCuts cuts(output.round_trip(), pages.atlas);
  output.put([&](const RoundTripPart& part) { return output.surfaces_on(pages, part, cuts); },
             [&](const RoundTripPart& part, const RoundTripSurface& surface, const std::string& place) {
               material(part, surface, place, output.add_coordinates(pages, surface, place));
             });
}

// surfaces_of(scene, part); light: see vertex_colours().
template <typename SurfacesOf>
void export_vertices(const std::filesystem::path& path, const RoundTripInput& input,
                     const RoundTripOptions& options, const SurfacesOf& surfaces_of,
                     const SideValues& light) {
  RoundTripExport output(input, options);
  output.put([&](const RoundTripPart& part) { return surfaces_of(output.round_trip(), part); },
             [&](const RoundTripPart& part, const RoundTripSurface& surface, const std::string& place) {
               output.colour(part, surface, place, light);
             });
  output.describe("vertex", vertex_light(output.curve(), profile_of(options.program)));
  output.write(path, {});
}

}  // namespace

void export_round_trip_cut(const std::filesystem::path& path, const RoundTripInput& input,
                           const SmoothLight& light, const RoundTripOptions& options) {
  export_vertices(
      path, input, options,
      [&](const RoundTripScene& round_trip, const RoundTripPart& part) {
        return cut_surfaces(round_trip, part, light);
      },
      light.irradiance);
}

void export_round_trip_uncut(const std::filesystem::path& path, const RoundTripInput& input,
                             const VertexFit& fit, const RoundTripOptions& options) {
  export_vertices(path, input, options, uncut_surfaces, fit.irradiance);
}

bool export_round_trip_lightmap(const std::filesystem::path& path, const RoundTripInput& input,
                                const RoundTripPages& pages, const RoundTripOptions& options,
                                const Context& context) {
  RoundTripExport output(input, options);
  const auto code = [&](const Vec3& irradiance) { return irradiance / pages.white; };
  const auto textures = output.add_pages(pages.pages, "lightmap", code, context);
  if (textures.empty()) return false;
  const auto scale = output.curve().scale;
  const auto colours = input.patches.colours();
  put_pages(output, pages,
            [&](const RoundTripPart& part, const RoundTripSurface& surface, const std::string& place,
                std::size_t set) {
              const auto own = in_gamut(colours.rgb(output.material_of(part).emittance)) / pi;
              output.materials().lightmapped(place, part.drawn.primitive["material"], textures[surface.page],
                                             set, scale * pages.white, scale * own);
            });
  output.put_out_lamps();
  output.describe("lightmap", lightmap_light(pages.white, scale));
  return output.write(path, context);
}

bool export_round_trip_emissive(const std::filesystem::path& path, const RoundTripInput& input,
                                const RoundTripPages& pages, const RoundTripOptions& options,
                                const Context& context) {
  RoundTripExport output(input, options);
  const auto textures = output.add_pages(pages.pages, "light", output.curve(), context);
  if (textures.empty()) return false;
  put_pages(output, pages,
            [&](const RoundTripPart& part, const RoundTripSurface& surface, const std::string& place,
                std::size_t set) {
              output.materials().shining(place, part.drawn.primitive["material"], textures[surface.page],
                                         set);
            });
  output.describe("emissive", emissive_light(output.curve()));
  return output.write(path, context);
}

bool export_unwrapped(const std::filesystem::path& path, const RoundTripInput& input,
                      const RoundTripPages& pages, const RoundTripOptions& options, const Context& context) {
  RoundTripExport output(input, options);
  if (ending_of(path.string()) != ".obj") {
    put_pages(output, pages,
              [&](const RoundTripPart&, const RoundTripSurface& surface, const std::string& place,
                  std::size_t set) { output.note_page(place, surface.page, set); });
    return output.write(path, context);
  }
  if (pages.as_file_has_it)
    throw with_hints(
        InputError(fmt::format("{}: the coordinates are those of {}: make new ones, or write a .glb",
                               path.string(), input.scene.source)),
        {{Setting::layout, "new"}});
  if (context.report({"write", 0.0}) == Next::stop) return false;
  write_file(path, output.obj(pages));
  return true;
}

}  // namespace luxel
