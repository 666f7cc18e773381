// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/diagnostic.h"

#include <iterator>

namespace luxel {
namespace {

struct Kind {
  std::string_view name;
  FaultColour colour;
};

// In the order of DiagnosticKind. Diagnostics of faces are bold, those of edges bright.
constexpr Kind kinds[] = {
    {"no-lamp", {{0.5f, 0.5f, 0.5f}, "grey"}},
    {"lamp-lights-nothing", {{0.9f, 0.05f, 0.6f}, "pink"}},
    {"lamp-faces-wall", {{0.6f, 0.0f, 0.6f}, "magenta"}},
    {"lamp-enclosed", {{0.3f, 0.02f, 0.35f}, "plum"}},
    {"lamp-windings", {{0.95f, 0.3f, 0.5f}, "rose"}},
    {"luminaire-misplaced", {{0.75f, 0.1f, 0.25f}, "crimson"}},
    {"unlit", {{0.02f, 0.02f, 0.06f}, "black"}},
    {"lost-at-backs", {{0.25f, 0.08f, 0.02f}, "brown"}},
    {"reflectance", {{0.9f, 0.85f, 0.6f}, "cream"}},
    {"escape", {{0.1f, 0.65f, 0.95f}, "sky blue"}},
    {"windings", {{0.02f, 0.1f, 0.8f}, "blue"}},
    {"units", {{0.5f, 0.5f, 0.5f}, "grey"}},
    {"opposite", {{0.3f, 0.1f, 0.8f}, "violet"}},
    {"duplicate", {{0.0f, 0.35f, 0.35f}, "teal"}},
    {"overlap", {{0.9f, 0.55f, 0.35f}, "salmon"}},
    {"no-area", {{0.95f, 0.05f, 0.02f}, "red"}},
    {"t-junction", {{0.95f, 0.3f, 0.0f}, "orange"}},
    {"open-edge", {{0.9f, 0.75f, 0.0f}, "yellow"}},
    {"non-manifold-edge", {{0.05f, 0.55f, 0.1f}, "green"}},
    {"sliver", {{0.35f, 0.4f, 0.02f}, "olive"}},
    {"opaque-glass", {{0.15f, 0.25f, 0.45f}, "slate blue"}},
    {"doubled-panes", {{0.0f, 0.55f, 0.6f}, "turquoise"}},
    {"clear-panes", {{0.55f, 0.8f, 0.85f}, "pale blue"}},
    {"covered-diffuser", {{0.75f, 0.6f, 0.9f}, "lavender"}},
};
static_assert(std::size(kinds) == static_cast<std::size_t>(DiagnosticKind::covered_diffuser) + 1);

}  // namespace

std::string_view name(DiagnosticKind kind) { return kinds[static_cast<std::size_t>(kind)].name; }

FaultColour colour(DiagnosticKind kind) { return kinds[static_cast<std::size_t>(kind)].colour; }

std::string_view name(Severity severity) {
  switch (severity) {
    case Severity::error:
      return "error";
    case Severity::warning:
      return "warning";
    case Severity::note:
      return "note";
  }
  return "";
}

}  // namespace luxel
