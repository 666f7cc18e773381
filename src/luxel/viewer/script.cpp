// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/script.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "luxel/core/error.h"

namespace luxel {
namespace {

struct Verb {
  std::string_view name;
  std::size_t fewest, most;  // number of words after it
  std::string_view usage;
};
constexpr Verb verbs[] = {
    {"wait", 1, 2, "wait mesh|light|view|finished|error, wait N frames, or wait N seconds"},
    {"key", 1, 1, "key KEY"},
    {"hold", 2, 2, "hold KEY SECONDS"},
    {"down", 1, 1, "down KEY"},
    {"up", 1, 1, "up KEY"},
    {"move", 2, 2, "move X Y"},
    {"press", 1, 1, "press left|right|middle"},
    {"release", 1, 1, "release left|right|middle"},
    {"click", 2, 2, "click X Y"},
    {"drag", 4, 5, "drag X Y X Y [left|right|middle]"},
    {"wheel", 1, 1, "wheel TURNS"},
    {"type", 1, 99, "type TEXT"},
    {"resize", 2, 2, "resize WIDTH HEIGHT"},
    {"drop", 1, 99, "drop FILE"},
    {"menu", 1, 99, "menu MENU/ENTRY"},
    {"view", 2, 3, "view X,Y,Z X,Y,Z [FOV]"},
    {"set", 2, 2, "set CHOICE VALUE"},
    {"lamp", 2, 3, "lamp GROUP FACTOR [R,G,B]"},
    {"paint", 2, 2, "paint MATERIAL R,G,B"},
    {"compare", 1, 99, "compare SOLUTION"},
    {"snapshot", 1, 99, "snapshot FILE"},
    {"picture", 3, 99, "picture WIDTH HEIGHT FILE"},
    {"save", 1, 99, "save FILE"},
    {"method", 1, 1, "method NAME"},
    {"error", 1, 1, "error ERROR"},
    {"bounces", 1, 1, "bounces COUNT|all"},
    {"pause", 0, 0, "pause"},
    {"resume", 0, 0, "resume"},
    {"stop", 0, 0, "stop"},
    {"step", 0, 0, "step"},
    {"stepping", 1, 1, "stepping on|off"},
    {"expect", 1, 99,
     "expect mesh|light|no-error|error TEXT|file NAME|lamp GROUP FACTOR|luminaire GROUP LUMENS"},
    {"close", 0, 0, "close"},
};

void check(const std::string& file, const ScriptAction& action) {
  const auto verb = std::find_if(std::begin(verbs), std::end(verbs),
                                 [&](const Verb& v) { return v.name == action.words.front(); });
  if (verb == std::end(verbs))
    throw InputError(file, action.line, fmt::format("there is no verb '{}'", action.words.front()));
  const auto count = action.words.size() - 1;
  if (count < verb->fewest || count > verb->most)
    throw InputError(file, action.line, fmt::format("expected: {}", verb->usage));
}

}  // namespace

Script parse_script(const std::string& file, std::string_view text) {
  Script script{file, {}};
  std::istringstream lines{std::string(text)};
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::istringstream words(line.substr(0, line.find('#')));
    ScriptAction action{number, {}};
    for (std::string word; words >> word;) action.words.push_back(word);
    if (action.words.empty()) continue;
    check(file, action);
    script.actions.push_back(std::move(action));
  }
  return script;
}

Script read_script(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (!(stream && text << stream.rdbuf()))
    throw InputError(file.string(), "the script cannot be read, or is empty");
  return parse_script(file.string(), text.str());
}

}  // namespace luxel
