// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/script_player.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "luxel/core/ending_of.h"
#include "luxel/core/error.h"
#include "luxel/image/image_file.h"
#include "luxel/viewer/menus.h"

namespace luxel {
namespace {

Key key_named(const std::string& name) {
  static const std::pair<const char*, Key> named[] = {{"tab", key::tab},
                                                      {"escape", key::escape},
                                                      {"enter", key::enter},
                                                      {"space", ' '},
                                                      {"shift", key::shift},
                                                      {"control", key::control},
                                                      {"alt", key::alt},
                                                      {"home", key::home},
                                                      {"f1", key::f1},
                                                      {"page-up", key::page_up},
                                                      {"page-down", key::page_down},
                                                      {"f11", key::f11},
                                                      {"plus", '='},
                                                      {"minus", '-'},
                                                      {"f12", key::f12},
                                                      {"backspace", key::backspace}};
  for (const auto& [word, key] : named)
    if (name == word) return key;
  if (name.size() == 1 && ((name[0] >= 'A' && name[0] <= 'Z') || (name[0] >= '0' && name[0] <= '9')))
    return name[0];
  throw InputError(
      fmt::format("there is no key '{}': letters are written large, others as tab, space, shift", name));
}

MouseButton button_named(const std::string& name) {
  if (name == "left") return MouseButton::left;
  if (name == "right") return MouseButton::right;
  if (name == "middle") return MouseButton::middle;
  throw InputError(fmt::format("there is no mouse button '{}'", name));
}

std::array<float, 3> three(const std::string& of, const std::string& text) {
  std::array<float, 3> values{};
  std::size_t begin = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto end = i < 2 ? text.find(',', begin) : text.size();
    if (end == std::string::npos)
      throw InputError(fmt::format("{} is three numbers with commas, not '{}'", of, text));
    values[i] = script_number(of, text.substr(begin, end - begin));
    begin = end + 1;
  }
  return values;
}

// The words from one on, joined by spaces: file names may contain spaces.
std::string rest(const std::vector<std::string>& words, std::size_t first) {
  return fmt::format("{}", fmt::join(words.begin() + static_cast<std::ptrdiff_t>(first), words.end(), " "));
}

int whole(const std::string& of, const std::string& text) {
  return static_cast<int>(std::lround(script_number(of, text)));
}

}  // namespace

void ScriptPlayer::frames(int count) {
  waits_ = [count]() mutable { return count-- <= 0; };
}

void ScriptPlayer::advance() {
  wants_fine_ = false;
  if (waits_) {
    if (!waits_()) return;
    waits_ = nullptr;
  }
  if (next_ == script_.actions.size()) return;
  const auto& action = script_.actions[next_];
  try {
    // A picture shows the effect of earlier actions: one frame is drawn in between.
    const auto& verb = action.words.front();
    if (!std::exchange(wants_fine_, verb == "snapshot" && !has_drawn_)) act(action);
    has_drawn_ = wants_fine_;
    if (wants_fine_) return;
  } catch (const InputError& error) {
    throw InputError(script_.file, action.line, error.what());
  }
  ++next_;
}

void ScriptPlayer::key(const std::string& name, bool down) {
  viewer_.handle({.kind = Event::Kind::key, .key = key_named(name), .down = down});
}

void ScriptPlayer::mouse(const Words& words) {
  const auto& verb = words[0];
  const auto move = [&](std::size_t first) {
    viewer_.handle({.kind = Event::Kind::move,
                    .at = Vec2(script_number("x", words[first]), script_number("y", words[first + 1]))});
  };
  const auto press = [&](const std::string& name, bool down) {
    viewer_.handle({.kind = Event::Kind::button, .down = down, .button = button_named(name)});
  };
  if (verb == "move") return move(1);
  if (verb == "press") return press(words[1], true);
  if (verb == "release") return press(words[1], false);
  // Panels need the cursor's position one frame before it is pressed.
  const std::string which = words.size() == 6 ? words[5] : "left";
  int frame = 0;
  const bool drags = verb == "drag";
  move(1);
  waits_ = [=, this]() mutable {
    ++frame;
    if (frame == 2) press(which, true);
    if (drags && frame > 2 && frame <= 12) {
      const float fraction = static_cast<float>(frame - 2) / 10.0f;
      const auto way = [&](std::size_t i) {
        const float from = script_number("x", words[i]), to = script_number("x", words[i + 2]);
        return from + fraction * (to - from);
      };
      viewer_.handle({.kind = Event::Kind::move, .at = Vec2(way(1), way(2))});
    }
    const int end = drags ? 14 : 4;
    if (frame == end) press(which, false);
    return frame > end + 1;
  };
}

void ScriptPlayer::wait(const Words& words) {
  if (words.size() == 3) {
    const float count = script_number("the time", words[1]);
    if (words[2] == "frames") return frames(static_cast<int>(count));
    if (words[2] == "seconds")
      return frames(static_cast<int>(std::ceil(static_cast<double>(count) / frame_seconds)));
    throw InputError(fmt::format("one waits for frames or seconds, not for {}", words[2]));
  }
  // A scene that is being opened is waited for, not the one that it replaces. The wait ends when the event
  // can no longer happen; the script's next action reports what is missing.
  const auto& session = viewer_.session;
  const auto is_over = [this, &session] {
    return !viewer_.notices.errors().empty() &&
           (!session.has_scene() || (session.status().is_idle && !session.mesh()));
  };
  if (words[1] == "mesh") {
    waits_ = [=, &session] { return (session.mesh() && !session.is_opening()) || is_over(); };
  } else if (words[1] == "light") {
    waits_ = [=, &session] { return (session.light() && !session.is_opening()) || is_over(); };
  } else if (words[1] == "view") {
    waits_ = [=, this, &session] {
      return (viewer_.has_view() && !viewer_.camera.is_moving() && !session.is_opening()) || is_over();
    };
  } else if (words[1] == "finished") {
    waits_ = [=, this] { return (viewer_.has_view() && viewer_.is_at_rest()) || is_over(); };
  } else if (words[1] == "error") {
    waits_ = [this] { return !viewer_.notices.errors().empty(); };
  } else {
    throw InputError(fmt::format("there is no waiting for '{}'", words[1]));
  }
}

void ScriptPlayer::expect(const Words& words) {
  const auto& errors = viewer_.notices.errors();
  const auto said = errors.empty() ? std::string("nothing went wrong") : fmt::format("'{}'", errors.back());
  if (words[1] == "mesh" && !viewer_.session.mesh())
    throw InputError(fmt::format("there is no mesh: {}", said));
  if (words[1] == "light" && !viewer_.session.light())
    throw InputError(fmt::format("there is no light: {}", said));
  if (words[1] == "no-error" && !errors.empty())
    throw InputError(fmt::format("something went wrong: {}", said));
  if (words[1] == "file" && viewer_.session.title() != rest(words, 2))
    throw InputError(
        fmt::format("expected the file '{}', but '{}' is shown", rest(words, 2), viewer_.session.title()));
  if (words[1] == "lamp") return expect_lamp(words);
  if (words[1] == "luminaire") return expect_luminaire(words);
  if (words[1] == "error" && (errors.empty() || errors.back().find(rest(words, 2)) == std::string::npos))
    throw InputError(fmt::format("expected an error that says '{}', but {}", rest(words, 2), said));
}

void ScriptPlayer::expect_lamp(const Words& words) const {
  if (words.size() != 4) throw InputError("expected: expect lamp GROUP FACTOR");
  const float factor = script_number("a factor", words[3]);
  for (const auto& lamps : viewer_.light.mixer.lamps) {
    if (lamps.name != words[2]) continue;
    if (lamps.factor == factor) return;
    throw InputError(
        fmt::format("the lamps '{}' have the factor {}, not {}", words[2], lamps.factor, factor));
  }
  throw InputError(fmt::format("there is no light group '{}'", words[2]));
}

// Under the cursor; to half a per cent.
void ScriptPlayer::expect_luminaire(const Words& words) const {
  if (words.size() != 4) throw InputError("expected: expect luminaire GROUP LUMENS");
  const auto lumens = static_cast<double>(script_number("lumens", words[3]));
  const auto& found = viewer_.light_probe.luminaire();
  if (!found) throw InputError("no luminaire is under the cursor");
  if (found->group != words[2] || std::abs(found->lumens - lumens) > 0.005 * lumens)
    throw InputError(
        fmt::format("the luminaire under the cursor is of '{}' and has {:.1f} lm, not '{}' and {} lm",
                    found->group, found->lumens, words[2], lumens));
}

void ScriptPlayer::set_view(const Words& words) {
  if (!viewer_.session.mesh()) throw InputError("there is no mesh yet: wait mesh");
  const auto point = [&](std::size_t i) {
    const auto p = three("a point", words[i]);
    return Vec3(Vec3d(p[0], p[1], p[2]) - viewer_.session.mesh()->patches->origin);
  };
  const Camera camera{.eye = point(1),
                      .target = point(2),
                      .vertical_fov = words.size() > 3 ? script_number("the field of view", words[3])
                                                       : viewer_.camera.pose().vertical_fov};
  viewer_.camera.go_to(pose_of(camera, viewer_.camera.space()));
}

void ScriptPlayer::change_lamp(const Words& words) {
  for (auto& lamps : viewer_.light.mixer.lamps)
    if (lamps.name == words[1]) {
      lamps.factor = script_number("a factor", words[2]);
      if (words.size() > 3) {
        const auto tint = three("a tint", words[3]);
        lamps.tint = Vec3(tint[0], tint[1], tint[2]);
      }
      return viewer_.relight();
    }
  throw InputError(fmt::format("there is no light group '{}'", words[1]));
}

void ScriptPlayer::paint(const Words& words) {
  for (auto& surface : viewer_.light.mixer.materials)
    if (surface.name == words[1]) {
      const auto colour = three("a colour", words[2]);
      surface.colour = Vec3(colour[0], colour[1], colour[2]);
      return viewer_.relight();
    }
  throw InputError(fmt::format("there is no material '{}'", words[1]));
}

void ScriptPlayer::act(const ScriptAction& action) {
  const auto& words = action.words;
  const auto& verb = words[0];
  const auto needs_scene = [&] {
    if (!viewer_.session.has_scene()) throw InputError("there is no scene");
    return &*viewer_.session;
  };
  if (verb == "wait") return wait(words);
  if (verb == "key") {
    key(words[1], true);
    waits_ = [this, name = words[1], frame = 0]() mutable {
      if (++frame == 2) key(name, false);
      return frame > 2;
    };
    return;
  }
  if (verb == "hold") {
    key(words[1], true);
    const int count = static_cast<int>(std::lround(script_number("the time", words[2]) / frame_seconds));
    waits_ = [this, name = words[1], left = count]() mutable {
      if (left-- > 0) return false;
      key(name, false);
      return true;
    };
    return;
  }
  if (verb == "down" || verb == "up") return key(words[1], verb == "down");
  if (verb == "move" || verb == "press" || verb == "release" || verb == "click" || verb == "drag")
    return mouse(words);
  if (verb == "wheel")
    return viewer_.handle({.kind = Event::Kind::wheel, .at = Vec2(0.0f, script_number("turns", words[1]))});
  if (verb == "type") return viewer_.handle({.kind = Event::Kind::text, .text = rest(words, 1)});
  if (verb == "resize") {
    const ScreenSize size{whole("a width", words[1]), whole("a height", words[2])};
    if (size.empty()) throw InputError("a window has a width and a height above 0");
    screen_.set_size(size);
    return viewer_.handle({.kind = Event::Kind::resize, .at = Vec2(size.width, size.height)});
  }
  if (verb == "drop") return viewer_.handle({.kind = Event::Kind::drop, .text = rest(words, 1)});
  if (verb == "menu") return choose_menu(viewer_, rest(words, 1));
  if (verb == "view") return set_view(words);
  if (verb == "set") return viewer_.look.set(words[1], words[2]);
  if (verb == "lamp") return change_lamp(words);
  if (verb == "paint") return paint(words);
  if (verb == "compare") return viewer_.compare(rest(words, 1));
  if (verb == "snapshot") return write_png(rest(words, 1), viewer_.snapshot());
  if (verb == "picture") {
    viewer_.save_picture(rest(words, 3), {whole("a width", words[1]), whole("a height", words[2])});
    waits_ = [this] { return viewer_.picture() == nullptr; };
    return;
  }
  if (verb == "save") {
    const auto file = rest(words, 1);
    return ending_of(file) == ".glb" ? viewer_.export_glb(file) : viewer_.save_solution(file);
  }
  if (verb == "bounces")
    return viewer_.show_bounces(words[1] == "all" ? std::nullopt : std::optional(whole("bounces", words[1])));
  if (verb == "expect") return expect(words);
  if (verb == "method") {
    const auto method = method_named(words[1]);
    if (!method) throw InputError(fmt::format("there is no method '{}'", words[1]));
    return viewer_.solve_by(*method);
  }
  if (verb == "error")
    return needs_scene()->set_error(static_cast<double>(script_number("an error", words[1])));
  if (verb == "pause") return needs_scene()->pause();
  if (verb == "resume") return needs_scene()->resume();
  if (verb == "stop") return needs_scene()->stop();
  if (verb == "step") return needs_scene()->step();
  if (verb == "stepping") return needs_scene()->set_stepping(words[1] == "on");
  if (verb == "close") return viewer_.close();
}

}  // namespace luxel
