// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/gltf_textures.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/hint.h"
#include "luxel/core/trig.h"
#include "luxel/import/make_materials.h"
#include "luxel/import/name_list.h"
#include "luxel/import/raster_colours.h"
#include "luxel/import/uri.h"

namespace luxel {
namespace {

Wrap wrap_of(const JsonValue& mode) {
  switch (mode.whole(10497)) {
    case 10497:
      return Wrap::repeat;
    case 33648:
      return Wrap::mirror;
    case 33071:
      return Wrap::clamp;
    default:
      mode.refuse(fmt::format("expected 10497, 33648 or 33071, found {}", mode.whole()));
  }
}

// KHR_texture_transform: scale, rotation, offset. The rotation has the direction of its test model and of all
// viewers, which differs from the matrix in its text (KhronosGroup/glTF, 1563).
std::array<float, 6> placement_of(const JsonValue& transform) {
  constexpr double most = 1e6;
  const auto offset = transform["offset"].numbers({0.0, 0.0});
  const auto scale = transform["scale"].numbers({1.0, 1.0});
  const auto rotation = transform["rotation"].number(0.0);
  for (const auto number : {offset[0], offset[1], scale[0], scale[1], rotation})
    if (!(std::abs(number) <= most)) transform.refuse(fmt::format("expected numbers up to {:g}", most));
  const auto [sine, cosine] = sin_cos(rotation);
  const auto f = [](double x) { return static_cast<float>(x); };
  return {f(cosine * scale[0]), f(sine * scale[1]),   f(offset[0]),  //
          f(-sine * scale[0]),  f(cosine * scale[1]), f(offset[1])};
}

// Returns the index of a texture's picture: that of glTF itself, or that of an extension.
JsonValue source_of(const JsonValue& texture) {
  if (const auto webp = texture["extensions"]["EXT_texture_webp"]["source"]) return webp;
  if (const auto source = texture["source"]) return source;
  if (texture["extensions"]["KHR_texture_basisu"])
    texture.refuse(
        "its picture is KTX2, which Luxel does not read; convert the file by: npx @gltf-transform/cli "
        "ktxdecompress "
        "IN.glb OUT.glb");
  texture.refuse("expected a source that is PNG, JPEG or WebP, found none");
}

}  // namespace

GltfTextures::Picture GltfTextures::picture(const JsonValue& info) {
  Picture picture;
  const auto texture = file_.object(info["index"], "textures");
  const auto transform = info["extensions"]["KHR_texture_transform"];
  picture.use.placement = placement_of(transform);
  if (texture["sampler"]) {
    const auto sampler = file_.object(texture["sampler"], "samplers");
    picture.use.wrap = {wrap_of(sampler["wrapS"]), wrap_of(sampler["wrapT"])};
  }
  picture.texture = decoded(texture);
  picture.use.texture = picture.texture.value_or(0);
  return picture;
}

std::optional<std::uint32_t> GltfTextures::decoded(const JsonValue& texture) {
  try {
    const auto source = source_of(texture);
    const auto image = file_.object(source, "images");
    const auto [place, is_new] = images_.try_emplace(source.whole());
    if (!is_new) return place->second;
    const auto uri = image["uri"];
    const auto bytes = uri ? file_.resource(uri) : std::string(file_.view(image["bufferView"]));
    const auto written = uri && !is_data_uri(uri.text()) ? uri.text() : image.path();
    auto raster = decode_raster(bytes, fmt::format("{}: {}", file_.source(), written));
    budget_.take(raster, bytes.size());
    const auto number = static_cast<std::uint32_t>(textures_.size());
    textures_.push_back({image["name"].text(written), std::make_shared<const Raster>(std::move(raster))});
    place->second = number;
    return number;
  } catch (const InputError& error) {
    if (unreadable_++ == 0) {
      first_reason_ = error.what();
      first_hints_ = hints_of(error);
    }
    return std::nullopt;
  }
}

std::uint32_t GltfTextures::with_metal(std::optional<std::uint32_t> base, std::uint32_t metal, float factor) {
  const auto key = std::tuple(base ? std::int64_t{*base} : -1, metal, factor);
  const auto [place, is_new] = with_metal_.try_emplace(key, static_cast<std::uint32_t>(textures_.size()));
  if (is_new) {
    auto lowered =
        with_lowered_metal(base ? &raster(*base) : nullptr, raster(metal), factor, max_metal_reflectance);
    textures_.push_back(
        {textures_[base.value_or(metal)].name, std::make_shared<const Raster>(std::move(lowered))});
  }
  return place->second;
}

void GltfTextures::say_warnings(const Context& context) const {
  if (unreadable_ > 0)
    context.warn(
        fmt::format(
            "{}: {} cannot be read (first: {}); 0.5 is taken for the reflectance there, and 0 for the "
            "light that is emitted",
            file_.source(), counted(unreadable_, "picture"), first_reason_),
        first_hints_);
}

}  // namespace luxel
