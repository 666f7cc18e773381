// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/read_ply.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/image/image.h"
#include "luxel/import/ply_numbers.h"
#include "luxel/import/read_obj.h"
#include "luxel/scene/scene.h"

namespace luxel {
namespace {

constexpr std::size_t elements_per_report = 1 << 14;

// Meaning of a property. Components of vectors of three and of two numbers are consecutive.
enum Role : std::size_t { x, y, z, nx, ny, nz, red, green, blue, u, v, texture, unused };

struct RoleName {
  std::string_view name;
  Role role;
};
constexpr auto role_names = std::to_array<RoleName>({{"x", x},
                                                     {"y", y},
                                                     {"z", z},
                                                     {"nx", nx},
                                                     {"ny", ny},
                                                     {"nz", nz},
                                                     {"red", red},
                                                     {"green", green},
                                                     {"blue", blue},
                                                     {"r", red},
                                                     {"g", green},
                                                     {"b", blue},
                                                     {"diffuse_red", red},
                                                     {"diffuse_green", green},
                                                     {"diffuse_blue", blue},
                                                     {"u", u},
                                                     {"v", v},
                                                     {"s", u},
                                                     {"t", v},
                                                     {"texture_u", u},
                                                     {"texture_v", v},
                                                     {"texnumber", texture}});

Role role_of(const PlyProperty& property) {
  if (property.is_list) return unused;
  const auto found = std::find_if(role_names.begin(), role_names.end(),
                                  [&](const RoleName& known) { return known.name == property.name; });
  return found == role_names.end() ? unused : found->role;
}

// The numbers of one element that have a role, and which roles its kind has.
struct Values {
  std::vector<Role> roles;  // by property
  std::array<double, unused + 1> of = {};
  std::array<bool, unused + 1> has = {};
  std::array<PlyType, unused + 1> type = {};

  explicit Values(const PlyElement& element) {
    for (const auto& property : element.properties) {
      const auto role = role_of(property);
      roles.push_back(role);
      has[role] = true;
      type[role] = property.type;
    }
  }
  bool has_three(Role first) const { return has[first] && has[first + 1] && has[first + 2]; }
  bool has_uv() const { return has[u] && has[v]; }
  Vec3d three(Role first) const { return {of[first], of[first + 1], of[first + 2]}; }
};

float linear(double code, PlyType type) {
  if (!is_whole(type)) return code > 0.0 ? static_cast<float>(std::min(code, 1.0)) : 0.0f;
  const auto most = size_of(type) == 1 ? 255.0 : size_of(type) == 2 ? 65535.0 : 4294967295.0;
  return srgb_decode(static_cast<float>(std::clamp(code / most, 0.0, 1.0)));
}

Vec3 colour_of(const Values& values) {
  return {linear(values.of[red], values.type[red]), linear(values.of[green], values.type[green]),
          linear(values.of[blue], values.type[blue])};
}

bool is_index_list(const PlyProperty& property) {
  return property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
}

class PlyReader {
 public:
  PlyReader(std::string_view bytes, const std::string& source, double scale, const Context& context)
      : bytes_(bytes),
        source_(source),
        scale_(scale),
        context_(context),
        header_(read_ply_header(bytes, source)),
        numbers_(bytes, header_, source) {}

  std::optional<PlyMesh> read();

 private:
  bool read_element(const PlyElement& element);
  void read_list(const PlyProperty& property);
  void read_indices(const PlyProperty& property);
  void begin_vertices(const PlyElement& element, const Values& values);
  void add_vertex(const Values& values);
  void add_face(const Values& values);
  void add_strip();
  void add_corners(std::span<const std::uint32_t> corners, std::uint32_t material);
  void check_ranges() const;
  Vec2 uv(double a, double b);

  std::string_view bytes_;
  const std::string& source_;
  double scale_;
  const Context& context_;
  PlyHeader header_;
  PlyNumbers numbers_;
  PlyMesh found_;
  PolygonMesh& mesh_ = found_.mesh;
  bool has_normals_ = false, has_uvs_ = false;
  std::vector<std::uint32_t> indices_;  // of the current face
  std::vector<double> uvs_;             // of its corners, where it has its own
};

void PlyReader::read_indices(const PlyProperty& property) {
  const auto count = numbers_.next_count(property);
  indices_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const auto index = numbers_.next(property.type);
    const bool is_separator = index == -1.0;  // of triangle strips
    if (!is_separator && !(index >= 0.0 && index < static_cast<double>(none) && index == std::floor(index)))
      numbers_.refuse(fmt::format("expected the number of a vertex, from 0, found {:g}", index));
    indices_.push_back(is_separator ? none : static_cast<std::uint32_t>(index));
  }
}

void PlyReader::read_list(const PlyProperty& property) {
  if (is_index_list(property)) return read_indices(property);
  const auto count = numbers_.next_count(property);
  const bool is_uvs = property.name == "texcoord";
  for (std::size_t i = 0; i < count; ++i) {
    if (is_uvs)
      uvs_.push_back(numbers_.next(property.type));
    else
      numbers_.skip(property.type);
  }
}

void PlyReader::begin_vertices(const PlyElement& element, const Values& values) {
  if (!values.has_three(x))
    throw InputError(source_, element.line, "expected the properties x, y and z in the element vertex");
  if (!mesh_.positions.empty())
    throw InputError(source_, element.line, "expected one element vertex, found a second one");
  has_normals_ = values.has_three(nx);
  has_uvs_ = values.has_uv();
  mesh_.positions.reserve(element.count);
}

Vec2 PlyReader::uv(double a, double b) {
  const Vec2 pair(static_cast<float>(a), static_cast<float>(b));
  const bool is_sound = std::isfinite(pair.x) && std::isfinite(pair.y);
  if (!is_sound) mesh_.unreadable_uvs.add(numbers_.line());
  return is_sound ? pair : Vec2(0.0f);
}

// Written so that NaN fails too.
void PlyReader::add_vertex(const Values& values) {
  const auto p = values.three(x);
  const auto metres = scale_ * glm::abs(p);
  if (!(metres.x <= farthest && metres.y <= farthest && metres.z <= farthest))
    numbers_.refuse(
        fmt::format("expected finite coordinates up to {:g} m, found {:g} {:g} {:g} at {} m a unit", farthest,
                    p.x, p.y, p.z, scale_));
  mesh_.positions.push_back(p);
  if (has_normals_) {
    const Vec3 normal(values.three(nx));
    if (!is_finite(normal)) mesh_.unreadable_normals.add(numbers_.line());
    mesh_.normals.push_back(is_finite(normal) ? normal : Vec3(0.0f));
  }
  if (has_uvs_) mesh_.uvs.push_back(uv(values.of[u], values.of[v]));
  if (values.has_three(red)) mesh_.vertex_colours.push_back(colour_of(values));
}

void PlyReader::add_corners(std::span<const std::uint32_t> corners, std::uint32_t material) {
  const auto line = static_cast<std::uint32_t>(numbers_.line());
  if (corners.size() < 3) return mesh_.short_faces.add(line);
  const bool has_own_uvs = uvs_.size() == 2 * corners.size();
  const auto first_corner = mesh_.corners.size();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto vertex = corners[i];
    auto at = has_uvs_ ? vertex : none;
    if (has_own_uvs) {
      at = static_cast<std::uint32_t>(mesh_.uvs.size());
      mesh_.uvs.push_back(uv(uvs_[2 * i], uvs_[2 * i + 1]));
    }
    mesh_.corners.push_back({vertex, has_normals_ ? vertex : none, at});
  }
  mesh_.faces.push_back({first_corner, line, material, 0, 0});
}

void PlyReader::add_face(const Values& values) {
  std::uint32_t material = 0;
  if (values.has[texture] && values.of[texture] > 0.0)
    material = static_cast<std::uint32_t>(std::min(
        values.of[texture], static_cast<double>(std::max<std::size_t>(header_.textures.size(), 1) - 1)));
  const auto faces = mesh_.faces.size();
  add_corners(indices_, material);
  if (values.has_three(red) && mesh_.faces.size() > faces) mesh_.face_colours.push_back(colour_of(values));
}

// Every other triangle of a strip is wound the other way. -1 begins another strip.
void PlyReader::add_strip() {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < indices_.size(); ++i) {
    if (indices_[i] == none) begin = i + 1;
    if (i < begin + 2) continue;
    const std::array corners = {indices_[i - 2], indices_[i - 1], indices_[i]};
    const std::array turned = {indices_[i - 1], indices_[i - 2], indices_[i]};
    add_corners((i - begin) % 2 == 0 ? corners : turned, 0);
  }
}

// Returns false where the monitor stops the work.
bool PlyReader::read_element(const PlyElement& element) {
  if (element.properties.empty()) return true;
  numbers_.expect(element);
  Values values(element);
  const bool is_vertex = element.name == "vertex";
  const bool is_strip = element.name == "tristrips";
  const bool has_indices = std::any_of(element.properties.begin(), element.properties.end(), is_index_list);
  const bool is_face = element.name == "face" && has_indices;
  if (is_vertex) begin_vertices(element, values);
  for (std::size_t i = 0; i < element.count; ++i) {
    const auto done = static_cast<double>(numbers_.done()) / static_cast<double>(bytes_.size());
    if (i % elements_per_report == 0 && context_.report({.stage = "load", .done = done}) == Next::stop)
      return false;
    numbers_.begin_element();
    uvs_.clear();
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const auto& property = element.properties[p];
      if (property.is_list)
        read_list(property);
      else if (values.roles[p] == unused)
        numbers_.skip(property.type);
      else
        values.of[values.roles[p]] = numbers_.next(property.type);
    }
    numbers_.end_element();
    if (is_vertex) add_vertex(values);
    if (is_face) add_face(values);
    if (is_strip && has_indices) add_strip();
  }
  return true;
}

// Faces may stand before the vertices, so indices are checked at the end.
void PlyReader::check_ranges() const {
  const auto count = mesh_.positions.size();
  for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
    const auto end = f + 1 < mesh_.faces.size() ? mesh_.faces[f + 1].first_corner : mesh_.corners.size();
    for (auto c = mesh_.faces[f].first_corner; c < end; ++c) {
      const auto vertex = mesh_.corners[c].position;
      if (vertex < count) continue;
      const auto message = fmt::format("face {} names vertex {}, but there are only {} (numbered from 0)", f,
                                       vertex == none ? "-1" : std::to_string(vertex), count);
      if (mesh_.faces[f].line > 0) throw InputError(source_, mesh_.faces[f].line, message);
      throw InputError(source_, message);
    }
  }
}

std::optional<PlyMesh> PlyReader::read() {
  for (const auto& element : header_.elements)
    if (!read_element(element)) return std::nullopt;
  check_ranges();
  mesh_.groups = {default_name};
  mesh_.materials = {{default_name, 0}};
  if (!mesh_.uvs.empty() && !header_.textures.empty()) {
    mesh_.materials.clear();
    for (const auto& name : header_.textures) mesh_.materials.push_back({name, 0});
    found_.textures = header_.textures;
  } else {
    for (auto& face : mesh_.faces) face.material = 0;
  }
  return std::move(found_);
}

}  // namespace

std::optional<PlyMesh> read_ply(std::string_view bytes, const std::string& source, double scale,
                                const Context& context) {
  return PlyReader(bytes, source, scale, context).read();
}

}  // namespace luxel
