// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "luxel/cli/commands.h"
#include "luxel/cli/console.h"
#include "luxel/cli/photometry_text.h"
#include "luxel/cli/streams.h"
#include "luxel/core/output_file.h"
#include "luxel/photometry/polar_svg.h"
#include "luxel/runs/outputs.h"

namespace luxel {
namespace {

constexpr const char* kinds = ".svg";

class PhotometryCommand final : public Command {
 public:
  explicit PhotometryCommand(OptionSet& options) : Command(options) {
    options.set_positional("FILE", file_, "a photometric file, IES LM-63 or EULUMDAT (.ies, .ldt)",
                           ".ies .ldt");
    options.heading("Photometry");
    Declaration output{"output", "FILE", "write the polar diagram of the intensity (.svg)",
                       [this](const std::string& text) { output_ = text; }, [this] { return output_; }};
    output.letter = 'o';
    output.is_output = true;
    output.endings = kinds;
    options.add(std::move(output));
    options.add_number("lamp-set", "count", lamp_set_, 1u, 1000u,
                       "EULUMDAT: which of the alternative sets of lamps, from 1");
    options.add_number("rotate", "degrees", rotate_, -360.0, 360.0,
                       "turn the light about the vertical axis, anticlockwise seen from above");
    options.add_flag("json", json_, "print JSON");
    options.set_examples({{"luxel photometry luminaire.ies", "Flux, beam angles and warnings of a file."},
                          {"luxel photometry luminaire.ldt -o polar.svg", "Draws its polar diagram too."}});
  }

  int run() override {
    if (!output_.empty()) expect_ending("-o", output_, kinds);
    Console console;
    const auto photometry = load_photometry(file_, {.lamp_set = lamp_set_, .rotate = rotate_});
    for (const auto& warning : photometry.warnings) warn(console.log(), warning);
    const PhotometryText text{&photometry, photometric_figures(photometry.intensity), output_};
    if (!output_.empty()) write_file(output_, polar_svg(photometry));
    print_result(json_ ? text.as_json() : text.as_text());
    return exit_fine;
  }

 private:
  std::string file_, output_;
  std::uint32_t lamp_set_ = 1;
  double rotate_ = 0.0;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> make_photometry(CommandLine& line) {
  return std::make_unique<PhotometryCommand>(
      line.command("photometry", "flux, beam angles and polar diagram of a luminaire's photometric file"));
}

}  // namespace luxel
