// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/lighting/calculation_plane.h"
#include "luxel/lighting/plane_svg.h"

namespace luxel {

// Common parts of the drawings of planes. Sizes in pixels of the drawing.
inline constexpr double svg_margin = 24.0, svg_foot = 44.0, svg_text_size = 12.0;
inline constexpr double svg_letter = 0.56;  // width of a digit over the text size

std::string svg_escaped(const std::string& text);
// Three digits, without an exponent.
std::string svg_lux(double lux);
// 1, 2 or 5 times a power of ten, not above the length.
double round_length(double length);

// False colours of a fraction of the range: dark enough for lines and text on white; and pale enough for text
// upon them.
std::string svg_colour(double fraction);
std::string svg_pale_colour(double fraction);

// The opening tag of a picture of this size, with a white ground.
std::string svg_begin(double width, double height);
std::string svg_text(const std::string& text, const Vec2d& at, const char* anchor, const std::string& fill,
                     const char* weight = "normal");

// The height of the title: one line, or two where name and figures do not fit beside each other.
double svg_head(const PlaneResult& result, const PlaneDrawing& drawing);
// The name of the area and its figures.
std::string svg_title(const PlaneResult& result, const PlaneDrawing& drawing);

}  // namespace luxel
