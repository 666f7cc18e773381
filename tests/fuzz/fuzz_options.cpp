// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "luxel/runs/bake_settings.h"

#include "fuzz/answered.h"

namespace luxel {
namespace {

// Each line: the name of an option, a space, its value.
std::vector<std::pair<std::string, std::string>> options_of(std::string_view text) {
  std::vector<std::pair<std::string, std::string>> options;
  while (!text.empty()) {
    const auto line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    const auto name = line.substr(0, line.find(' '));
    options.emplace_back(name, line.substr(std::min(line.size(), name.size() + 1)));
  }
  return options;
}

}  // namespace
}  // namespace luxel

// Options are refused or set; values are printed so that another set takes them, to the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto options = luxel::options_of({reinterpret_cast<const char*>(data), size});
  luxel::BakeSettings settings, again;
  luxel::OptionSet set("bake", ""), second("bake", "");
  settings.declare(set);
  again.declare(second);
  try {
    set.give(options);
    settings.check();
  } catch (const luxel::Error&) {
    return 0;
  } catch (const std::out_of_range&) {
    return 0;  // no such option
  }
  second.restore(set.values());
  luxel::expect(second.values() == set.values());
  return 0;
}
