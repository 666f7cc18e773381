// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/viewer/gl_object.h"
#include "luxel/viewer/screen.h"

namespace luxel {

// The room's own: what framebuffers are made of.

// Throws DeviceError where the one that is bound cannot be drawn into.
void check_complete(ScreenSize size);
// Room for such a picture, which is read texel by texel.
void texture_storage(const GlTexture& texture, GLint format, ScreenSize size);
// From now on it is read between its texels too.
void filter_between_texels(const GlTexture& texture);
void attach(GLenum place, const GlTexture& texture);
// Colour (none where it is null) and depth of the framebuffer that is bound. samples: 0, or so many a pixel.
void attach_rendered(const GlRenderbuffer* colour, const GlRenderbuffer& depth, int samples, ScreenSize size);

}  // namespace luxel
