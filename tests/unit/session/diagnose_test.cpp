// SPDX-License-Identifier: Apache-2.0
// Small meshes, each with a known number of one fault at a known place.
#include "luxel/session/diagnose.h"

#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/scene_files.h"

namespace luxel {
namespace {

// A closed room of 2 m, wound inwards; its ceiling is the lamp.
const std::string corners =
    "mtllib room.mtl\n"
    "v 0 0 0\nv 2 0 0\nv 2 0 2\nv 0 0 2\nv 0 2 0\nv 2 2 0\nv 2 2 2\nv 0 2 2\n";  // lines 2 to 9
const std::string ceiling = "usemtl lamp\nf 5 6 7 8\nusemtl wall\n";             // 10 to 12
const std::string floor_face = "f 1 4 3 2\n";                                    // 13
const std::string left = "f 1 5 8 4\n", right = "f 2 3 7 6\n", rear = "f 1 2 6 5\n";
const std::string front = "f 4 8 7 3\n";                                                // z = 2
const std::string room = corners + ceiling + floor_face + left + right + rear + front;  // to line 17

class Diagnose : public testing::Test {
 protected:
  CheckReport of(const std::string& obj, const LoadOptions& options = {}, int threads = 2) {
    files_.write("room.mtl", mtl_);
    return diagnose(files_.load_text(obj, options), {}, Context(threads));
  }
  std::string mtl_ = "newmtl wall\nKd 0.5 0.5 0.5\nnewmtl lamp\nKd 0 0 0\nKe 1 1 1\n";
  SceneFiles files_;
};

const Diagnostic& found(const CheckReport& report, DiagnosticKind kind) {
  static const Diagnostic nothing;
  const auto at = std::find_if(report.diagnostics.begin(), report.diagnostics.end(),
                               [&](const Diagnostic& f) { return f.kind == kind; });
  EXPECT_NE(at, report.diagnostics.end()) << name(kind) << " was not found";
  return at == report.diagnostics.end() ? nothing : *at;
}

std::string kinds(const CheckReport& report) {
  std::string names;
  for (const auto& diagnostic : report.diagnostics) names += std::string(name(diagnostic.kind)) + " ";
  return names;
}

void expect_near(const Vec3d& a, const Vec3d& b, double within = 1e-6) {
  EXPECT_LE(glm::distance(a, b), within) << a.x << " " << a.y << " " << a.z;
}

TEST_F(Diagnose, finds_nothing_in_a_closed_room) {
  const auto report = of(room);
  EXPECT_EQ(kinds(report), "");
  EXPECT_EQ(report.components, 1u);
  EXPECT_EQ(report.closed_components, 1u);
  EXPECT_DOUBLE_EQ(report.area, 24.0);
  EXPECT_EQ(report.walks.escaped, 0.0);
}

TEST_F(Diagnose, finds_the_hole_where_a_wall_is_missing_and_the_light_that_leaves_by_it) {
  const auto report = of(corners + ceiling + floor_face + left + right + rear);
  EXPECT_EQ(kinds(report), "escape open-edge ");
  EXPECT_EQ(found(report, DiagnosticKind::open_edge).count, 4u);
  EXPECT_EQ(found(report, DiagnosticKind::open_edge).all_places, 1u) << "one rim";
  const auto& escape = found(report, DiagnosticKind::escape);
  EXPECT_EQ(escape.severity, Severity::warning);
  ASSERT_EQ(escape.places.size(), 1u);
  EXPECT_NEAR(escape.places[0].at.z, 2.0, 1e-5);
  EXPECT_NE(escape.places[0].detail.find("through a hole of 2 m x 2 m"), std::string::npos)
      << escape.places[0].detail;
  // A square sends a fifth of its light onto another at right angles to it: the form factor of two faces of a
  // cube that share an edge is 0.20004. 16,384 paths, five standard errors.
  EXPECT_NEAR(report.walks.escaped_at_once, 0.20004, 5.0 * 0.0032);
}

TEST_F(Diagnose, tells_copies_by_whether_they_face_the_other_way) {
  auto report = of(room + "f 1 4 3 2\n");
  EXPECT_EQ(kinds(report), "duplicate ");
  EXPECT_EQ(found(report, DiagnosticKind::duplicate).count, 2u);
  EXPECT_EQ(found(report, DiagnosticKind::duplicate).places[0].line, 18u);
  EXPECT_EQ(found(report, DiagnosticKind::duplicate).places[0].detail, "on line 13, 'wall'");

  report = of(room + "f 1 2 3 4\n");
  // The fans of both begin at the same corner, so they are cut along the same diagonal.
  EXPECT_EQ(kinds(report), "opposite ");
  EXPECT_EQ(found(report, DiagnosticKind::opposite).count, 2u);
}

TEST_F(Diagnose, finds_triangles_without_area_and_slivers) {
  auto report = of(room + "v 1 1 1\nv 1.5 1 1\nf 9 10 9\n");
  EXPECT_EQ(kinds(report), "no-area ");
  EXPECT_EQ(found(report, DiagnosticKind::no_area).count, 1u);
  EXPECT_EQ(found(report, DiagnosticKind::no_area).places[0].line, 20u);
  expect_near(found(report, DiagnosticKind::no_area).places[0].at, {1.25, 1.0, 1.0});

  report = of(room + "v 0.5 1 1\nv 1.5 1 1\nv 1 1.004 1\nf 9 10 11\n");
  EXPECT_EQ(kinds(report), "open-edge sliver ");
  EXPECT_EQ(found(report, DiagnosticKind::sliver).places[0].detail, "250 times as long as high");
}

TEST_F(Diagnose, finds_t_junctions_and_does_not_call_them_holes) {
  const auto report =
      of(corners + ceiling + left + right + rear + front + "v 0 0 1\nv 2 0 1\nf 1 9 10 2\nf 9 4 3 10\n");
  EXPECT_EQ(kinds(report), "t-junction ");
  const auto& junctions = found(report, DiagnosticKind::t_junction);
  EXPECT_EQ(junctions.count, 2u);
  ASSERT_EQ(junctions.places.size(), 2u);
  expect_near(junctions.places[0].at, {0.0, 0.0, 1.0});
  expect_near(junctions.places[1].at, {2.0, 0.0, 1.0});
}

TEST_F(Diagnose, finds_neighbours_that_face_opposite_ways) {
  auto report = of(corners + ceiling + floor_face + left + right + rear + "f 4 3 7 8\n");
  EXPECT_EQ(kinds(report), "windings ");
  EXPECT_EQ(found(report, DiagnosticKind::windings).count, 4u) << "edges";
  EXPECT_EQ(found(report, DiagnosticKind::windings).triangles, (std::vector<std::uint32_t>{10, 11}));
  EXPECT_EQ(found(report, DiagnosticKind::windings).severity, Severity::note)
      << "two-sided: the light is the same";

  report = of(corners + ceiling + floor_face + left + right + rear + "f 4 3 7 8\n", {.one_sided = {"wall"}});
  EXPECT_EQ(kinds(report), "lost-at-backs windings ");
  EXPECT_EQ(found(report, DiagnosticKind::windings).severity, Severity::error);
  // A fifth of the lamp's light meets the wall at once.
  EXPECT_GT(report.walks.lost_at_backs, 0.2);
}

TEST_F(Diagnose, finds_edges_of_more_than_two_triangles) {
  const auto report = of(room + "v 0.5 1 1\nv 1.5 1 1\nf 1 2 10 9\n");
  EXPECT_EQ(kinds(report), "open-edge non-manifold-edge ");
  EXPECT_EQ(found(report, DiagnosticKind::non_manifold_edge).count, 1u);
  EXPECT_EQ(found(report, DiagnosticKind::open_edge).count, 3u);
  expect_near(found(report, DiagnosticKind::non_manifold_edge).places[0].at, {1.0, 0.0, 0.0});
}

TEST_F(Diagnose, says_which_weld_closes_a_gap) {
  // The floor lies a tenth of a millimetre below the walls.
  const auto report = of(corners + ceiling + left + right + rear + front +
                         "v 0 -0.0001 0\nv 2 -0.0001 0\nv 2 -0.0001 2\nv 0 -0.0001 2\nf 9 12 11 10\n");
  const auto& open = found(report, DiagnosticKind::open_edge);
  EXPECT_EQ(open.count, 8u);
  EXPECT_EQ(open.severity, Severity::warning);
  EXPECT_EQ(open.remedy, "welding closes 8 of them");
  EXPECT_EQ(open.hints, (std::vector<Hint>{{Setting::weld, "0.0002"}}));
}

TEST_F(Diagnose, tells_what_the_file_said_of_a_reflectance_above_one) {
  mtl_ += "newmtl snow\nKd 1.2 0.5 0.5\n";
  const auto report = of(corners + ceiling + left + right + rear + front + "usemtl snow\n" + floor_face);
  EXPECT_EQ(kinds(report), "reflectance ");
  EXPECT_EQ(found(report, DiagnosticKind::reflectance).places[0].detail,
            "the file says 1.2 0.5 0.5, on 4 m²");
}

TEST_F(Diagnose, doubts_units_of_a_room_of_kilometres_or_millimetres) {
  EXPECT_NE(found(of(room, {.scale = 1000.0f}), DiagnosticKind::units).remedy.find("scale of 0.001"),
            std::string::npos);
  EXPECT_NE(found(of(room, {.scale = 0.001f}), DiagnosticKind::units).remedy.find("scale of 1000"),
            std::string::npos);
}

TEST_F(Diagnose, finds_lamps_that_face_a_wall_and_lamps_that_are_shut_in) {
  const auto dark_room = corners + "usemtl wall\nf 5 6 7 8\n" + floor_face + left + right + rear + front;
  auto report = of(dark_room);
  EXPECT_EQ(kinds(report), "no-lamp ");
  EXPECT_EQ(found(report, DiagnosticKind::no_lamp).severity, Severity::error);

  report = of(dark_room +
              "usemtl lamp\nv 0.5 1.999 0.5\nv 1.5 1.999 0.5\nv 1.5 1.999 1.5\nv 0.5 1.999 1.5\n"
              "f 12 11 10 9\n");
  EXPECT_EQ(found(report, DiagnosticKind::lamp_faces_wall).remedy, "turn its faces round");
  EXPECT_EQ(found(report, DiagnosticKind::lamp_faces_wall).hints,
            (std::vector<Hint>{{Setting::flip, "lamp"}}));

  // A lamp in a closed box of 4 cm.
  std::string box;
  for (const char* v : {"0.98 0.98 0.98", "1.02 0.98 0.98", "1.02 0.98 1.02", "0.98 0.98 1.02",
                        "0.98 1.02 0.98", "1.02 1.02 0.98", "1.02 1.02 1.02", "0.98 1.02 1.02"})
    box += std::string("v ") + v + "\n";
  box += "f 9 12 11 10\nf 13 14 15 16\nf 9 13 16 12\nf 10 11 15 14\nf 9 10 14 13\nf 12 16 15 11\n";
  report = of(dark_room + box + "usemtl lamp\nv 0.99 1 0.99\nv 1.01 1 0.99\nv 1 1 1.01\nf 17 18 19\n");
  EXPECT_EQ(kinds(report), "lamp-enclosed unlit open-edge ");
  EXPECT_EQ(found(report, DiagnosticKind::unlit).count, 12u) << "the room's twelve triangles";

  // The same box without a lamp stays dark inside, and so does what is in it.
  report = of(room + box + "v 0.99 1 0.99\nv 1.01 1 0.99\nv 1 1 1.01\nf 17 18 19\n");
  EXPECT_EQ(kinds(report), "unlit open-edge ");
  EXPECT_EQ(found(report, DiagnosticKind::unlit).count, 1u);
  expect_near(found(report, DiagnosticKind::unlit).places[0].at, {1.0, 1.0, 0.9967}, 1e-3);
}

TEST_F(Diagnose, finds_what_lies_on_a_larger_surface_in_the_same_plane) {
  const std::string carpet = "v 0.5 0 0.5\nv 1 0 0.5\nv 1 0 1\nv 0.5 0 1\nf 9 12 11 10\n";  // to line 22
  const auto report = of(room + carpet);
  EXPECT_EQ(kinds(report), "overlap open-edge ");
  const auto& overlap = found(report, DiagnosticKind::overlap);
  EXPECT_EQ(overlap.count, 2u);
  EXPECT_EQ(overlap.severity, Severity::note);
  EXPECT_EQ(overlap.places[0].line, 22u);
  EXPECT_EQ(overlap.places[0].detail, "on line 13, 'wall'");
}

TEST_F(Diagnose, counts_places_from_the_files_zero) {
  auto far = room;
  for (const char* v : {"v 0 ", "v 2 "})
    for (auto at = far.find(v); at != std::string::npos; at = far.find(v, at + 4))
      far.replace(at + 2, 1, v[2] == '0' ? "100000" : "100002");
  const auto report = of(far + "f 1 4 3 2\n");
  EXPECT_EQ(kinds(report), "duplicate ");
  EXPECT_NEAR(found(report, DiagnosticKind::duplicate).places[0].at.x, 100000.667, 1e-2);
}

TEST_F(Diagnose, gives_the_same_report_on_any_number_of_threads) {
  const auto open = corners + ceiling + floor_face + left + right + rear;
  const auto one = of(open, {}, 1);
  const auto seven = of(open, {}, 7);
  EXPECT_EQ(one.walks.escaped, seven.walks.escaped);
  EXPECT_EQ(one.rays, seven.rays);
  EXPECT_EQ(found(one, DiagnosticKind::escape).places[0].at,
            found(seven, DiagnosticKind::escape).places[0].at);
}

TEST_F(Diagnose, ends_where_the_monitor_says_stop) {
  files_.write("room.mtl", mtl_);
  const auto report = diagnose(files_.load_text(room), {},
                               Context(1).with_monitor([](const Progress&) { return Next::stop; }));
  EXPECT_FALSE(report.is_whole);
}

TEST(DiagnoseFromTheWild, knows_the_faults_of_the_corner_cases) {
  const std::filesystem::path folder = LUXEL_SOURCE_DIR "/../shared/scenes/corner-cases";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "there are no shared corner cases beside the sources";
  const auto of = [&](const char* file) { return diagnose(load_scene(folder / file), {}, Context(1)); };
  EXPECT_EQ(found(of("xatlas/double_sided.obj"), DiagnosticKind::opposite).count, 2u);
  EXPECT_EQ(found(of("xatlas/zero_area_face.obj"), DiagnosticKind::no_area).count, 1u);
  EXPECT_EQ(found(of("xatlas/degenerate_edge.obj"), DiagnosticKind::no_area).count, 1u);
  EXPECT_EQ(found(of("tinyobjloader/cornell_box.obj"), DiagnosticKind::units).severity, Severity::warning)
      << "its units are millimetres";
}

// The room with a window of glass before the wall z = 2, from line 17 on.
std::string with_sheets(const std::vector<double>& depths) {
  auto text = corners + ceiling + floor_face + left + right + rear + "usemtl glass\n";
  for (std::size_t i = 0; i < depths.size(); ++i)
    text += fmt::format("v 0 0 {0}\nv 2 0 {0}\nv 2 2 {0}\nv 0 2 {0}\nf -4 -3 -2 -1\n", depths[i]);
  return text;
}
constexpr const char* glass = "newmtl wall\nKd 0.5 0.5 0.5\nnewmtl lamp\nKd 0 0 0\nKe 1 1 1\nnewmtl glass\n";

TEST_F(Diagnose, finds_glass_that_is_opaque) {
  mtl_ = std::string(glass) + "Kd 0.1 0.1 0.1\n";
  const auto report = of(with_sheets({2.0}));
  const auto& opaque = found(report, DiagnosticKind::opaque_glass);
  EXPECT_EQ(opaque.severity, Severity::note);
  EXPECT_EQ(opaque.count, 1u);
  EXPECT_EQ(opaque.hints, (std::vector<Hint>{{Setting::glass, "glass=0.8"}}));
  ASSERT_EQ(opaque.places.size(), 1u);
  EXPECT_EQ(opaque.places[0].material, "glass");
  const auto under_sky = of(with_sheets({2.0}), {.sky = Vec3(1.0f)});
  EXPECT_EQ(found(under_sky, DiagnosticKind::opaque_glass).severity, Severity::warning);
  const auto pane = of(with_sheets({2.0}), {.glass = {{"glass", Vec3(0.8f)}}, .sky = Vec3(1.0f)});
  EXPECT_EQ(kinds(pane).find("glass"), std::string::npos);
  EXPECT_EQ(kinds(pane).find("panes"), std::string::npos);
}

TEST_F(Diagnose, finds_panes_that_let_all_light_pass_under_a_sky) {
  mtl_ = std::string(glass) + "d 0.2\n";
  const auto report = of(with_sheets({2.0}), {.sky = Vec3(1.0f)});
  const auto& clear = found(report, DiagnosticKind::clear_panes);
  EXPECT_EQ(clear.severity, Severity::warning);
  EXPECT_EQ(clear.fact, "1 material lets all light pass, as if there were no glass");
  EXPECT_EQ(kinds(of(with_sheets({2.0}))).find("panes"), std::string::npos);  // no sky
}

TEST_F(Diagnose, finds_sheets_within_a_millimetre) {
  mtl_ = std::string(glass) + "d 0.2\n";
  const LoadOptions options{.glass = {{"", Vec3(0.8f)}}, .sky = Vec3(1.0f)};
  const auto report = of(with_sheets({2.0, 2.0005, 2.1}), options);
  EXPECT_EQ(found(report, DiagnosticKind::doubled_panes).count, 4u);
  EXPECT_EQ(kinds(of(with_sheets({2.0, 2.002}), options)).find("doubled"), std::string::npos);
}

TEST_F(Diagnose, finds_diffusers_that_lie_on_a_wall) {
  mtl_ = std::string(glass);
  const LoadOptions options{.glass = {{"glass", Vec3(0.3f), true}}, .sky = Vec3(1.0f)};
  const auto report =
      of(with_sheets({1.0, 0.0005}), options);  // in the midst of the room, and before the rear wall
  const auto& covered = found(report, DiagnosticKind::covered_diffuser);
  EXPECT_EQ(covered.severity, Severity::warning);
  EXPECT_EQ(covered.count, 2u);
  EXPECT_EQ(covered.fact, "2 diffuser triangles lie within 1 mm of a surface");
  EXPECT_EQ(kinds(of(with_sheets({2.0, 1.0}), options)).find("diffuser"), std::string::npos);
  EXPECT_EQ(kinds(report).find("opaque-glass"), std::string::npos);
}

}  // namespace
}  // namespace luxel
