// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/up_axis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "luxel/scene/name_words.h"

namespace luxel {
namespace {

// One number per axis.
using PerAxis = std::array<double, 3>;

// Weights of the votes, each of which lies in [-1, 1]. Measured on fourteen scenes with y or z up, each also
// turned to the other axis, and without its names.
constexpr double names_weight = 4.0;    // decides where there are such names
constexpr double lengths_weight = 1.0;  // many small surfaces count as much as a few large ones
constexpr double areas_weight = 0.5;
constexpr double symmetry_weight = 0.8;  // for each of the two measures
constexpr double turned_weight = 1.0;
constexpr double lamps_weight = 0.4;  // lower: windows that are lamps shine sideways
constexpr double y_weight = 0.05;     // y where nothing decides

constexpr double named_area = 0.005;    // fraction of the area from which on names decide
constexpr double turned_part = 0.03;    // fraction of the lengths from which on turned things count fully
constexpr double upright = 0.02;        // sine of the largest angle from the vertical
constexpr double clearly_turned = 0.1;  // sine of the smallest angle from an axis
constexpr double along_axis = 0.995;    // cosine: within 6 degrees
constexpr double near_end = 0.03;       // of the extent

constexpr auto level_names = std::to_array<std::string_view>(
    {"floor", "floors", "flooring", "ceiling", "ceilings", "ground", "carpet", "parquet", "terrain", "lawn",
     "pavement", "fussboden", "boden", "zimmerdecke", "plafond", "pavimento", "soffitto", "suelo", "techo"});

// The lead of y over z, -1 to 1; 0 without votes.
double lead(double y, double z) { return y + z > 0.0 ? (y - z) / (y + z) : 0.0; }

// How much more x resembles z than y: 1 where y is the odd one, -1 where z is.
double symmetry(const PerAxis& of) { return std::abs(lead(of[0], of[1])) - std::abs(lead(of[0], of[2])); }

bool is_level_name(std::string_view name) {
  for (const auto& word : words_of(name))
    if (std::find(level_names.begin(), level_names.end(), word) != level_names.end()) return true;
  return false;
}

template <typename Items, typename NameOf>
std::vector<bool> level_named(const Items& items, const NameOf& name_of) {
  std::vector<bool> found;
  for (const auto& item : items) found.push_back(is_level_name(name_of(item)));
  return found;
}

// Upright faces by their direction around an axis: a quarter turn in bins, and in each those that look there
// and those at right angles to it. Things with corners and round ones have both; a pitched roof has one.
class Turned {
 public:
  void add(double a, double b, double weight) {
    const auto first = std::abs(a), second = std::abs(b);
    const bool is_second_quarter = a * b < 0.0;
    const auto along = is_second_quarter ? second : first, across = is_second_quarter ? first : second;
    const auto bin = std::min(static_cast<std::size_t>(across / (along + across) * bins), bins - 1);
    (is_second_quarter ? second_ : first_)[bin] += weight;
  }
  double paired() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < bins; ++i) {
      const auto low = i > 0 ? i - 1 : 0, high = std::min(i + 2, bins);
      double opposite = 0.0;
      for (auto j = low; j < high; ++j) opposite += second_[j];
      sum += 2.0 * std::min(first_[i], opposite);
    }
    return sum;
  }

 private:
  static constexpr std::size_t bins = 36;
  std::array<double, bins> first_ = {}, second_ = {};
};

struct Surface {
  Vec3d normal;  // unit
  double area = 0.0;
  Vec3d middle;
};

class Evidence {
 public:
  explicit Evidence(const Scene& scene) : scene_(scene), box_(bounds(scene)) {
    in_group_ = level_named(scene.groups, [](const std::string& name) { return name; });
    in_object_ = level_named(scene.objects, [](const std::string& name) { return name; });
    of_material_ = level_named(scene.materials, [](const Material& material) { return material.name; });
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) add(t);
    close_open_sides();
  }

  // Above 0: y is up.
  double score() const {
    const auto turned_y = turned_[1].paired(), turned_z = turned_[2].paired();
    const auto turned_confidence = std::min(1.0, (turned_y + turned_z) / (turned_part * length_));
    const bool has_names = named_[1] + named_[2] > named_area * area_;
    return (has_names ? names_weight * lead(named_[1], named_[2]) : 0.0) +
           lengths_weight * lead(by_length_[1], by_length_[2]) +
           areas_weight * lead(by_area_[1], by_area_[2]) +
           symmetry_weight * (symmetry(closed_length_) + symmetry(closed_area_)) +
           turned_weight * turned_confidence * lead(turned_y, turned_z) +
           lamps_weight * lead(lamps_[1], lamps_[2]) + y_weight;
  }

 private:
  void add(std::size_t triangle);
  void add_end(int axis, const Surface& surface);
  void close_open_sides();
  bool has_level_name(std::size_t triangle) const;

  const Scene& scene_;
  Bounds box_;
  std::vector<bool> in_group_, in_object_, of_material_;
  double area_ = 0.0, length_ = 0.0;  // of all
  PerAxis by_area_ = {}, by_length_ = {}, named_ = {}, lamps_ = {};
  PerAxis closed_area_ = {}, closed_length_ = {};           // as if open sides were closed
  std::array<Turned, 3> turned_;                            // around each axis
  std::array<PerAxis, 2> end_area_ = {}, end_length_ = {};  // of what lies at the low and the high end
};

bool Evidence::has_level_name(std::size_t triangle) const {
  return in_group_[scene_.triangle_group[triangle]] ||
         of_material_[static_cast<std::size_t>(scene_.triangle_material[triangle])] ||
         (!in_object_.empty() && in_object_[scene_.triangle_object[triangle]]);
}

void Evidence::add(std::size_t triangle) {
  const auto& corners = scene_.triangles[triangle];
  const Vec3d a(scene_.positions[corners[0]]), b(scene_.positions[corners[1]]),
      c(scene_.positions[corners[2]]);
  const auto cross = glm::cross(b - a, c - a);
  const auto twice_area = glm::length(cross);
  if (!(twice_area > 0.0) || !std::isfinite(twice_area)) return;
  const Surface surface{cross / twice_area, 0.5 * twice_area, (a + b + c) / 3.0};
  const auto length = std::sqrt(surface.area);
  area_ += surface.area;
  length_ += length;
  const auto& material = scene_.materials[static_cast<std::size_t>(scene_.triangle_material[triangle])];
  const auto power =
      surface.area * static_cast<double>(material.emittance.r + material.emittance.g + material.emittance.b);
  const bool is_named = has_level_name(triangle);
  for (int k = 0; k < 3; ++k) {
    const auto axis = static_cast<std::size_t>(k);
    const auto squared = surface.normal[k] * surface.normal[k];
    const auto level = squared * squared * squared * squared;  // a slope of 25 degrees counts half
    by_area_[axis] += level * surface.area;
    by_length_[axis] += level * length;
    if (is_named) named_[axis] += squared * surface.area;
    if (std::abs(surface.normal[k]) > along_axis) add_end(k, surface);
    if (-surface.normal[k] > along_axis && surface.middle[k] > static_cast<double>(box_.center()[k]))
      lamps_[axis] += power;
    const auto u = surface.normal[(k + 1) % 3], v = surface.normal[(k + 2) % 3];
    if (std::abs(surface.normal[k]) < upright && std::min(std::abs(u), std::abs(v)) > clearly_turned)
      turned_[axis].add(u, v, length);
  }
}

void Evidence::add_end(int axis, const Surface& surface) {
  const auto low = static_cast<double>(box_.low[axis]), high = static_cast<double>(box_.high[axis]);
  const auto margin = near_end * (high - low);
  for (std::size_t end = 0; end < 2; ++end) {
    if (std::abs(surface.middle[axis] - (end == 0 ? low : high)) > margin) continue;
    end_area_[end][static_cast<std::size_t>(axis)] += surface.area;
    end_length_[end][static_cast<std::size_t>(axis)] += std::sqrt(surface.area);
  }
}

// A room that is cut open towards its viewer, or that has no roof, is rated as if that side were closed.
void Evidence::close_open_sides() {
  constexpr double closed = 0.5, open = 0.1;  // fractions of the box's side
  const Vec3d size(box_.size());
  closed_area_ = by_area_;
  closed_length_ = by_length_;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<int>(axis);
    const auto side = size[(k + 1) % 3] * size[(k + 2) % 3];
    for (std::size_t end = 0; end < 2; ++end)
      if (end_area_[end][axis] > closed * side && end_area_[1 - end][axis] < open * side) {
        closed_area_[axis] += end_area_[end][axis];
        closed_length_[axis] += end_length_[end][axis];
      }
  }
}

}  // namespace

Vec3 up_axis(const Scene& scene) {
  return Evidence(scene).score() < 0.0 ? Vec3(0.0f, 0.0f, 1.0f) : Vec3(0.0f, 1.0f, 0.0f);
}

Vec3 up_of_scene(const Scene& scene, const Vec3& given) {
  if (given != Vec3(0.0f)) return given;
  return scene.up != Vec3(0.0f) ? scene.up : up_axis(scene);
}

}  // namespace luxel
