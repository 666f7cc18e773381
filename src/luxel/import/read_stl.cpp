// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/read_stl.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <map>
#include <unordered_map>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/import/numbers.h"
#include "luxel/import/read_obj.h"
#include "luxel/import/text.h"
#include "luxel/scene/scene.h"

namespace luxel {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers of STL are little-endian, as ours are");

// A binary file: 80 bytes of any text, the number of triangles, then for each a normal, three corners, and 16
// bits of no fixed meaning.
constexpr std::size_t header_size = 84, triangle_size = 50, normal_size = 12;
constexpr std::size_t triangles_per_report = 1 << 14;

std::size_t declared_triangles(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + header_size - sizeof(count), sizeof(count));
  return count;
}

// Gives positions that are equal (-0 equals 0) one index, in the order of their first use.
class PositionIndex {
 public:
  explicit PositionIndex(std::vector<Vec3d>& positions) : positions_(positions) {}

  std::uint32_t of(const Vec3d& position) {
    const auto place = position + Vec3d(0.0);  // -0 becomes 0
    const auto [found, is_new] = numbers_.try_emplace(place, static_cast<std::uint32_t>(positions_.size()));
    if (is_new) positions_.push_back(place);
    return found->second;
  }

 private:
  struct Hash {
    std::size_t operator()(const Vec3d& p) const {
      std::uint64_t hash = 0;
      for (int i = 0; i < 3; ++i)
        hash = std::rotl(hash ^ std::bit_cast<std::uint64_t>(p[i]), 29) * 0x9E3779B97F4A7C15u;
      return static_cast<std::size_t>(hash ^ (hash >> 32));
    }
  };
  std::vector<Vec3d>& positions_;
  std::unordered_map<Vec3d, std::uint32_t, Hash> numbers_;
};

class StlReader {
 public:
  StlReader(std::string_view bytes, const std::string& source, double scale, const Context& context)
      : bytes_(bytes), source_(source), scale_(scale), context_(context) {}

  std::optional<PolygonMesh> read();

 private:
  bool read_binary();
  bool read_text();
  void begin_solid(std::string_view name);
  void add_face(std::size_t line);
  bool goes_on(std::size_t done) const {
    const auto fraction = static_cast<double>(done) / static_cast<double>(bytes_.size());
    return context_.report({.stage = "load", .done = fraction}) == Next::go_on;
  }
  bool is_near(const Vec3d& p) const {
    const auto metres = scale_ * glm::abs(p);
    return metres.x <= farthest && metres.y <= farthest && metres.z <= farthest;
  }

  std::string_view bytes_;
  const std::string& source_;
  double scale_;
  const Context& context_;
  PolygonMesh mesh_;
  PositionIndex index_{mesh_.positions};
  std::map<std::string, std::uint32_t, std::less<>> solids_;
  std::string name_ = default_name;  // of the current solid
  std::vector<Vec3d> corners_;       // of the current face
};

void StlReader::begin_solid(std::string_view name) {
  name_ = name.empty() ? default_name : std::string(name);
}

void StlReader::add_face(std::size_t line) {
  if (corners_.size() < 3) {
    if (!corners_.empty()) mesh_.short_faces.add(line);
    return corners_.clear();
  }
  const auto [solid, is_new] = solids_.try_emplace(name_, static_cast<std::uint32_t>(mesh_.groups.size()));
  if (is_new) mesh_.groups.push_back(name_);
  mesh_.faces.push_back(
      {mesh_.corners.size(), static_cast<std::uint32_t>(line), 0, solid->second, solid->second});
  for (const auto& corner : corners_) mesh_.corners.push_back({index_.of(corner), none, none});
  corners_.clear();
}

// Returns false where the monitor stops the work; here and below.
bool StlReader::read_binary() {
  const auto count = declared_triangles(bytes_);
  mesh_.corners.reserve(3 * count);
  mesh_.faces.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto begin = header_size + i * triangle_size;
    if (i % triangles_per_report == 0 && !goes_on(begin)) return false;
    std::array<float, 9> numbers;
    std::memcpy(numbers.data(), bytes_.data() + begin + normal_size, sizeof(numbers));
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vec3d p(numbers[3 * corner], numbers[3 * corner + 1], numbers[3 * corner + 2]);
      if (!is_near(p))
        throw InputError(source_,
                         fmt::format("triangle {}: expected finite coordinates up to {:g} m, found {:g} "
                                     "{:g} {:g} at {} m a unit",
                                     i + 1, farthest, p.x, p.y, p.z, scale_));
      corners_.push_back(p);
    }
    add_face(0);
  }
  return true;
}

bool StlReader::read_text() {
  std::size_t statement = 0;
  Statements statements(bytes_);
  for (; statements.next(); ++statement) {
    if (statement % triangles_per_report == 0 && !goes_on(bytes_.size() - statements.left())) return false;
    auto operands = trim(statements.text());
    const auto keyword = lower_case(take_word(operands));
    if (keyword == "solid") {
      begin_solid(operands);
    } else if (keyword == "vertex") {
      const auto p = read_three_precise_numbers(operands);
      if (!p || !is_near(*p))
        throw InputError(source_, statements.line(),
                         fmt::format("expected three finite numbers up to {:g} m after vertex, found '{}'",
                                     farthest, excerpt(operands)));
      corners_.push_back(*p);
    } else if (keyword == "endloop" || keyword == "endfacet") {
      add_face(statements.line());
    } else if (!keyword.empty() && keyword != "facet" && keyword != "outer" && keyword != "endsolid") {
      throw InputError(
          source_, statements.line(),
          fmt::format("expected a statement of STL such as facet or vertex, found '{}'", excerpt(keyword)));
    }
  }
  if (!corners_.empty())
    throw InputError(source_, statements.line(), "the file ends within a facet; it is cut off");
  return true;
}

std::optional<PolygonMesh> StlReader::read() {
  const bool has_header = bytes_.size() >= header_size;
  const auto needed = has_header ? header_size + triangle_size * declared_triangles(bytes_) : header_size;
  const auto first = bytes_.find_first_not_of(" \t\r\n");
  const bool is_text = first != std::string_view::npos && lower_case(bytes_.substr(first, 5)) == "solid" &&
                       bytes_.find('\0') == std::string_view::npos;
  // Binary files may begin with "solid" too; their size identifies them, and some writers append to it.
  const bool is_binary = has_header && (bytes_.size() == needed || (!is_text && bytes_.size() > needed));
  if (!is_binary && !is_text)
    throw InputError(
        source_, has_header ? fmt::format("expected {} bytes for the {} triangles of this binary STL, found "
                                          "{}; it is cut off, or is no STL",
                                          needed, declared_triangles(bytes_), bytes_.size())
                            : std::string("expected an STL file, found neither 'solid' nor a binary one"));
  if (!(is_binary ? read_binary() : read_text())) return std::nullopt;
  mesh_.materials = {{default_name, 0}};
  if (mesh_.groups.size() > 1 || (!mesh_.groups.empty() && mesh_.groups[0] != default_name))
    mesh_.objects = mesh_.groups;
  return std::move(mesh_);
}

}  // namespace

std::optional<PolygonMesh> read_stl(std::string_view bytes, const std::string& source, double scale,
                                    const Context& context) {
  return StlReader(bytes, source, scale, context).read();
}

}  // namespace luxel
