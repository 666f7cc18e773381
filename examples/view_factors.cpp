// SPDX-License-Identifier: Apache-2.0
// View factors between the named surfaces of a scene, by form factors in closed form, and a comparison with
// the textbook: scenes/plates.obj has two parallel squares of 1 m at a distance of 10 mm, whose view factor
// is known.
//
//     view_factors scenes/plates.obj
#include <cmath>
#include <cstdio>
#include <numbers>

#include <luxel/form_factors/exact_view_factors.h>
#include <luxel/luxel.h>

// Between equal parallel rectangles that face each other, x and y: sides over distance (Howell, "A Catalog of
// Radiation Heat Transfer Configuration Factors", C-11).
static double parallel_rectangles(double x, double y) {
  const auto a = 1.0 + x * x, b = 1.0 + y * y;
  return 2.0 / (std::numbers::pi * x * y) *
         (std::log(std::sqrt(a * b / (a + y * y))) + x * std::sqrt(b) * std::atan(x / std::sqrt(b)) +
          y * std::sqrt(a) * std::atan(y / std::sqrt(a)) - x * std::atan(x) - y * std::atan(y));
}

int main(int count, char** arguments) try {
  if (count != 2) throw luxel::InputError("view_factors: expected one scene, OBJ or glTF");
  const luxel::Context context;
  const auto scene = luxel::load_scene(arguments[1]);
  // Elements are whole groups of the file; patches only need to be as fine as the scene has them.
  const auto patches = luxel::make_patches(scene, {.max_edge = luxel::no_max_edge}, context);
  const luxel::Tracer tracer(patches, context);
  const auto elements =
      luxel::make_view_elements(scene, patches, luxel::Between::groups, luxel::ElementSides::front);

  luxel::ExactFactorsReport report;
  const auto factors = luxel::exact_view_factors(patches, tracer, elements, {}, report, context);
  for (std::size_t i = 0; i < factors->size(); ++i)  // row by row: sparse, columns rising
    for (auto k = factors->row_begin[i]; k < factors->row_begin[i + 1]; ++k)
      std::printf("%s -> %s: %.6f\n", factors->name[i].c_str(), factors->name[factors->column[k]].c_str(),
                  factors->factor[k]);
  std::printf("squares of 1 m at a distance of 10 mm, in closed form: %.6f\n",
              parallel_rectangles(100.0, 100.0));
} catch (const luxel::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
