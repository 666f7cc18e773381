// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include <fmt/format.h>

#include "luxel/photometry/figures.h"
#include "luxel/photometry/photometry.h"

#include "scenes/luminaires/luminaires.h"

namespace luxel::scenes {
namespace {

// Numbers in rows of at most 100 characters.
std::string rows(const double* first, std::size_t count, double scale) {
  std::string text, row;
  for (std::size_t i = 0; i < count; ++i) {
    // Products of values with two decimals have a few more; the rest is rounding.
    const auto word = fmt::format("{}", std::round(1e5 * scale * first[i]) / 1e5);
    if (row.size() + word.size() > 100) {
      text += row + "\n";
      row.clear();
    }
    row += (row.empty() ? "" : " ") + word;
  }
  return text + row + "\n";
}

std::string as_ies(const MadeLuminaire& made) {
  const auto v = made.vertical.size(), h = made.horizontal.size();
  const auto& s = made.size;
  auto text = fmt::format(
      "IESNA:LM-63-2002\n[TEST] computed by luxel-scenes\n[TESTLAB] none\n[ISSUEDATE] none\n[MANUFAC] Luxel\n"
      "[LUMCAT] {}\n[LUMINAIRE] {}\n[LAMP] LED\nTILT=NONE\n",
      made.name, made.about);
  text += fmt::format("1 {:g} 1 {} {} 1 2 {:g} {:g} {:g}\n1 1 {:g}\n", made.absolute ? -1.0 : made.lamp_flux,
                      v, h, made.round ? -s.y : s.y, made.round ? -s.x : s.x, s.z, made.watts);
  text += rows(made.vertical.data(), v, 1.0) + rows(made.horizontal.data(), h, 1.0);
  for (std::size_t i = 0; i < h; ++i) text += rows(&made.per_klm[i * v], v, made.lamp_flux / 1000.0);
  return text;
}

// EULUMDAT has the length along C90-C270: plane C of it is plane C + 90 of the other.
std::string as_ldt(const MadeLuminaire& made) {
  constexpr int mm = 1000;
  const auto rows_of_plane = made.vertical.size();
  const auto last = made.horizontal.back();
  const int symmetry = made.horizontal.size() == 1 ? 1 : last == 90.0 ? 4 : 2;  // quadrant, or 90..270
  const auto step = symmetry == 1 ? 0.0 : made.horizontal[1] - made.horizontal[0];
  const int planes = symmetry == 1 ? 1 : static_cast<int>(std::lround(360.0 / step));
  const IntensityDistribution light(GoniometerType::c, made.vertical, made.horizontal, made.per_klm);
  const auto down = 100.0 * photometric_figures(light).downward_fraction;
  const auto length = mm * made.size.x, width = made.round ? 0.0 : mm * made.size.y,
             height = mm * made.size.z;
  auto text = fmt::format("Luxel\n1\n{}\n{}\n{:g}\n{}\n0\ncomputed by luxel-scenes\n{}\n{}\n{}.ldt\nnone\n",
                          symmetry, planes, step, rows_of_plane, made.about, made.name, made.name);
  text += fmt::format("{0:g}\n{1:g}\n80\n{0:g}\n{1:g}\n{2:g}\n{2:g}\n{2:g}\n{2:g}\n", length, width, height);
  text += fmt::format("{:.1f}\n{:g}\n1\n0\n1\n", down, 100.0 * made.efficiency);
  text +=
      fmt::format("{}\nLED\n{:g}\n4000 K\n80\n{:g}\n", made.absolute ? -1 : 1, made.lamp_flux, made.watts);
  for (int i = 0; i < 10; ++i) text += "0\n";  // direct ratios: not stated
  for (int i = 0; i < planes; ++i) text += fmt::format("{:g}\n", i * step);
  for (const auto v : made.vertical) text += fmt::format("{:g}\n", v);
  const int stored = symmetry == 1 ? 1 : symmetry == 4 ? planes / 4 + 1 : planes / 2 + 1;
  for (int i = 0; i < stored; ++i)
    for (const auto v : made.vertical) text += fmt::format("{}\n", light.at_angles(v, i * step + 90.0));
  return text;
}

}  // namespace

std::string luminaire_file(std::string_view name, std::string_view ending) {
  const auto list = luminaire_list();
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const auto& made) { return made.name == name; });
  if (found == list.end()) throw std::out_of_range("no luminaire is named " + std::string(name));
  if (ending == ".ies") return as_ies(*found);
  if (ending == ".ldt") return as_ldt(*found);
  throw std::out_of_range("no photometric format ends in " + std::string(ending));
}

}  // namespace luxel::scenes
