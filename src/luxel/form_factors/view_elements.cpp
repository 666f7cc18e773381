// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/view_elements.h"

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/none.h"
#include "luxel/patch/side.h"

namespace luxel {
namespace {

// The element of each patch as a number, and the names by number.
struct Labels {
  std::vector<std::uint32_t> of_patch;
  std::vector<std::string> names;
};

Labels labels_of(const Scene& scene, const PatchSet& patches, Between kind) {
  Labels labels;
  labels.of_patch.resize(patches.size());
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto t = patches.triangle[p];
    // Materials of the scene, not of the patches: those may be two-sided copies.
    labels.of_patch[p] = kind == Between::groups      ? scene.triangle_group[t]
                         : kind == Between::objects   ? scene.triangle_object[t]
                         : kind == Between::materials ? static_cast<std::uint32_t>(scene.triangle_material[t])
                                                      : static_cast<std::uint32_t>(p);
  }
  if (kind == Between::groups) labels.names = scene.groups;
  if (kind == Between::objects) labels.names = scene.objects;
  if (kind == Between::materials)
    for (const auto& material : scene.materials) labels.names.push_back(material.name);
  if (kind == Between::patches)
    for (std::size_t p = 0; p < patches.size(); ++p) labels.names.push_back(fmt::format("{}", p));
  return labels;
}

}  // namespace

ViewElements make_view_elements(const Scene& scene, const PatchSet& patches, Between kind,
                                ElementSides sides) {
  if (kind == Between::objects && scene.objects.empty())
    throw InputError(scene.source, "names no objects (lines that begin with o); try groups or materials");
  const auto labels = labels_of(scene, patches, kind);
  ViewElements elements;
  elements.kind = kind;
  elements.of_side.assign(side_count(patches.size()), none);
  for (const std::size_t back : {0, 1}) {
    if (back == 1 && sides == ElementSides::front) break;
    std::vector<double> area(labels.names.size(), 0.0);
    std::vector<std::uint32_t> number(labels.names.size(), none);
    std::vector<std::uint32_t> first(labels.names.size(), none);
    const auto counts = [&](std::size_t p) { return back == 0 || patches.material_of(p).two_sided; };
    for (std::size_t p = patches.size(); p-- > 0;)
      if (counts(p)) first[labels.of_patch[p]] = static_cast<std::uint32_t>(p);
    for (std::size_t p = 0; p < patches.size(); ++p)
      if (counts(p)) area[labels.of_patch[p]] += static_cast<double>(patches.area[p]);
    for (std::size_t l = 0; l < number.size(); ++l) {
      if (first[l] == none) continue;
      number[l] = static_cast<std::uint32_t>(elements.size());
      elements.name.push_back(labels.names[l] + (back == 1 ? ":back" : ""));
      elements.area.push_back(area[l]);
      elements.first_patch.push_back(first[l]);
    }
    for (std::size_t p = 0; p < patches.size(); ++p)
      if (counts(p)) elements.of_side[2 * p + back] = number[labels.of_patch[p]];
  }
  return elements;
}

}  // namespace luxel
