// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/read_mtl.h"

#include <algorithm>
#include <array>
#include <span>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/import/numbers.h"
#include "luxel/import/text.h"

namespace luxel {
namespace {

// The statement being read, as errors name it.
struct Statement {
  const std::string& source;
  std::size_t line;
  std::string_view keyword;
  std::string_view operands;

  [[noreturn]] void refuse(const std::string& expected) const {
    throw InputError(source, line,
                     fmt::format("expected {} after {}, found '{}'", expected, keyword, excerpt(operands)));
  }
};

Vec3 read_color(const Statement& statement) {
  auto words = statement.operands.substr(0, statement.operands.find('#'));
  auto color = read_three_numbers(words);
  if (!color) {  // a single number stands for all three
    const auto grey = read_number(take_word(words));
    if (grey && words.empty()) color = Vec3(*grey);
  }
  if (!color) statement.refuse("three finite numbers");
  if (color->r < 0.0f || color->g < 0.0f || color->b < 0.0f) statement.refuse("numbers of 0 or more");
  return *color;
}

// The emittance, pi times as large, must still fit a float.
Vec3 read_radiance(const Statement& statement) {
  const auto radiance = read_color(statement);
  if (!is_finite(pi * radiance)) statement.refuse("numbers below 1e38");
  return radiance;
}

float read_opacity(const Statement& statement) {
  auto words = statement.operands;
  auto word = take_word(words);
  if (word == "-halo") word = take_word(words);
  const auto number = read_number(word);
  if (!number) statement.refuse("a finite number");
  return *number;
}

struct TextureOption {
  std::string_view name;
  int least, most;  // number of arguments; those beyond the least are consumed while they are numbers
};
constexpr auto texture_options = std::to_array<TextureOption>({{"-blendu", 1, 1},
                                                               {"-blendv", 1, 1},
                                                               {"-bm", 1, 1},
                                                               {"-boost", 1, 1},
                                                               {"-cc", 1, 1},
                                                               {"-clamp", 1, 1},
                                                               {"-colorspace", 1, 1},
                                                               {"-imfchan", 1, 1},
                                                               {"-mm", 2, 2},
                                                               {"-o", 1, 3},
                                                               {"-s", 1, 3},
                                                               {"-t", 1, 3},
                                                               {"-texres", 1, 1},
                                                               {"-type", 1, 1}});

// Reads one option, if it is supported. "-s 2" scales u alone, as the format defines.
void take_option(std::string_view option, std::span<const std::string_view> arguments, MtlTexture& texture) {
  if (option == "-clamp") texture.clamps = arguments[0] == "on";
  auto* pair = option == "-s" ? &texture.scale : option == "-o" ? &texture.offset : nullptr;
  for (int i = 0; pair && i < 2 && i < static_cast<int>(arguments.size()); ++i)
    if (const auto number = read_number(arguments[static_cast<std::size_t>(i)])) (*pair)[i] = *number;
}

// Reads options such as "-s 1 1 1 -clamp on", then the name after them, which may contain blanks.
MtlTexture read_texture(std::string_view operands) {
  MtlTexture texture;
  auto rest = operands;
  for (;;) {
    auto behind = rest;
    const auto word = take_word(behind);
    const auto option = std::find_if(texture_options.begin(), texture_options.end(),
                                     [&](const TextureOption& known) { return known.name == word; });
    if (option == texture_options.end()) break;
    std::vector<std::string_view> arguments;
    for (int i = 0; i < option->most; ++i) {
      auto after = behind;
      const auto argument = take_word(after);
      if (i >= option->least && !read_number(argument)) break;
      arguments.push_back(argument);
      behind = after;
    }
    take_option(word, arguments, texture);
    rest = behind;
  }
  if (rest.size() >= 2 && rest.front() == '"' && rest.back() == '"') rest = rest.substr(1, rest.size() - 2);
  texture.name = rest;
  return texture;
}

// These are hints: values that cannot be read are ignored.
void read_hints(const std::string& key, std::string_view operands, MtlMaterial& material) {
  auto words = operands;
  const auto number = read_number(take_word(words));
  if (key == "illum" && number && *number >= 0.0f && *number <= 10.0f)
    material.illumination = static_cast<int>(*number);
  if (key == "ni" && number) material.refraction = *number;
  if (key == "tf" && number) material.transmitted = read_three_numbers(operands).value_or(Vec3(*number));
}

}  // namespace

bool is_glass(const MtlMaterial& material) {
  constexpr float refracts = 1.05f, dark = 0.2f, clear = 0.5f;
  const auto largest = [](const Vec3& v) { return std::max({v.r, v.g, v.b}); };
  const bool has_refraction = material.illumination == 4 || material.illumination == 6 ||
                              material.illumination == 7 || material.illumination == 9;
  return has_refraction && material.refraction > refracts && material.map_kd.name.empty() &&
         largest(material.kd.value_or(Vec3(0.0f))) < dark &&
         largest(material.transmitted.value_or(Vec3(1.0f))) >= clear;
}

std::optional<Vec3> stated_transmittance(const MtlMaterial& material) {
  constexpr float clear = 0.5f;
  const auto tf = material.transmitted.value_or(Vec3(0.0f));
  if (tf != glm::clamp(tf, 0.0f, 1.0f) || std::max({tf.r, tf.g, tf.b}) < clear) return std::nullopt;
  return tf;
}

bool is_polished(const MtlMaterial& material) {
  return material.illumination >= 3 && material.illumination <= 9;
}

std::vector<MtlMaterial> read_mtl(std::string_view text, const std::string& source) {
  std::vector<MtlMaterial> materials;
  for (Statements statements(text); statements.next();) {
    auto operands = trim(statements.text());
    const auto keyword = take_word(operands);
    const auto key = lower_case(keyword);
    const Statement statement{source, statements.line(), keyword, operands};
    if (key == "newmtl") {
      materials.emplace_back().name = operands;
    }
    if (materials.empty()) continue;
    auto& material = materials.back();
    if (key == "kd") material.kd = read_color(statement);
    if (key == "ks") material.ks = read_color(statement);
    if (key == "ke") material.ke = read_radiance(statement);
    if (key == "map_kd") material.map_kd = read_texture(operands);
    if (key == "map_ke") material.map_ke = read_texture(operands);
    if (key == "map_d") material.map_d = read_texture(operands);
    read_hints(key, operands, material);
    if (key == "d") material.opacity = read_opacity(statement);
  }
  return materials;
}

}  // namespace luxel
