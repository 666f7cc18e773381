// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>

#include "luxel/cli/commands.h"
#include "luxel/cli/streams.h"
#include "luxel/cli/weather_text.h"

namespace luxel {
namespace {

class WeatherCommand final : public Command {
 public:
  explicit WeatherCommand(OptionSet& options) : Command(options) {
    options.set_positional("FILE", file_, "a weather file, EPW or WEA (.epw, .wea)", ".epw .wea");
    options.heading("Weather");
    options.add_flag("json", json_, "print JSON");
    options.set_examples(
        {{"luxel weather city.epw", "Place, sums, brightest hours and oddities of a file."}});
  }

  int run() override {
    const auto weather = load_weather(file_);
    const auto figures = weather_figures(weather);
    print_result(json_ ? json_of(weather, figures) : text_of(weather, figures));
    return exit_fine;
  }

 private:
  std::string file_;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> make_weather(CommandLine& line) {
  return std::make_unique<WeatherCommand>(
      line.command("weather", "place, sums, brightest hours and oddities of a weather file"));
}

}  // namespace luxel
