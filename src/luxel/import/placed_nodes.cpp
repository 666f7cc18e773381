// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/placed_nodes.h"

#include <cmath>

#include <fmt/format.h>

namespace luxel {
namespace {

glm::dmat4 rotation_of(const JsonValue& rotation) {
  const auto q = rotation.numbers({0.0, 0.0, 0.0, 1.0});
  const auto length = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
  if (!(length > 0.0) || !std::isfinite(length))
    rotation.refuse("expected a quaternion of length 1, found one without length");
  const auto x = q[0] / length, y = q[1] / length, z = q[2] / length, w = q[3] / length;
  return glm::dmat4(1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w), 2.0 * (x * z - y * w), 0.0,  //
                    2.0 * (x * y - z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + x * w), 0.0,  //
                    2.0 * (x * z + y * w), 2.0 * (y * z - x * w), 1.0 - 2.0 * (x * x + y * y), 0.0,  //
                    0.0, 0.0, 0.0, 1.0);
}

// By columns, as glTF has them too.
glm::dmat4 placement_of(const JsonValue& node) {
  glm::dmat4 placement(1.0);
  if (const auto matrix = node["matrix"]) {
    const auto numbers = matrix.numbers(std::vector<double>(16));
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 4; ++row)
        placement[column][row] = numbers[static_cast<std::size_t>(4 * column + row)];
    return placement;
  }
  const auto scale = node["scale"].numbers({1.0, 1.0, 1.0});
  const auto translation = node["translation"].numbers({0.0, 0.0, 0.0});
  placement = rotation_of(node["rotation"]);
  for (int axis = 0; axis < 3; ++axis) {
    placement[axis] *= scale[static_cast<std::size_t>(axis)];
    placement[3][axis] = translation[static_cast<std::size_t>(axis)];
  }
  return placement;
}

// The nodes without a parent, the last one first.
std::vector<PlacedNode> roots_of(const GltfFile& file) {
  const auto nodes = file.root()["nodes"];
  std::vector<bool> is_child(nodes.size(), false);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto children = nodes[i]["children"];
    for (std::size_t c = 0; c < children.size(); ++c) {
      file.object(children[c], "nodes");
      is_child[children[c].whole()] = true;
    }
  }
  std::vector<PlacedNode> roots;
  for (auto i = nodes.size(); i-- > 0;)
    if (!is_child[i]) roots.push_back({nodes[i], i});
  if (roots.empty() && nodes.size() > 0)
    nodes.refuse("expected trees of nodes, but each node is below another one");
  return roots;
}

class NodeWalk {
 public:
  explicit NodeWalk(const GltfFile& file) : file_(file), reached_(file.root()["nodes"].size(), false) {}

  std::vector<PlacedNode> walk();

 private:
  // Pushes the nodes that an array names onto the stack, the first on top.
  void push(const JsonValue& indices, const glm::dmat4& world);

  const GltfFile& file_;
  std::vector<bool> reached_;
  std::vector<PlacedNode> stack_;  // the node's own transform is not yet applied
};

void NodeWalk::push(const JsonValue& indices, const glm::dmat4& world) {
  for (auto i = indices.size(); i-- > 0;) {
    const auto node = file_.object(indices[i], "nodes");
    const auto number = indices[i].whole();
    if (reached_[number])
      indices[i].refuse(
          fmt::format("expected a tree of nodes, but node {} is below itself or two others", number));
    reached_[number] = true;
    stack_.push_back({node, number, world});
  }
}

std::vector<PlacedNode> NodeWalk::walk() {
  const auto& root = file_.root();
  const glm::dmat4 identity(1.0);
  if (root["scene"])
    push(file_.object(root["scene"], "scenes")["nodes"], identity);
  else if (root["scenes"].size() > 0)
    push(root["scenes"][std::size_t{0}]["nodes"], identity);
  else
    stack_ = roots_of(file_);
  std::vector<PlacedNode> placed;
  while (!stack_.empty()) {
    auto next = std::move(stack_.back());
    stack_.pop_back();
    next.world = next.world * placement_of(next.node);
    push(next.node["children"], next.world);
    placed.push_back(std::move(next));
  }
  return placed;
}

}  // namespace

std::vector<PlacedNode> placed_nodes(const GltfFile& file) { return NodeWalk(file).walk(); }

}  // namespace luxel
