// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/viewer/gl_object.h"
#include "luxel/viewer/screen.h"

namespace luxel {

// Internal to this module: helpers for framebuffers.

// Throws DeviceError where the bound framebuffer cannot be drawn into.
void check_complete(ScreenSize size);
// Allocates a texture, which is read texel by texel.
void texture_storage(const GlTexture& texture, GLint format, ScreenSize size);
// Enables linear interpolation between texels.
void filter_between_texels(const GlTexture& texture);
void attach(GLenum place, const GlTexture& texture);
// Attaches colour (null: none) and depth to the bound framebuffer. samples: per pixel; 0: no multisampling.
void attach_rendered(const GlRenderbuffer* colour, const GlRenderbuffer& depth, int samples, ScreenSize size);

}  // namespace luxel
