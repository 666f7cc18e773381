// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "luxel/cli/commands.h"
#include "luxel/cli/console.h"
#include "luxel/cli/streams.h"
#include "luxel/core/ending_of.h"
#include "luxel/core/output_file.h"
#include "luxel/lighting/ugr_table.h"
#include "luxel/runs/outputs.h"
#include "luxel/runs/settings.h"

namespace luxel {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* table_kinds = ".csv .json";

// `ugr-table`: the standard UGR table of a luminaire.
class UgrTableCommand final : public Command {
 public:
  explicit UgrTableCommand(OptionSet& options) : Command(options) {
    options.set_positional("FILE", file_, "a photometric file: IES LM-63 or EULUMDAT", ".ies .ldt");
    options.heading("Table");
    options.add_number("spacing", "H", spacing_, 0.05, 12.0,
                       "distance of the luminaires, in units of their height above the eye");
    options.add_number("lamp-set", "count", lamp_set_, 1, 100,
                       "EULUMDAT: which of the alternative sets of lamps");
    options.add_number(
        "rotate", "degrees", rotate_, -360.0, 360.0,
        "turn the luminaire, anticlockwise seen from above: 90 exchanges crosswise and endwise");
    run_.declare(options, table_kinds);
    options.show_first({"output", "spacing", "json"});
    options.set_examples({{"luxel ugr-table panel.ldt", "The table of CIE 190 for 19 rooms."},
                          {"luxel ugr-table panel.ies -o ugr.csv -o ugr.json", "The same as files."}});
  }

  int run() override {
    if (!run_.outputs.empty()) check_before_work(run_, {}, table_kinds);
    Console console(run_);
    const auto photometry =
        load_photometry(file_, {.lamp_set = static_cast<std::size_t>(lamp_set_), .rotate = rotate_});
    for (const auto& warning : photometry.warnings) warn(console.log(), warning);
    const auto table = ugr_table(photometry, spacing_);
    if (!is_symmetric(photometry.intensity))
      warn(
          console.log(),
          fmt::format("{}: its light is not symmetric about both of its axes, for which UGR tables are made; "
                      "the table is that of its side at {} degrees, and endwise at {}",
                      file_, photometry.format.rfind("IES", 0) == 0 ? 90 : 0,
                      photometry.format.rfind("IES", 0) == 0 ? 0 : 90));
    const auto& size = photometry.opening.size;
    console.say("luminaire",
                fmt::format("{}, {:.4g} lm, opening {:g} x {:g} x {:g} m, {:g} H apart",
                            photometry.luminaire.empty() ? file_ : photometry.luminaire,
                            photometry.intensity.zonal_flux(), size.x, size.y, size.z, spacing_));
    for (const auto& output : run_.outputs)
      write_file(output, ending_of(output) == ".csv" ? csv_of(table) : json_of(photometry, table, {}));
    if (!run_.report.empty()) write_file(run_.report, json_of(photometry, table, run_.outputs));
    if (run_.json)
      print_result(json_of(photometry, table, run_.outputs));
    else if (run_.outputs.empty())
      print_result(text_of(table));
    else
      for (const auto& output : run_.outputs) print_result(output + "\n");
    return exit_fine;
  }

 private:
  static Json values_of(const UgrValues& values) {
    Json rows = Json::array();
    for (const auto& row : values) {
      Json numbers = Json::array();
      for (const auto ugr : row) numbers.push_back(std::isfinite(ugr) ? Json(ugr) : Json(nullptr));
      rows.push_back(std::move(numbers));
    }
    return rows;
  }

  std::string json_of(const Photometry& photometry, const UgrTable& table,
                      const std::vector<std::string>& outputs) const {
    Json json = {{"command", "ugr-table"},
                 {"file", file_},
                 {"luminaire", photometry.luminaire},
                 {"spacing_H", table.spacing},
                 {"rooms_H", Json::array()},
                 {"reflectances", Json::array()},
                 {"crosswise", values_of(table.crosswise)},
                 {"endwise", values_of(table.endwise)}};
    for (const auto& room : ugr_rooms) json["rooms_H"].push_back({room.across, room.along});
    for (const auto& r : ugr_reflectances) json["reflectances"].push_back(name_of(r));
    if (!outputs.empty()) json["outputs"] = outputs;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  }

  std::string file_;
  double spacing_ = 0.25;  // H
  int lamp_set_ = 1;
  double rotate_ = 0.0;  // degrees
  RunSettings run_;
};

}  // namespace

std::unique_ptr<Command> make_ugr_table(CommandLine& line) {
  return std::make_unique<UgrTableCommand>(
      line.command("ugr-table", "UGR table of a luminaire, by CIE 190, from its IES or EULUMDAT file"));
}

}  // namespace luxel
