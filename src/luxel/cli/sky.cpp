// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>
#include <utility>

#include "luxel/cli/commands.h"
#include "luxel/cli/console.h"
#include "luxel/cli/sky_picture.h"
#include "luxel/cli/sky_text.h"
#include "luxel/cli/streams.h"
#include "luxel/core/ending_of.h"
#include "luxel/image/image_file.h"
#include "luxel/runs/outputs.h"
#include "luxel/runs/outside_settings.h"
#include "luxel/runs/settings.h"

namespace luxel {
namespace {

constexpr const char* dome_kinds = ".png .exr";

class SkyCommand final : public Command {
 public:
  explicit SkyCommand(OptionSet& options) : Command(options) {
    options.set_positional("KIND", kind_, "the sky: cie:1 to cie:16, uniform, or perez");
    options.heading("Result");
    Declaration output{"output", "FILE",
                       "draw the sky: the dome in false colours (.png), or all directions as an "
                       "equirectangular picture in cd/m² (.exr)",
                       [this](const std::string& text) { output_ = text; }, [this] { return output_; }};
    output.letter = 'o';
    output.is_output = true;
    output.endings = dome_kinds;
    options.add(std::move(output));
    options.add_flag("json", json_, "print JSON");
    options.add_flag("quiet", run_.quiet, "print no warnings, such as oddities of a weather file");
    settings_.declare_sun(options);
    settings_.declare_sky(options);
    options.show_first({"sun", "date", "place", "weather", "hour", "sky-illuminance", "output", "json"});
    options.set_examples(
        {{"luxel sky cie:12 --sun 30,180", "A clear sky with the sun in the south."},
         {"luxel sky cie:16 --sky-illuminance 5000 -o dome.png", "An overcast sky, and its picture."},
         {"luxel sky cie:12 --date 2026-03-21T12:00+01:00 --place 52.5,13.4", "The sun of a date."},
         {"luxel sky perez --weather city.epw --hour 03-21T13", "The sky of an hour of a weather file."}});
  }

  int run() override {
    if (!output_.empty()) expect_ending("-o", output_, dome_kinds);
    Console console(run_);
    const auto light = settings_.daylight(kind_);
    if (light.hour)
      for (const auto& oddity : light.hour->weather.oddities) warn(console.log(), oddity);
    if (ending_of(output_) == ".png") write_png(output_, sky_dome(light));
    if (ending_of(output_) == ".exr") write_exr(output_, sky_panorama(light));
    print_result(json_ ? json_of(light, output_) : text_of(light));
    return exit_fine;
  }

 private:
  std::string kind_, output_;
  bool json_ = false;
  RunSettings run_;
  OutsideSettings settings_;
};

}  // namespace

std::unique_ptr<Command> make_sky(CommandLine& line) {
  return std::make_unique<SkyCommand>(
      line.command("sky", "luminances and illuminances of a sky, and where the sun is"));
}

}  // namespace luxel
