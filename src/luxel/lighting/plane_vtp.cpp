// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/plane_vtp.h"

#include <fmt/format.h>

namespace luxel {
namespace {

// Cells of one kind: the numbers of their points.
struct Cells {
  std::string connectivity, offsets;
  std::size_t count = 0, points = 0;

  void add(std::size_t first, std::size_t corners) {
    for (std::size_t k = 0; k < corners; ++k) connectivity += fmt::format("{} ", first + k);
    points += corners;
    offsets += fmt::format("{} ", points);
    ++count;
  }
  std::string xml(const char* tag) const {
    return fmt::format(
        "<{0}><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">{1}</DataArray>\n"
        "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">{2}</DataArray></{0}>\n",
        tag, connectivity, offsets);
  }
};

class PolyData {
 public:
  void add(const PlaneResult& result, std::size_t area) {
    const auto& grid = result.grid;
    const bool is_line = !(grid.height > 0.0);
    const auto half_along = 0.5 * grid.width / static_cast<double>(grid.columns) * grid.along,
               half_across = 0.5 * grid.height / static_cast<double>(grid.rows) * grid.across;
    for (std::size_t i = 0; i < grid.points(); ++i) {
      const auto& at = grid.position[i];
      const auto first = points_;
      if (is_line) {
        point(at);
      } else {
        point(at - half_along - half_across);
        point(at + half_along - half_across);
        point(at + half_along + half_across);
        point(at - half_along + half_across);
      }
      auto& cells = is_line ? vertices_ : rectangles_;
      cells.add(first, points_ - first);
      auto& data = data_[is_line ? 0 : 1];
      data.lux += fmt::format("{:.7g} ", result.light[i].illuminance);
      data.error += fmt::format("{:.4g} ", result.light[i].standard_error());
      data.area += fmt::format("{} ", area);
      data.cylindrical += fmt::format(
          "{:.7g} ", result.cylinders.empty() ? 0.0 : result.cylinders[i].cylindrical.illuminance);
    }
  }

  std::string xml() const {
    const auto data = [&](const char* type, const char* name, std::string Data::*part) {
      return fmt::format("<DataArray type=\"{}\" Name=\"{}\" format=\"ascii\">{}{}</DataArray>\n", type, name,
                         data_[0].*part, data_[1].*part);
    };
    return fmt::format(
               "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" "
               "byte_order=\"LittleEndian\">\n<PolyData><Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" "
               "NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n"
               "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" "
               "format=\"ascii\">{}</DataArray></Points>\n",
               points_, vertices_.count, rectangles_.count, coordinates_) +
           vertices_.xml("Verts") + rectangles_.xml("Polys") + "<CellData Scalars=\"illuminance_lx\">\n" +
           data("Float64", "illuminance_lx", &Data::lux) +
           data("Float64", "standard_error_lx", &Data::error) + data("Int64", "area", &Data::area) +
           data("Float64", "cylindrical_lx", &Data::cylindrical) +
           "</CellData></Piece></PolyData></VTKFile>\n";
  }

 private:
  struct Data {
    std::string lux, error, area, cylindrical;
  };
  void point(const Vec3d& p) {
    coordinates_ += fmt::format("{:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z);
    ++points_;
  }

  std::string coordinates_;
  std::size_t points_ = 0;
  Cells vertices_, rectangles_;
  Data data_[2];  // of vertices, of rectangles: in the order in which VTK counts cells
};

}  // namespace

std::string vtp_of(std::span<const PlaneResult> results) {
  PolyData data;
  for (std::size_t i = 0; i < results.size(); ++i) data.add(results[i], i);
  return data.xml();
}

}  // namespace luxel
