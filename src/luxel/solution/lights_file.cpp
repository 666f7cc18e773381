// SPDX-License-Identifier: Apache-2.0
#include "luxel/solution/lights_file.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/none.h"
#include "luxel/photometry/photometry.h"
#include "luxel/solution/solution_layout.h"

namespace luxel {
namespace {

const std::string lights = "Luxel/point_lights";
const std::string photometries = "Luxel/photometry";

std::string group_of(std::size_t photometry) { return fmt::format("{}/{}", photometries, photometry); }

// The texts of a photometric file that are stored, in this order.
using Texts = std::vector<std::string>;
Texts texts_of(const Photometry& p) {
  return {p.file, p.format, p.luminaire, p.catalogue, p.maker, p.test_report};
}
void set_texts(const Texts& texts, Photometry& p) {
  p.file = texts[0];
  p.format = texts[1];
  p.luminaire = texts[2];
  p.catalogue = texts[3];
  p.maker = texts[4];
  p.test_report = texts[5];
}
constexpr std::size_t text_count = 6;

void add_photometry(Hdf5Writer& file, const std::string& group, const Photometry& p) {
  file.add_group(group);
  file.add_strings(group + "/texts", texts_of(p));
  file.add_number(group, "goniometer_type", static_cast<std::uint32_t>(p.intensity.type()));
  file.add_number(group, "opening_shape", static_cast<std::uint32_t>(p.opening.shape));
  file.add_number(group, "is_absolute", std::uint32_t{p.absolute});
  file.add_number(group, "header_flux", p.header_flux);
  const auto& size = p.opening.size;
  file.add_array(group + "/opening_size", flat(std::vector<double>{size.x, size.y, size.z}), "m");
  file.add_array(group + "/vertical", flat(p.intensity.vertical()), "degree");
  file.add_array(group + "/horizontal", flat(p.intensity.horizontal()), "degree");
  file.add_array(group + "/candela", rows_of(p.intensity.candela(), p.intensity.vertical().size()), "cd");
  if (const auto* lamp = p.lamp()) {
    file.add_array(group + "/lamp", flat(std::vector<double>{lamp->count, lamp->flux, lamp->watts}));
    file.add_strings(group + "/lamp_texts", Texts{lamp->name, lamp->colour, lamp->colour_rendering});
  }
}

std::shared_ptr<const Photometry> read_photometry(const Hdf5Reader& file, const std::string& group) {
  Photometry p;
  set_texts(file.strings(group + "/texts", text_count), p);
  const auto type = file.number<std::uint32_t>(group, "goniometer_type");
  const auto shape = file.number<std::uint32_t>(group, "opening_shape");
  if (type > static_cast<std::uint32_t>(GoniometerType::a) ||
      shape > static_cast<std::uint32_t>(OpeningShape::vertical_disk))
    file.refuse_as_damaged(fmt::format("luminaire '{}' is of no known type", p.file));
  p.absolute = file.number<std::uint32_t>(group, "is_absolute") != 0;
  p.header_flux = file.number<double>(group, "header_flux");
  const auto size = file.array<double>(group + "/opening_size", 3);
  p.opening = {static_cast<OpeningShape>(shape), {size[0], size[1], size[2]}};
  for (const auto extent : size)
    if (!(extent >= 0.0 && std::isfinite(extent)))
      file.refuse_as_damaged(fmt::format("luminaire '{}' has no valid opening", p.file));
  auto vertical = file.array<double>(group + "/vertical", file.rows(group + "/vertical"));
  auto horizontal = file.array<double>(group + "/horizontal", file.rows(group + "/horizontal"));
  auto candela = file.array<double>(group + "/candela", horizontal.size(), vertical.size());
  try {
    p.intensity = IntensityDistribution(static_cast<GoniometerType>(type), std::move(vertical),
                                        std::move(horizontal), std::move(candela));
  } catch (const InputError& error) {
    file.refuse_as_damaged(fmt::format("luminaire '{}': {}", p.file, error.what()));
  }
  if (file.has(group + "/lamp")) {
    const auto numbers = file.array<double>(group + "/lamp", 3);
    const auto texts = file.strings(group + "/lamp_texts", 3);
    p.lamps.push_back({numbers[0], numbers[1], numbers[2], texts[0], texts[1], texts[2]});
  }
  return std::make_shared<const Photometry>(std::move(p));
}

void add_luminaires(Hdf5Writer& file, const PatchSet& patches) {
  std::vector<const Photometry*> distinct;
  std::vector<std::uint32_t> which;
  std::vector<float> axes, factors;
  for (const auto& [light, bands, group] : patches.point_lights) {
    const auto& [x, y] = std::pair(light.local_x, light.local_y);
    axes.insert(axes.end(), {x.x, x.y, x.z, y.x, y.y, y.z});
    factors.insert(factors.end(), {light.dimming, light.maintenance});
    which.push_back(none);
    if (light.kind != PointLightKind::luminaire) continue;
    const auto at = std::find(distinct.begin(), distinct.end(), light.photometry.get());
    which.back() = static_cast<std::uint32_t>(at - distinct.begin());
    if (at == distinct.end()) distinct.push_back(light.photometry.get());
  }
  if (distinct.empty()) return;
  file.add_array(lights + "/photometry", flat(which));
  file.add_array(lights + "/axes", rows_of(axes, 6), "1");
  file.add_array(lights + "/factors", rows_of(factors, 2), "1");
  file.add_group(photometries);
  for (std::size_t i = 0; i < distinct.size(); ++i) add_photometry(file, group_of(i), *distinct[i]);
}

void read_luminaires(const Hdf5Reader& file, PatchSet& patches) {
  const auto n = patches.point_lights.size();
  const auto refuse_if = [&](bool is_wrong, const PointLight& light) {
    if (is_wrong) file.refuse_as_damaged(fmt::format("luminaire '{}' has no valid place", light.name));
  };
  if (!file.has(photometries)) {
    for (const auto& lamp : patches.point_lights)
      refuse_if(lamp.light.kind == PointLightKind::luminaire, lamp.light);
    return;
  }
  const auto which = file.array<std::uint32_t>(lights + "/photometry", n);
  const auto axes = file.array<float>(lights + "/axes", n, 6);
  const auto factors = file.array<float>(lights + "/factors", n, 2);
  std::vector<std::shared_ptr<const Photometry>> read;
  while (file.has(group_of(read.size()))) read.push_back(read_photometry(file, group_of(read.size())));
  for (std::size_t i = 0; i < n; ++i) {
    auto& light = patches.point_lights[i].light;
    const auto* axis = &axes[6 * i];
    light.local_x = {axis[0], axis[1], axis[2]};
    light.local_y = {axis[3], axis[4], axis[5]};
    light.dimming = factors[2 * i];
    light.maintenance = factors[2 * i + 1];
    if (light.kind != PointLightKind::luminaire) continue;
    refuse_if(which[i] >= read.size() || !(std::abs(glm::length(light.local_x) - 1.0f) < 1e-3f) ||
                  !(std::abs(glm::length(light.local_y) - 1.0f) < 1e-3f),
              light);
    light.photometry = read[which[i]];
  }
}

}  // namespace

void add_point_lights(Hdf5Writer& file, const PatchSet& patches) {
  if (patches.point_lights.empty()) return;
  std::vector<std::string> names;
  std::vector<std::uint32_t> kind, in_group;
  std::vector<Vec3> place, direction;
  std::vector<float> intensity, cosines, radius;
  for (const auto& [light, bands, light_group] : patches.point_lights) {
    names.push_back(light.name);
    kind.push_back(static_cast<std::uint32_t>(light.kind));
    in_group.push_back(light_group);
    place.push_back(light.position);
    direction.push_back(light.direction);
    intensity.insert(intensity.end(), bands.begin(), bands.end());
    cosines.insert(cosines.end(), {light.cos_inner, light.cos_outer});
    radius.push_back(light.angular_radius);
  }
  file.add_group(lights);
  file.add_strings(lights + "/name", names);
  file.add_array(lights + "/kind", flat(kind));
  file.add_array(lights + "/light_group", flat(in_group));
  file.add_array(lights + "/place", vectors(place), "m");
  file.add_array(lights + "/direction", vectors(direction), "1");
  file.add_array(lights + "/intensity", rows_of(intensity, patches.band_count()), "W/sr");
  file.add_array(lights + "/cosines", rows_of(cosines, 2), "1");
  if (std::any_of(radius.begin(), radius.end(), [](float r) { return r > 0.0f; }))
    file.add_array(lights + "/angular_radius", flat(radius), "rad");
  add_luminaires(file, patches);
}

void read_point_lights(const Hdf5Reader& file, PatchSet& patches) {
  if (!file.has(lights)) return;
  const auto n = file.rows(lights + "/kind");
  const auto bands = patches.band_count();
  const auto names = file.strings(lights + "/name", n);
  const auto kind = file.array<std::uint32_t>(lights + "/kind", n);
  const auto in_group = file.array<std::uint32_t>(lights + "/light_group", n);
  const auto place = file.vectors(lights + "/place", n);
  const auto direction = file.vectors(lights + "/direction", n);
  const auto intensity = file.array<float>(lights + "/intensity", n, bands);
  const auto cosines = file.array<float>(lights + "/cosines", n, 2);
  std::vector<float> radius(n, 0.0f);
  if (file.has(lights + "/angular_radius")) radius = file.array<float>(lights + "/angular_radius", n);
  for (std::size_t i = 0; i < n; ++i) {
    if (!(radius[i] >= 0.0f && radius[i] <= 0.5f))
      file.refuse_as_damaged(fmt::format("lamp '{}' has the angular radius {} rad", names[i], radius[i]));
    if (kind[i] > static_cast<std::uint32_t>(PointLightKind::luminaire))
      file.refuse_as_damaged(fmt::format("lamp '{}' is of no known kind", names[i]));
    auto& [light, of_bands, light_group] = patches.point_lights.emplace_back();
    light.name = names[i];
    light.kind = static_cast<PointLightKind>(kind[i]);
    light.position = place[i];
    light.direction = direction[i];
    light.cos_inner = cosines[2 * i];
    light.cos_outer = cosines[2 * i + 1];
    light.angular_radius = radius[i];
    of_bands.assign(&intensity[i * bands], &intensity[i * bands] + bands);
    light_group = in_group[i];
  }
  read_luminaires(file, patches);
}

}  // namespace luxel
