// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <filesystem>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "luxel/cli/commands.h"
#include "luxel/cli/console.h"
#include "luxel/cli/finish.h"
#include "luxel/cli/solved_scene.h"
#include "luxel/core/ending_of.h"
#include "luxel/core/output_file.h"
#include "luxel/export/export_round_trip.h"
#include "luxel/image/image_file.h"
#include "luxel/render/lightmap_picture.h"
#include "luxel/render/radiance_pages.h"
#include "luxel/runs/compression_setting.h"
#include "luxel/runs/lightmap_settings.h"
#include "luxel/runs/outputs.h"
#include "luxel/runs/quality.h"
#include "luxel/runs/settings.h"

namespace luxel {
namespace {

constexpr const char* page_kinds = ".exr .png";
constexpr const char* unwrapped_kinds = ".glb .obj";

// "map.exr", "map-2.exr", "map-3.exr", ...
std::string name_of_page(const std::string& output, std::size_t page) {
  if (page == 0) return output;
  const std::filesystem::path path(output);
  auto named = path;
  named.replace_filename(fmt::format("{}-{}{}", path.stem().string(), page + 1, path.extension().string()));
  return named.string();
}

constexpr std::array axes = {'x', 'y', 'z'};

// "map-x.exr"
std::string name_of_axis(const std::string& output, char axis) {
  const std::filesystem::path path(output);
  auto named = path;
  named.replace_filename(fmt::format("{}-{}{}", path.stem().string(), axis, path.extension().string()));
  return named.string();
}

// `lightmap`: writes the light of a solution to pages.
class LightmapCommand final : public Command {
 public:
  explicit LightmapCommand(OptionSet& options) : Command(options) {
    options.set_positional("SOLUTION", file_, "a .vtkhdf file that 'luxel bake' wrote", ".vtkhdf");
    settings_.declare(options);
    options.heading("Scene");
    options.add_text("scene", "FILE", scene_,
                     "the solved scene: a glTF file whose second texture coordinates give the layout");
    settings_.declare_layout(options);
    picture_.declare_view(options);
    look_.declare_up(options);
    run_.declare(options, page_kinds);
    quality_.declare(options);
    options.show_first(
        {"output", "quality", "texels-per-metre", "page-size", "final-gather", "scene", "preview"});
    options.set_examples(
        {{"luxel lightmap room.vtkhdf -o room.exr", "Pages of irradiance: room.exr, room-2.exr and so on."},
         {"luxel lightmap room.vtkhdf -o room.png --texels-per-metre 40 --preview look.png",
          "Finer texels, in 8 bits, and a picture of the scene with them."}});
  }

  int run() override {
    check();
    settings_.lightmap.texels.directional = !settings_.directional.empty();
    Console console(run_);
    const Context context(run_.threads);
    RunRecord record;
    const auto baked = record.stage("read", [&](auto&) { return read_solution(file_); });
    std::optional<SolvedScene> solved;
    if (!scene_.empty()) {
      solved = record.stage("load", [&](auto&) { return load_solved_scene(scene_, file_, baked, console); });
      if (!solved) return stopped_before_light(console);
      keep_files_of(solved->scene);
    }
    std::optional<Tracer> tracer;
    if (settings_.lightmap.texels.error > 0.0 || !settings_.preview.empty())
      record.stage("hierarchy", [&](auto&) { tracer.emplace(baked.patches, context); });

    if (interrupted()) return stopped_before_light(console);
    PagesInput input{baked.patches, baked.solution};
    if (solved) {
      input.scene = &solved->scene;
      input.metres_per_unit = solved->metres_per_unit;
    }
    const bool gathers = settings_.lightmap.texels.error > 0.0;
    const auto made = record.stage("lightmap", [&](auto& stage) {
      auto pages = make_light_pages(input, settings_, gathers ? &*tracer : nullptr, context, console);
      if (pages) stage.rays = pages->record.made.texels.rays;
      return pages;
    });
    if (!made) return stopped_before_light(console);
    const auto& lightmap = made->lightmap;
    auto files = record.stage(
        "write", [&](auto&) { return write(lightmap, console.reporting(context, !interrupted())); });
    console.clear_bar();
    if (files.empty()) return stopped_before_light(console);
    for (const auto& file : files) console.wrote(file);
    if (!settings_.unwrapped.empty()) {
      if (!record.stage("mesh", [&](auto&) { return write_unwrapped(baked, solved, *made, context); }))
        return stopped_before_light(console);
      files.push_back(settings_.unwrapped);
      console.wrote(settings_.unwrapped);
    }
    std::optional<Camera> camera;
    if (!settings_.preview.empty()) {
      camera =
          record.stage("camera", [&](auto&) { return camera_of(picture_, look_, baked, *tracer, context); });
      record.stage("picture", [&](auto&) {
        const auto picture =
            lightmap_picture(baked.patches, lightmap, *tracer, *camera, picture_.render, context);
        write_picture(settings_.preview,
                      with_sky(picture, baked.patches, *tracer, *camera, picture_.render, context),
                      look_.tone);
      });
      files.push_back(settings_.preview);
      console.wrote(settings_.preview);
    }
    finish({.command = options().name(),
            .baked = &baked,
            .pages = made->record,
            .camera = camera,
            .origin = baked.patches.origin,
            .outputs = files,
            .options = &options(),
            .record = &record},
           run_, console);
    return made->record.made.texels.stopped ? exit_stopped_early : exit_fine;
  }

 private:
  void check() const {
    std::vector<NamedOutput> others;
    check_compression(settings_.compression);
    if (!settings_.error_map.empty()) {
      expect_ending("--error-map", settings_.error_map, ".exr");
      others.push_back({"--error-map", settings_.error_map});
    }
    if (!settings_.directional.empty()) {
      expect_ending("--directional", settings_.directional, ".exr");
      if (settings_.lightmap.texels.error == 0.0)
        throw UsageError("--directional needs a final gather: give --final-gather a fraction, such as 2%");
      for (const auto axis : axes)
        others.push_back({"--directional", name_of_axis(settings_.directional, axis)});
    }
    if (!settings_.unwrapped.empty()) {
      expect_ending("--uv2", settings_.unwrapped, unwrapped_kinds);
      others.push_back({"--uv2", settings_.unwrapped});
    }
    if (!settings_.preview.empty()) {
      expect_ending("--preview", settings_.preview, picture_kinds);
      others.push_back({"--preview", settings_.preview});
    }
    check_before_work(run_, picture_, page_kinds, others);
  }

  // All pages are made before the first is written, so that Ctrl-C leaves all of them or none. Returns their
  // names.
  std::vector<std::string> write(const Lightmap& lightmap, const Context& context) const {
    const auto white = settings_.white == LightmapSettings::automatic_white
                           ? white_of(irradiance_pages(lightmap))
                           : static_cast<float>(settings_.white);
    std::vector<std::string> files, bytes;
    const auto add = [&](std::string name, std::string encoded) {
      files.push_back(std::move(name));
      bytes.push_back(std::move(encoded));
      return !bytes.back().empty();
    };
    for (std::size_t p = 0; p < lightmap.pages.size(); ++p) {
      const auto& page = lightmap.pages[p];
      for (const auto& output : run_.outputs)
        if (!add(name_of_page(output, p), ending_of(output) == ".exr"
                                              ? exr_of(page.irradiance, context)
                                              : png_of_page(page.irradiance, white, context)))
          return {};
      for (std::size_t i = 0; i < page.light_vector.size(); ++i)
        if (!add(name_of_page(name_of_axis(settings_.directional, axes[i]), p),
                 exr_of(page.light_vector[i], context)))
          return {};
      if (!settings_.error_map.empty() &&
          !add(name_of_page(settings_.error_map, p), exr_of(page.standard_error, context)))
        return {};
    }
    for (std::size_t i = 0; i < files.size(); ++i) write_file(files[i], bytes[i]);
    return files;
  }

  bool write_unwrapped(const Baked& baked, const std::optional<SolvedScene>& solved, const LightPages& made,
                       const Context& context) const {
    const RoundTripPages pages{made.lightmap.atlas, {}, 1.0f, made.record.as_file_has_it};
    RoundTripOptions options;
    options.up = up_of(look_, baked.patches);
    options.compression = settings_.compression;
    if (solved) {
      options.metres_per_unit = solved->metres_per_unit;
      return export_unwrapped(settings_.unwrapped, {solved->scene, baked.patches, baked.solution}, pages,
                              options, context);
    }
    auto patches = baked.patches;  // each a triangle of its own
    std::iota(patches.triangle.begin(), patches.triangle.end(), 0u);
    const auto scene = scene_of(patches);
    return export_unwrapped(settings_.unwrapped, {scene, patches, baked.solution}, pages, options, context);
  }

  static std::string png_of_page(Image page, float white, const Context& context) {
    for (auto& pixel : page.pixels) pixel /= white;
    return png_of(page,
                  {{"Encoding", "sRGB of irradiance / white"}, {"White W/m2", fmt::format("{}", white)}},
                  context);
  }

  std::string file_, scene_;
  QualitySettings quality_;
  LightmapSettings settings_;
  PictureSettings picture_;
  LookSettings look_;
  RunSettings run_;
};

}  // namespace

std::unique_ptr<Command> make_lightmap_command(CommandLine& line) {
  return std::make_unique<LightmapCommand>(
      line.command("lightmap", "write the light of a solution as lightmaps"));
}

}  // namespace luxel
