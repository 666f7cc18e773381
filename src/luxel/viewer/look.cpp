// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/look.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "luxel/core/error.h"

namespace luxel {
namespace {

constexpr std::array<std::string_view, show_count> shows = {
    "light", "irradiance", "standard-error", "patch-size", "level", "difference", "unshot", "grey", "sides"};

bool on_or_off(std::string_view of, const std::string& text) {
  if (text == "on") return true;
  if (text == "off") return false;
  throw InputError(fmt::format("{} is on or off, not '{}'", of, text));
}

// The boolean settings, by name.
struct Switch {
  std::string_view name;
  bool Look::*place;
};
constexpr Switch switches[] = {{"automatic-exposure", &Look::automatic_exposure},
                               {"lux", &Look::lux},
                               {"log", &Look::logarithmic},
                               {"automatic-scale", &Look::automatic_scale},
                               {"wires", &Look::wires},
                               {"normals", &Look::normals},
                               {"boxes", &Look::boxes},
                               {"rays", &Look::rays},
                               {"samples", &Look::samples},
                               {"faults", &Look::diagnostics},
                               {"solids", &Look::solids},
                               {"panel", &Look::panel},
                               {"keys", &Look::keys},
                               {"help", &Look::help},
                               {"about", &Look::about}};

// The numeric settings, with their ranges.
struct Number {
  std::string_view name;
  float low, high;
  void (*put)(Look& look, float value);
};
constexpr Number numbers[] = {
    {"exposure", -64.0f, 64.0f, [](Look& look, float value) { look.tone.exposure = value; }},
    {"key", automatic_key, 1.0f, [](Look& look, float value) { look.tone.key = value; }},
    {"white", 0.0f, 1e6f, [](Look& look, float value) { look.tone.white = value; }},
    {"low", -1e12f, 1e12f, [](Look& look, float value) { look.low = value; }},
    {"high", -1e12f, 1e12f, [](Look& look, float value) { look.high = value; }},
    {"isolines", 0.0f, 50.0f, [](Look& look, float value) { look.isolines = static_cast<int>(value); }},
    {"box-level", 0.0f, 40.0f, [](Look& look, float value) { look.box_level = static_cast<int>(value); }}};

}  // namespace

float script_number(std::string_view of, const std::string& text) {
  float value = 0.0f;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    throw InputError(fmt::format("{} is a number, not '{}'", of, text));
  return value;
}

void Look::set(std::string_view choice, const std::string& value) {
  for (const auto& each : switches)
    if (each.name == choice) {
      this->*each.place = on_or_off(choice, value);
      return;
    }
  for (const auto& each : numbers)
    if (each.name == choice) {
      const float number = script_number(choice, value);
      if (number < each.low || number > each.high)
        throw InputError(fmt::format("{} is from {} to {}, not {}", choice, each.low, each.high, number));
      each.put(*this, number);
      return;
    }
  if (choice == "tone") {
    const auto op = tone_operator(value);
    if (!op) throw InputError(fmt::format("there is no tone operator '{}'", value));
    tone.op = *op;
    return;
  }
  if (choice == "show") {
    const auto found = std::find(shows.begin(), shows.end(), value);
    if (found == shows.end()) throw InputError(fmt::format("there is nothing to show named '{}'", value));
    show = static_cast<Show>(found - shows.begin());
    return;
  }
  throw InputError(fmt::format("there is no choice named '{}'", choice));
}

}  // namespace luxel
