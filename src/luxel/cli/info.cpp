// SPDX-License-Identifier: Apache-2.0

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "luxel/cli/commands.h"
#include "luxel/cli/console.h"
#include "luxel/cli/run_report.h"
#include "luxel/cli/streams.h"
#include "luxel/core/output_file.h"
#include "luxel/runs/settings.h"
#include "luxel/scene/luminous_efficacy.h"

namespace luxel {
namespace {

class Info final : public Command {
 public:
  explicit Info(OptionSet& options) : Command(options) {
    options.set_positional(
        "FILE", file_, "a solution (.vtkhdf) or a scene (.obj, .glb, .gltf, .ply, .stl, .fbx, .dae, .3ds)",
        ".vtkhdf .obj .glb .gltf .ply .stl .fbx .dae .3ds");
    options.add_flag("json", json_, "print JSON");
    options.set_examples({{"luxel info room.obj", "Size, materials and lamps of a scene."},
                          {"luxel info room.vtkhdf", "How a solution was made, and how accurate it is."}});
  }

  int run() override {
    const auto text = is_solution(file_) ? of_solution() : of_scene();
    print_result(text);
    return exit_fine;
  }

 private:
  std::string of_solution() const {
    const auto baked = read_solution(file_);
    if (!json_) return fmt::format("{}: a solution\n{}", file_, describe(baked));
    RunReport report;
    report.command = "info";
    report.baked = &baked;
    return report.as_json();
  }

  std::string of_scene() const {
    Console console;
    const auto scene = load_scene(file_, {.retriangulate = false}, console.reporting({}));
    const auto box = bounds(scene);
    std::vector<std::size_t> triangles(scene.materials.size(), 0);
    for (const auto m : scene.triangle_material) ++triangles[static_cast<std::size_t>(m)];
    if (json_) return scene_as_json(scene, box, triangles);
    auto text =
        fmt::format("{}: a scene\n{} triangles, {} vertices, {} groups, fingerprint {:016x}\n", file_,
                    scene.triangles.size(), scene.positions.size(), scene.groups.size(), fingerprint(scene));
    text += extent(scene, box);
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
      const auto& m = scene.materials[i];
      text += fmt::format("  {:<24} {:>8} triangles  reflectance {:.3f} {:.3f} {:.3f}", m.name, triangles[i],
                          m.reflectance.r, m.reflectance.g, m.reflectance.b);
      if (m.is_lamp())
        text += fmt::format("  emits {:.4g} lm/m²", lumens(m.emittance.r, m.emittance.g, m.emittance.b));
      if (!m.two_sided) text += "  one-sided";
      if (!m.opaque) text += "  lets light pass";
      if (const auto& t = m.transmittance; t != Vec3(1.0f))
        text += fmt::format("  transmittance {:.3g} {:.3g} {:.3g}", t.r, t.g, t.b);
      if (const auto& t = m.diffuse_transmittance; m.is_diffuser())
        text += fmt::format("  diffuse transmittance {:.3g} {:.3g} {:.3g}", t.r, t.g, t.b);
      text += "\n";
    }
    return text;
  }

  static std::string extent(const Scene& scene, const Bounds& box) {
    const auto low = scene.origin + Vec3d(box.low);
    const auto high = scene.origin + Vec3d(box.high);
    if (scene.origin == Vec3d(0.0))
      return fmt::format("from ({:.4g}, {:.4g}, {:.4g}) to ({:.4g}, {:.4g}, {:.4g}) m\n", low.x, low.y, low.z,
                         high.x, high.y, high.z);
    return fmt::format(
        "from ({}, {}, {}) to ({}, {}, {}) m\nfar from zero: counted inside from ({}, {}, {})\n", low.x,
        low.y, low.z, high.x, high.y, high.z, scene.origin.x, scene.origin.y, scene.origin.z);
  }

  std::string scene_as_json(const Scene& scene, const Bounds& box,
                            const std::vector<std::size_t>& triangles) const {
    using Json = nlohmann::ordered_json;
    const auto triple = [](const auto& v) { return Json{v.x, v.y, v.z}; };
    Json materials = Json::array();
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
      const auto& m = scene.materials[i];
      materials.push_back({{"name", m.name},
                           {"triangles", triangles[i]},
                           {"reflectance", triple(m.reflectance)},
                           {"emittance_W_per_m2", triple(m.emittance)},
                           {"two_sided", m.two_sided},
                           {"opaque", m.opaque},
                           {"transmittance", triple(m.transmittance)},
                           {"diffuse_transmittance", triple(m.diffuse_transmittance)}});
    }
    const Json json = {{"command", "info"},
                       {"triangles", scene.triangles.size()},
                       {"vertices", scene.positions.size()},
                       {"low_m", triple(scene.origin + Vec3d(box.low))},
                       {"high_m", triple(scene.origin + Vec3d(box.high))},
                       {"fingerprint", fmt::format("{:016x}", fingerprint(scene))},
                       {"materials", materials}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  }

  std::string file_;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> make_info(CommandLine& line) {
  return std::make_unique<Info>(line.command("info", "summarise a solution or a scene"));
}

}  // namespace luxel
