// SPDX-License-Identifier: Apache-2.0
#include "luxel/solution/places_file.h"

namespace luxel {

void add_places(Hdf5Writer& file, const std::string& name, std::span<const Vec3> places,
                const Vec3d& origin) {
  if (origin == Vec3d(0.0)) return file.add_array(name, vectors(places), "m");
  std::vector<double> in_file;
  in_file.reserve(3 * places.size());
  for (const auto& place : places)
    for (int axis = 0; axis < 3; ++axis) in_file.push_back(origin[axis] + static_cast<double>(place[axis]));
  file.add_array(name, table(std::span<const double>(in_file), places.size(), 3), "m");
}

void add_origin(Hdf5Writer& file, const std::string& name, const Vec3d& origin) {
  if (origin != Vec3d(0.0)) file.add_array(name, flat_array(std::span<const double>(&origin.x, 3)), "m");
}

std::vector<Vec3> read_places(const Hdf5Reader& file, const std::string& name, std::size_t rows,
                              const Vec3d& origin) {
  if (origin == Vec3d(0.0)) return file.vectors(name, rows);
  const auto in_file = file.array<double>(name, rows, 3);
  std::vector<Vec3> places(rows);
  for (std::size_t i = 0; i < rows; ++i)
    places[i] = Vec3(Vec3d(in_file[3 * i], in_file[3 * i + 1], in_file[3 * i + 2]) - origin);
  return places;
}

Vec3d read_origin(const Hdf5Reader& file, const std::string& name) {
  if (!file.has(name)) return Vec3d(0.0);
  const auto origin = file.array<double>(name, 3);
  return {origin[0], origin[1], origin[2]};
}

}  // namespace luxel
