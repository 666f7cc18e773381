// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/glass_option.h"

#include <optional>

#include <fmt/format.h>

#include "luxel/runs/option_set.h"
#include "luxel/scene/glass.h"

namespace luxel {
namespace {

constexpr const char* diffuse = "diffuse:";

}  // namespace

GlassOption parse_glass(const std::string& text) {
  const auto equals = text.rfind('=');
  GlassOption option;
  if (equals != std::string::npos) option.materials = text.substr(0, equals);
  auto number = equals == std::string::npos ? text : text.substr(equals + 1);
  const auto has_prefix = [&](const std::string& prefix) {
    if (number.rfind(prefix, 0) != 0) return false;
    number.erase(0, prefix.size());
    return true;
  };
  const bool is_transmissivity = has_prefix("tn:");
  option.is_diffuse = !is_transmissivity && has_prefix(diffuse);
  auto three = parse_three(number);
  if (const auto grey = parse_double(number)) three = Vec3d(*grey);
  if (equals == 0 || !three || *three != glm::clamp(*three, 0.0, 1.0) || *three == Vec3d(0.0))
    throw UsageError(fmt::format(
        "--glass: expected a visible transmittance above 0 and at most 1 with the material's name before it, "
        "such as window=0.8, window=0.7,0.8,0.75 (red, green, blue), as a transmissivity window=tn:0.96, or "
        "for a blind or opal glass blind=diffuse:0.3; or 0.8 for all panes; not '{}'",
        text));
  for (int band = 0; band < 3; ++band)
    option.transmittance[band] = static_cast<float>(
        is_transmissivity ? transmittance_of_transmissivity((*three)[band]) : (*three)[band]);
  return option;
}

std::string glass_as_text(const GlassOption& option) {
  const auto& t = option.transmittance;
  const auto number = (option.is_diffuse ? diffuse : "") +
                      (t == Vec3(t.r) ? fmt::format("{}", t.r) : fmt::format("{},{},{}", t.r, t.g, t.b));
  return option.materials.empty() ? number : fmt::format("{}={}", option.materials, number);
}

}  // namespace luxel
