// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/words.h"

#include <cmath>

#include <fmt/format.h>

namespace luxel {

std::string with_commas(std::size_t count) {
  if (count < 1000) return fmt::format("{}", count);
  return fmt::format("{},{:03}", with_commas(count / 1000), count % 1000);
}

std::string counted_things(std::size_t count, const char* noun) {
  return fmt::format("{} {}{}", with_commas(count), noun, count == 1 ? "" : "s");
}

std::string counted_have(std::size_t count, const char* noun) {
  return fmt::format("{} {}", counted_things(count, noun), count == 1 ? "has" : "have");
}

std::string counted_lie(std::size_t count, const char* noun) {
  return fmt::format("{} {}", counted_things(count, noun), count == 1 ? "lies" : "lie");
}

std::string counted_is(std::size_t count, const char* noun) {
  return fmt::format("{} {}", counted_things(count, noun), count == 1 ? "is" : "are");
}

std::string counted_are(std::size_t count) {
  return fmt::format("{} {}", with_commas(count), count == 1 ? "is" : "are");
}

std::string rounded(double number) {
  if (number >= 1000.0 && number < 1e15)
    return with_commas(static_cast<std::size_t>(std::floor(number + 0.5)));
  return fmt::format("{:.3g}", number);
}

std::string in_metres(double length) {
  if (length > 0.0 && length < 1e-3) return fmt::format("{:.2g} mm", 1e3 * length);
  if (length < 0.1) return fmt::format("{:.3g} mm", 1e3 * length);
  if (length < 1e4) return rounded(length) + " m";
  return fmt::format("{} km", rounded(1e-3 * length));
}

std::string percent(double fraction) {
  const auto value = 100.0 * fraction;
  if (value == 0.0) return "0 %";
  if (value < 0.1) return "below 0.1 %";
  return value < 10.0 ? fmt::format("{:.1f} %", value) : fmt::format("{:.0f} %", value);
}

std::string lies_on(const Scene& scene, std::uint32_t triangle) {
  const auto& material = scene.materials[static_cast<std::size_t>(scene.triangle_material[triangle])].name;
  const auto line = scene.triangle_line[triangle];
  return line > 0 ? fmt::format("on line {}, '{}'", line, material) : fmt::format("on '{}'", material);
}

}  // namespace luxel
