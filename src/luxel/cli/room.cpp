// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "luxel/cli/commands.h"
#include "luxel/cli/room_model.h"
#include "luxel/cli/streams.h"
#include "luxel/core/output_file.h"
#include "luxel/runs/outputs.h"

namespace luxel {
namespace {

using Json = nlohmann::ordered_json;

// `room`: writes an empty room as a scene.
class RoomCommand final : public Command {
 public:
  explicit RoomCommand(OptionSet& options) : Command(options) {
    options.set_positional("SIZE", size_, "length x width x height, m, such as 6x4x2.8: along x, y and z");
    options.heading("Room");
    Declaration output{"output", "FILE", "OBJ file to write; materials go to an .mtl file beside it",
                       [this](const std::string& text) { output_ = text; }, [this] { return output_; }};
    output.letter = 'o';
    output.is_output = true;
    output.endings = ".obj";
    options.add(std::move(output));
    options.add({"reflectance", "C,W,F", "reflectance of ceiling, walls and floor, per cent",
                 [this](const std::string& text) { parse_reflectance(text); },
                 [this] {
                   const auto& r = room_.reflectance;
                   return fmt::format("{},{},{}", r[0], r[1], r[2]);
                 }});
    Declaration window{
        "window", "WALL:X,Z,W,H",
        "a window with a pane of glass: south (y = 0), east, north or west wall; distance along it from its "
        "lower x or y, sill above the floor, width and height, m, such as south:1,0.9,2,1.2; repeatable",
        [this](const std::string& text) {
          const auto parsed = parse_room_window(text);
          if (!parsed)
            throw UsageError(fmt::format(
                "--window: expected a wall (south, east, north, west), distance along it, sill, width and "
                "height in metres, such as south:1,0.9,2,1.2, not '{}'",
                text));
          room_.windows.push_back(*parsed);
        },
        [this] {
          std::string text;
          for (const auto& w : room_.windows) text += (text.empty() ? "" : "\n") + text_of(w);
          return text;
        }};
    window.many = true;
    options.add(std::move(window));
    options.add({"names", "C,W,F", "names of the materials of ceiling, walls and floor",
                 [this](const std::string& text) { parse_names(text); },
                 [this] {
                   const auto& n = room_.names;
                   return fmt::format("{},{},{}", n[0], n[1], n[2]);
                 }});
    options.add_flag("json", json_, "print the result as JSON");
    options.add_flag("quiet", quiet_, "print nothing but errors, and what --json prints");
    options.set_examples(
        {{"luxel room 6x4x2.8 -o room.obj", "An empty office with the reflectances 70/50/20."},
         {"luxel room 6x4x2.8 --window south:1,0.9,4,1.5 -o room.obj", "The same with a window."}});
  }

  int run() override {
    const auto size = parse_room_size(size_);
    if (!size)
      throw UsageError(fmt::format(
          "expected length x width x height from 0.1 to 1000 m each, such as 6x4x2.8, not '{}'", size_));
    room_.size = *size;
    check(room_);
    if (output_.empty()) throw UsageError("no file to write: give -o room.obj");
    expect_ending("--output", output_, ".obj");
    const auto mtl = std::filesystem::path(output_).replace_extension(".mtl");
    auto library = mtl.filename().string();
    if (std::any_of(library.begin(), library.end(), [](unsigned char c) { return c <= ' ' || c == '#'; }))
      throw UsageError(fmt::format(
          "--output {}: expected a name without blanks and #, which OBJ files cannot refer to", output_));
    write_file(mtl, mtl_of(room_));
    write_file(output_, obj_of(room_, library));
    if (json_)
      print_result(as_json(mtl.string()));
    else if (!quiet_)
      print_result(output_ + "\n" + mtl.string() + "\n");
    return exit_fine;
  }

 private:
  void parse_reflectance(const std::string& text) {
    const auto values = parse_three(text);
    if (!values || !(std::min({values->x, values->y, values->z}) >= 0.0) ||
        !(std::max({values->x, values->y, values->z}) <= 98.0))
      throw UsageError(
          fmt::format("--reflectance: expected per cent from 0 to 98 of ceiling, walls and floor, such as "
                      "70,50,20, not '{}'",
                      text));
    if (std::max({values->x, values->y, values->z}) <= 1.0 && glm::length(*values) > 0.0)
      throw UsageError(
          fmt::format("--reflectance: expected per cent such as 70,50,20; '{}' looks like fractions", text));
    room_.reflectance = {values->x, values->y, values->z};
  }

  void parse_names(const std::string& text) {
    std::array<std::string, 3> names;
    std::size_t count = 0;
    for (std::size_t at = 0; at <= text.size() && count < 4; ++count) {
      const auto end = std::min(text.find(',', at), text.size());
      if (count < 3) names[count] = text.substr(at, end - at);
      at = end + 1;
    }
    const auto is_word = [](const std::string& name) {
      return !name.empty() && name != "glass" &&
             std::none_of(name.begin(), name.end(), [](unsigned char c) { return c <= ' ' || c == '#'; });
    };
    if (count != 3 || !std::all_of(names.begin(), names.end(), is_word) || names[0] == names[1] ||
        names[1] == names[2] || names[0] == names[2])
      throw UsageError(fmt::format(
          "--names: expected three different words for ceiling, walls and floor, such as ceiling,wall,floor, "
          "and none of them glass, not '{}'",
          text));
    room_.names = names;
  }

  std::string as_json(const std::string& mtl) const {
    const auto& s = room_.size;
    Json json = {{"command", "room"},
                 {"size_m", {s.x, s.y, s.z}},
                 {"reflectance_percent", room_.reflectance},
                 {"windows", room_.windows.size()},
                 {"outputs", {output_, mtl}}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  }

  std::string size_, output_;
  RoomModel room_;
  bool json_ = false, quiet_ = false;
};

}  // namespace

std::unique_ptr<Command> make_room(CommandLine& line) {
  return std::make_unique<RoomCommand>(line.command("room", "write an empty room as a scene (OBJ)"));
}

}  // namespace luxel
