// SPDX-License-Identifier: Apache-2.0
#include "luxel/load/read_obj.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <istream>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include "luxel/load/numbers.h"
#include "luxel/load/statement_stream.h"
#include "luxel/report/error.h"
#include "luxel/scene/scene.h"

namespace luxel {
namespace {

// The indices of a corner as the file counts them; 0 where there is none.
struct CornerIndices {
  int position = 0;
  int normal = 0;
};

// One of 3, 3/1, 3/1/2, 3//2; exporters also write 3/ and 3//. Anything else is nothing.
std::optional<CornerIndices> read_corner(std::string_view word) {
  std::array<int, 3> indices = {0, 0, 0};
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const auto field = word.substr(0, word.find('/'));
    const auto end = field.data() + field.size();
    if (i == 0 || !field.empty()) {
      const auto [stop, error] = std::from_chars(field.data(), end, indices[i]);
      if (error != std::errc() || stop != end) return std::nullopt;
    }
    if (field.size() == word.size()) return CornerIndices{indices[0], indices[2]};
    word.remove_prefix(field.size() + 1);
  }
  return std::nullopt;
}

// Names in the order they first count, with their numbers.
class Numbering {
 public:
  // The number of a name, and whether it is new.
  std::pair<std::uint32_t, bool> number(const std::string& name) {
    const auto [place, is_new] = numbers_.try_emplace(name, static_cast<std::uint32_t>(numbers_.size()));
    return {place->second, is_new};
  }

 private:
  std::map<std::string, std::uint32_t> numbers_;
};

// tinyobjloader tells the statements apart and calls back here. The numbers it brings along are not used but
// read again from the statement's text: to it "abc" and nan are 0, an index too long for an int is -1, and
// the normal of the first corner in "1// 2// 3//" is 2.
class ObjReader : private tinyobj::MaterialReader {
 public:
  ObjReader(std::string_view text, const std::string& source, float scale)
      : statements_(text), source_(source), scale_(scale) {}

  ObjMesh read();

 private:
  [[noreturn]] void refuse(const std::string& message) const {
    throw InputError(source_, statements_.line(), message);
  }
  // What stands behind the keyword; a number may be followed by a comment, while a name may hold a #.
  std::string_view operands() const { return after_first_word(statements_.text()); }
  std::string_view numbers() const { return operands().substr(0, operands().find('#')); }
  static ObjReader& reader(void* me) { return *static_cast<ObjReader*>(me); }

  void add_position();
  void add_normal();
  void add_face();
  std::uint32_t resolve(int index, std::size_t count, const char* what) const;
  void use_material();
  void use_group();
  void use_object();
  std::uint32_t current_material();
  static std::uint32_t current(const std::string& name, Numbering& numbers, std::vector<std::string>& names);
  void check_ranges() const;

  // Called by tinyobjloader at each mtllib. Its own reading of MTL files knows no lines and casts what it
  // finds unseen, so the operands are only noted here; to say yes ends its search for files.
  bool operator()(const std::string&, std::vector<tinyobj::material_t>*, std::map<std::string, int>*,
                  std::string*, std::string*) override {
    mesh_.libraries.push_back({std::string(operands()), statements_.line()});
    return true;
  }

  StatementStream statements_;
  const std::string& source_;
  float scale_;
  ObjMesh mesh_;
  Numbering material_numbers_, group_numbers_, object_numbers_;
  NamedLine material_{default_name, 0};  // of the last usemtl
  std::string group_ = default_name;     // of the last g or o
  std::string object_ = default_name;    // of the last o
  bool has_objects_ = false;
};

void ObjReader::add_position() {
  const auto p = read_three_numbers(numbers());
  if (!p) refuse(fmt::format("expected three finite numbers after v, found '{}'", excerpt(operands())));
  const Vec3 scaled = *p * scale_;
  if (const auto distance = glm::abs(scaled); std::max({distance.x, distance.y, distance.z}) > farthest)
    refuse(fmt::format("expected coordinates up to {:g} m, found '{}' at {} m a unit", farthest,
                       excerpt(operands()), scale_));
  mesh_.positions.push_back(scaled);
}

// Exporters do write nan for the normal of a face without area; it only fails to say which side is the front.
void ObjReader::add_normal() {
  const auto n = read_three_numbers(numbers());
  if (!n) mesh_.unreadable_normals.add(statements_.line());
  mesh_.normals.push_back(n.value_or(Vec3(0.0f)));
}

void ObjReader::add_face() {
  const auto first_corner = mesh_.corners.size();
  auto words = numbers();
  for (auto word = take_word(words); !word.empty(); word = take_word(words)) {
    const auto corner = read_corner(word);
    if (!corner)
      refuse(fmt::format("expected corners such as 3, 3/1 or 3/1/2 after f, found '{}'", excerpt(word)));
    const auto position = resolve(corner->position, mesh_.positions.size(), "vertex");
    const auto normal =
        corner->normal == 0 ? ObjMesh::no_normal : resolve(corner->normal, mesh_.normals.size(), "normal");
    mesh_.corners.push_back({position, normal});
  }
  if (mesh_.corners.size() < first_corner + 3) {
    mesh_.corners.resize(first_corner);
    return mesh_.short_faces.add(statements_.line());
  }
  mesh_.faces.push_back({first_corner, static_cast<std::uint32_t>(statements_.line()), current_material(),
                         current(group_, group_numbers_, mesh_.groups),
                         current(object_, object_numbers_, mesh_.objects)});
}

// From OBJ's counting (from 1, or backwards from -1) to ours. Positive indices may name what the file gives
// later, so check_ranges() looks at them when all is read.
std::uint32_t ObjReader::resolve(int index, std::size_t count, const char* what) const {
  if (index > 0) return static_cast<std::uint32_t>(index - 1);
  if (index == 0) refuse(fmt::format("a corner names {} 0, expected indices that count from 1", what));
  const auto back = static_cast<std::size_t>(-std::int64_t{index});
  if (back > count)
    refuse(fmt::format("a corner names {} {}, but only {} were given before this line", what, index, count));
  return static_cast<std::uint32_t>(count - back);
}

void ObjReader::use_material() {
  material_ = operands().empty() ? NamedLine{default_name, 0}
                                 : NamedLine{std::string(operands()), statements_.line()};
}

void ObjReader::use_group() { group_ = operands().empty() ? default_name : std::string(operands()); }

void ObjReader::use_object() {
  use_group();
  object_ = group_;
  has_objects_ = true;
}

std::uint32_t ObjReader::current_material() {
  if (material_.line == 0) mesh_.faces_without_material.add(statements_.line());
  const auto [number, is_new] = material_numbers_.number(material_.name);
  if (is_new) mesh_.materials.push_back(material_);
  return number;
}

// The number of the name that holds for the face at hand.
std::uint32_t ObjReader::current(const std::string& name, Numbering& numbers,
                                 std::vector<std::string>& names) {
  const auto [number, is_new] = numbers.number(name);
  if (is_new) names.push_back(name);
  return number;
}

void ObjReader::check_ranges() const {
  std::size_t face = 0;
  for (std::size_t i = 0; i < mesh_.corners.size(); ++i) {
    while (face + 1 < mesh_.faces.size() && mesh_.faces[face + 1].first_corner <= i) ++face;
    const auto& corner = mesh_.corners[i];
    const auto check = [&](std::uint32_t index, std::size_t count, const char* what) {
      if (index >= count)
        throw InputError(source_, mesh_.faces[face].line,
                         fmt::format("a corner names {} {}, but the file gives only {}", what,
                                     std::size_t{index} + 1, count));
    };
    check(corner.position, mesh_.positions.size(), "vertex");
    if (corner.normal != ObjMesh::no_normal) check(corner.normal, mesh_.normals.size(), "normal");
  }
}

ObjMesh ObjReader::read() {
  using tinyobj::real_t;
  tinyobj::callback_t on;
  on.vertex_cb = [](void* me, real_t, real_t, real_t, real_t) { reader(me).add_position(); };
  on.normal_cb = [](void* me, real_t, real_t, real_t) { reader(me).add_normal(); };
  on.index_cb = [](void* me, tinyobj::index_t*, int) { reader(me).add_face(); };
  on.usemtl_cb = [](void* me, const char*, int) { reader(me).use_material(); };
  on.group_cb = [](void* me, const char**, int) { reader(me).use_group(); };
  on.object_cb = [](void* me, const char*) { reader(me).use_object(); };

  std::istream stream(&statements_);
  stream.exceptions(std::ios::badbit);  // or it would swallow what the buffer throws
  tinyobj::LoadObjWithCallback(stream, on, this, this);
  check_ranges();
  if (!has_objects_) mesh_.objects.clear();
  return std::move(mesh_);
}

}  // namespace

ObjMesh read_obj(std::string_view text, const std::string& source, float scale) {
  return ObjReader(text, source, scale).read();
}

}  // namespace luxel
