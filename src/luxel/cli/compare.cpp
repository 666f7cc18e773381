// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/compare.h"

#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "luxel/cli/commands.h"
#include "luxel/cli/console.h"
#include "luxel/cli/streams.h"
#include "luxel/core/output_file.h"
#include "luxel/image/image_file.h"
#include "luxel/patch/side.h"
#include "luxel/render/difference_picture.h"
#include "luxel/runs/outputs.h"
#include "luxel/runs/quantity.h"
#include "luxel/runs/settings.h"

namespace luxel {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* comparable_kinds = ".vtkhdf .exr .hdr .png";

class Compare final : public Command {
 public:
  explicit Compare(OptionSet& options) : Command(options) {
    options.set_positional("A", a_, "the reference: a solution (.vtkhdf) or a picture (.exr .hdr .png)",
                           comparable_kinds);
    options.set_positional("B", b_, "a solution of the same mesh, or a picture of the same size",
                           comparable_kinds);
    options.heading("Comparison");
    options.add_number("places", "count", places_, 0, 1000, "number of largest differences to list");
    options.add_text("error-a", "FILE", error_a_,
                     "pictures: standard errors of A, from reference --error-picture");
    options.add_text("error-b", "FILE", error_b_, "pictures: standard errors of B");
    options.heading("Difference picture");
    options.add({"scale", "fraction",
                 "difference shown in full colour, such as 10%; auto: fits most differences",
                 [this](const std::string& text) { scale_ = parse_scale(text); },
                 [this] { return scale_ > 0.0 ? as_fraction(scale_) : std::string("auto"); }});
    picture_.declare_view(options);
    look_.declare_up(options);
    run_.declare(options, ".png");
    options.show_first({"output", "places", "scale", "eye", "target", "json"});
    options.set_examples(
        {{"luxel compare truth.vtkhdf baked.vtkhdf", "Whether two solutions agree within their errors."},
         {"luxel compare a.exr b.exr -o difference.png", "Where two pictures differ."}});
  }

  int run() override {
    check();
    Console console(run_);
    is_solution(a_) ? compare_baked(console) : compare_images();
    return exit_fine;
  }

 private:
  static double parse_scale(const std::string& text) {
    if (text == "auto") return 0.0;
    const auto fraction = parse_fraction(text);
    if (!fraction || !(*fraction > 0.0))
      throw UsageError(fmt::format("--scale: expected auto or a share such as 10%, not '{}'", text));
    return *fraction;
  }

  void check() const {
    if (!run_.outputs.empty()) check_before_work(run_, picture_, ".png");
    if (is_solution(a_) != is_solution(b_))
      throw UsageError(fmt::format("{} and {}: expected two solutions (.vtkhdf) or two pictures", a_, b_));
    if (is_solution(a_) && !(error_a_.empty() && error_b_.empty()))
      throw UsageError("--error-a and --error-b belong to pictures: solutions hold their own errors");
    if (!is_solution(a_) && (picture_.eye || picture_.target))
      throw UsageError("--eye and --target belong to solutions: pictures are compared as they are");
  }

  void compare_baked(Console& console) const {
    const auto a = read_solution(a_);
    const auto b = read_solution(b_);
    const auto result = compare_solutions(a, b, places_);
    const auto fractions = relative_differences(a, b);
    if (a.patches.scene_fingerprint != b.patches.scene_fingerprint)
      warn(console.log(), "the meshes are the same, but the scenes have different materials, or skies");
    if (!run_.outputs.empty()) {
      const Context context(run_.threads);
      const Tracer tracer(a.patches, context);
      const auto camera = camera_of(picture_, look_, a, tracer, context);
      const auto width = picture_.render.width;
      const auto height = picture_.render.height;
      draw(seen_fractions(a.patches, fractions, tracer, camera, width, height), width, height);
    }
    say(result, "irradiance of patch sides, W/m²", "side",
        [&](std::size_t i) { return place_of(a, SideId::at(i)); });
  }

  void compare_images() const {
    const auto a = read_image(a_);
    const auto b = read_image(b_);
    std::optional<Image> error_a, error_b;
    if (!error_a_.empty()) error_a = read_image(error_a_);
    if (!error_b_.empty()) error_b = read_image(error_b_);
    const auto result =
        compare_pictures(a, b, error_a ? &*error_a : nullptr, error_b ? &*error_b : nullptr, places_);
    if (!run_.outputs.empty()) draw(relative_differences(a, b), a.width, a.height);
    say(result, "pixels, linear", "pixel", [&](std::size_t i) {
      const auto width = static_cast<std::size_t>(a.width);
      return Json{{"x", i % width}, {"y", i / width}};
    });
  }

  static Json place_of(const Baked& baked, SideId side) {
    const auto middle = baked.patches.in_file(baked.patches.centroid(side.patch()));
    return {{"patch", side.patch()},
            {"side", side.is_back() ? "back" : "front"},
            {"material", baked.patches.material_of(side.patch()).name},
            {"position_m", {middle.x, middle.y, middle.z}}};
  }

  void draw(const std::vector<float>& fractions, int width, int height) const {
    const auto scale = scale_ > 0.0 ? static_cast<float>(scale_) : automatic_scale(fractions);
    const auto image = difference_picture(fractions, width, height, scale);
    for (const auto& output : run_.outputs) write_png(output, image);
  }

  // place(index): describes its location.
  template <typename PlaceOf>
  void say(const Comparison& c, const char* of, const char* kind, const PlaceOf& place) const {
    Json json = {{"command", "compare"},
                 {"a", a_},
                 {"b", b_},
                 {"numbers", c.numbers},
                 {"relative_rms", c.relative_rms},
                 {"mean_bias", c.mean_bias}};
    if (c.scored > 0) {
      json["z"] = {{"scored", c.scored},
                   {"mean_square", c.mean_z2},
                   {"within_1.96", c.within},
                   {"beyond_6", c.outliers}};
      json["bias_error"] = c.bias_error;
    }
    if (const auto agree = c.agrees()) {
      json["expected_rms"] = c.expected_rms;
      json["agree"] = *agree;
    }
    json["largest"] = Json::array();
    for (const auto& d : c.largest) {
      Json entry = {{kind, place(d.index)}, {"a", d.a}, {"b", d.b}};
      if (d.error > 0.0) entry["standard_error"] = d.error;
      json["largest"].push_back(std::move(entry));
    }
    if (!run_.outputs.empty()) json["outputs"] = run_.outputs;
    const auto text = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    if (!run_.report.empty()) write_file(run_.report, text);
    print_result(run_.json ? text : sentences(c, of, json["largest"]));
  }

  static std::string sentences(const Comparison& c, const char* of, const Json& largest) {
    auto text = fmt::format("{} numbers ({})\nrelative RMS {:.3g} %, mean bias {:+.3g} % of A\n", c.numbers,
                            of, 100.0 * c.relative_rms, 100.0 * c.mean_bias);
    if (c.scored > 0)
      text += fmt::format(
          "the stated errors explain {:.3g} % and a bias of {:.2g} %\n"
          "z-scores of {}: mean square {:.3g} (about 1), {:.1f} % within 1.96 (about 95 %), {} beyond 6\n",
          100.0 * c.expected_rms, 100.0 * c.bias_error, c.scored, c.mean_z2, 100.0 * c.within, c.outliers);
    else if (c.expected_rms > 0.0)
      text += fmt::format("the stated errors of the whole explain {:.3g} %\n", 100.0 * c.expected_rms);
    if (const auto agree = c.agrees())
      text += *agree ? "A and B agree within their errors\n" : "A and B do NOT agree within their errors\n";
    else
      text += "not both state an error, so nothing says whether this is noise\n";
    if (!largest.empty()) text += "largest differences (A, B, where):\n";
    for (const auto& d : largest) {
      const auto& where = d.contains("side") ? d["side"] : d["pixel"];
      text += fmt::format("  {:<11.5g} {:<11.5g} ", d["a"].get<double>(), d["b"].get<double>());
      if (where.contains("patch"))
        text += fmt::format("{} of patch {}, {}, at ({:.3f}, {:.3f}, {:.3f})",
                            where["side"].get<std::string>(), where["patch"].get<std::size_t>(),
                            where["material"].get<std::string>(), where["position_m"][0].get<double>(),
                            where["position_m"][1].get<double>(), where["position_m"][2].get<double>());
      else
        text += fmt::format("pixel {}, {}", where["x"].get<std::size_t>(), where["y"].get<std::size_t>());
      if (d.contains("standard_error"))
        text += fmt::format(", {:+.1f} standard errors", (d["b"].get<double>() - d["a"].get<double>()) /
                                                             d["standard_error"].get<double>());
      text += "\n";
    }
    return text;
  }

  std::string a_, b_, error_a_, error_b_;
  std::uint32_t places_ = 10;
  double scale_ = 0.0;  // 0: automatic
  LookSettings look_;
  PictureSettings picture_;
  RunSettings run_;
};

}  // namespace

std::unique_ptr<Command> make_compare(CommandLine& line) {
  return std::make_unique<Compare>(line.command(
      "compare",
      "compare two solutions or pictures, and test whether their standard errors explain the difference"));
}

}  // namespace luxel
