// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "luxel/core/hint.h"
#include "luxel/core/log.h"
#include "luxel/core/vector.h"

namespace luxel {

enum class DiagnosticKind {
  no_lamp,
  lamp_lights_nothing,
  lamp_faces_wall,
  lamp_enclosed,
  lamp_windings,
  luminaire_misplaced,
  unlit,
  lost_at_backs,
  reflectance,
  escape,
  windings,
  units,
  opposite,
  duplicate,
  no_area,
  t_junction,
  open_edge,
  non_manifold_edge,
  sliver,
  opaque_glass,
  doubled_panes,
  clear_panes,
  covered_diffuser,
};

// Where something was found. Names are those of the file.
struct Place {
  std::uint32_t line = 0;  // in the scene's file, from 1; 0 where unknown
  std::string group = {}, object = {}, material = {};
  Vec3d at{0.0};            // m, as the file counts (times --scale)
  std::string detail = {};  // what is special about it: "2.3 m²"; may be empty
};

struct Diagnostic {
  DiagnosticKind kind = DiagnosticKind::no_lamp;
  Severity severity = Severity::note;
  std::size_t count = 0;           // of what the fact speaks of: triangles, edges, loops, materials
  std::string fact = {};           // one sentence: what is the matter, with numbers
  std::string consequence = {};    // one sentence: what Luxel will do about it
  std::string remedy = {};         // one sentence: what changes that
  std::vector<Hint> hints = {};    // the settings that do, where any does
  std::vector<Place> places = {};  // the worst first, as many as were asked for
  std::size_t all_places = 0;      // that there are

  std::vector<std::uint32_t> triangles = {};    // all concerned, as indices in the scene
  std::vector<std::array<Vec3, 2>> edges = {};  // all concerned, m
};

// "t-junction": for reports and files.
std::string_view name(DiagnosticKind kind);
std::string_view name(Severity severity);

// The colour that a kind has in every file of diagnostics: linear, and in words.
struct FaultColour {
  Vec3 linear;
  std::string_view word;
};
FaultColour colour(DiagnosticKind kind);

}  // namespace luxel
