// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/read_obj.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/none.h"
#include "luxel/import/numbers.h"
#include "luxel/import/text.h"
#include "luxel/scene/scene.h"

namespace luxel {
namespace {

constexpr std::size_t statements_per_report = 1 << 14;

// The indices of a corner as the file counts them; 0 where there is none.
struct CornerIndices {
  int position = 0;
  int uv = 0;
  int normal = 0;
};

// Parses 3, 3/1, 3/1/2 or 3//2; exporters also write 3/ and 3//. Returns nothing for other text.
std::optional<CornerIndices> read_corner(std::string_view word) {
  std::array<int, 3> indices = {0, 0, 0};
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const auto field = word.substr(0, word.find('/'));
    const auto end = field.data() + field.size();
    if (i == 0 || !field.empty()) {
      const auto [stop, error] = std::from_chars(field.data(), end, indices[i]);
      if (error != std::errc() || stop != end) return std::nullopt;
    }
    if (field.size() == word.size()) return CornerIndices{indices[0], indices[1], indices[2]};
    word.remove_prefix(field.size() + 1);
  }
  return std::nullopt;
}

// Names that faces use, numbered in the order of first use. The current one is looked up once per face, so
// its number is cached.
class NamesInUse {
 public:
  explicit NamesInUse(std::vector<std::string>& names) : names_(names) {}

  const std::string& now() const { return now_; }
  void set(std::string name) {
    now_ = std::move(name);
    number_ = none;
  }
  std::uint32_t number() {
    if (number_ == none) {
      number_ = numbers_.try_emplace(now_, static_cast<std::uint32_t>(names_.size())).first->second;
      if (number_ == names_.size()) names_.push_back(now_);
    }
    return number_;
  }

 private:
  std::vector<std::string>& names_;
  std::map<std::string, std::uint32_t> numbers_;
  std::string now_ = default_name;
  std::uint32_t number_ = none;
};

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& source, double scale)
      : text_(text), statements_(text), source_(source), scale_(scale) {}

  std::optional<PolygonMesh> read(const Context& context);

 private:
  [[noreturn]] void refuse(const std::string& message) const {
    throw InputError(source_, statements_.line(), message);
  }
  // A number may be followed by a comment, while a name may contain a #.
  std::string_view numbers() const { return operands_.substr(0, operands_.find('#')); }
  std::string name() const { return operands_.empty() ? default_name : std::string(operands_); }

  void take_statement();
  void add_position();
  void add_normal();
  void add_uv();
  void add_face();
  std::uint32_t resolve(int index, std::size_t count, const char* what) const;
  std::uint32_t resolve_uv(int index) const;
  void use_material();
  void use_object();
  std::uint32_t current_material();
  void check_ranges();

  std::string_view text_;
  Statements statements_;
  std::string_view operands_;  // the text after the statement's first word
  const std::string& source_;
  double scale_;
  PolygonMesh mesh_;
  std::vector<std::string> material_names_;
  NamesInUse materials_{material_names_};  // of the last usemtl
  NamesInUse groups_{mesh_.groups};        // of the last g or o
  NamesInUse objects_{mesh_.objects};      // of the last o
  std::size_t material_line_ = 0;          // of the last usemtl; 0: none
  bool has_objects_ = false;
};

void ObjReader::take_statement() {
  operands_ = trim(statements_.text());
  const auto keyword = take_word(operands_);
  if (keyword == "v") return add_position();
  if (keyword == "vn") return add_normal();
  if (keyword == "vt") return add_uv();
  if (keyword == "f") return add_face();
  if (keyword == "usemtl") return use_material();
  if (keyword == "g") return groups_.set(name());
  if (keyword == "o") return use_object();
  if (keyword == "mtllib") mesh_.libraries.push_back({std::string(operands_), statements_.line()});
}

void ObjReader::add_position() {
  const auto p = read_three_precise_numbers(numbers());
  if (!p) refuse(fmt::format("expected three finite numbers after v, found '{}'", excerpt(operands_)));
  if (const auto distance = scale_ * glm::abs(*p); std::max({distance.x, distance.y, distance.z}) > farthest)
    refuse(fmt::format("expected coordinates up to {:g} m, found '{}' at {} m a unit", farthest,
                       excerpt(operands_), scale_));
  mesh_.positions.push_back(*p);
}

// Some exporters write nan for the normal of a face without area; such a normal does not define the front.
void ObjReader::add_normal() {
  const auto n = read_three_numbers(numbers());
  if (!n) mesh_.unreadable_normals.add(statements_.line());
  mesh_.normals.push_back(n.value_or(Vec3(0.0f)));
}

// A single number belongs to a one-dimensional picture; a third one is a depth, which pictures do not have.
void ObjReader::add_uv() {
  auto words = numbers();
  const auto u = read_number(take_word(words));
  const auto second = take_word(words);
  const auto v = second.empty() ? std::optional(0.0f) : read_number(second);
  if (!u || !v) mesh_.unreadable_uvs.add(statements_.line());
  mesh_.uvs.push_back(u && v ? Vec2(*u, *v) : Vec2(0.0f));
}

void ObjReader::add_face() {
  const auto first_corner = mesh_.corners.size();
  auto words = numbers();
  for (auto word = take_word(words); !word.empty(); word = take_word(words)) {
    const auto corner = read_corner(word);
    if (!corner)
      refuse(fmt::format("expected corners such as 3, 3/1 or 3/1/2 after f, found '{}'", excerpt(word)));
    const auto position = resolve(corner->position, mesh_.positions.size(), "vertex");
    const auto normal = corner->normal == 0 ? none : resolve(corner->normal, mesh_.normals.size(), "normal");
    mesh_.corners.push_back({position, normal, resolve_uv(corner->uv)});
  }
  if (mesh_.corners.size() < first_corner + 3) {
    mesh_.corners.resize(first_corner);
    return mesh_.short_faces.add(statements_.line());
  }
  mesh_.faces.push_back({first_corner, static_cast<std::uint32_t>(statements_.line()), current_material(),
                         groups_.number(), objects_.number()});
}

// Converts OBJ indices (from 1, or backwards from -1) to indices from 0. Positive ones may refer to data that
// comes later, so check_ranges() tests them at the end of the file.
std::uint32_t ObjReader::resolve(int index, std::size_t count, const char* what) const {
  if (index > 0) return static_cast<std::uint32_t>(index - 1);
  if (index == 0) refuse(fmt::format("a corner names {} 0, expected indices that count from 1", what));
  const auto back = static_cast<std::size_t>(-std::int64_t{index});
  if (back > count)
    refuse(fmt::format("a corner names {} {}, but only {} were given before this line", what, index, count));
  return static_cast<std::uint32_t>(count - back);
}

// An invalid index costs the face its picture, not the scene its face: tools that strip coordinates leave
// such indices behind. check_ranges() finds those beyond the end.
std::uint32_t ObjReader::resolve_uv(int index) const {
  const auto from_start =
      index > 0 ? std::int64_t{index} - 1 : static_cast<std::int64_t>(mesh_.uvs.size()) + index;
  return index != 0 && from_start >= 0 ? static_cast<std::uint32_t>(from_start) : none;
}

void ObjReader::use_material() {
  materials_.set(name());
  material_line_ = operands_.empty() ? 0 : statements_.line();
}

void ObjReader::use_object() {
  groups_.set(name());
  objects_.set(name());
  has_objects_ = true;
}

std::uint32_t ObjReader::current_material() {
  if (material_line_ == 0) mesh_.faces_without_material.add(statements_.line());
  const auto number = materials_.number();
  if (number == mesh_.materials.size()) mesh_.materials.push_back({materials_.now(), material_line_});
  return number;
}

void ObjReader::check_ranges() {
  std::size_t face = 0;
  for (std::size_t i = 0; i < mesh_.corners.size(); ++i) {
    while (face + 1 < mesh_.faces.size() && mesh_.faces[face + 1].first_corner <= i) ++face;
    auto& corner = mesh_.corners[i];
    const auto check = [&](std::uint32_t index, std::size_t count, const char* what) {
      if (index >= count)
        throw InputError(source_, mesh_.faces[face].line,
                         fmt::format("a corner names {} {}, but the file gives only {}", what,
                                     std::size_t{index} + 1, count));
    };
    check(corner.position, mesh_.positions.size(), "vertex");
    if (corner.normal != none) check(corner.normal, mesh_.normals.size(), "normal");
    if (corner.uv >= mesh_.uvs.size()) corner.uv = none;
  }
}

std::optional<PolygonMesh> ObjReader::read(const Context& context) {
  for (std::size_t i = 0; statements_.next(); ++i) {
    if (i % statements_per_report == 0) {
      const auto left = static_cast<double>(statements_.left()) / static_cast<double>(text_.size());
      if (context.report({.stage = "load", .done = 1.0 - left}) == Next::stop) return std::nullopt;
    }
    take_statement();
  }
  check_ranges();
  if (!has_objects_) mesh_.objects.clear();
  return std::move(mesh_);
}

}  // namespace

std::optional<PolygonMesh> read_obj(std::string_view text, const std::string& source, double scale,
                                    const Context& context) {
  return ObjReader(text, source, scale).read(context);
}

}  // namespace luxel
