// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/framebuffer.h"

#include <fmt/format.h>

#include "luxel/core/error.h"

namespace luxel {

void check_complete(ScreenSize size) {
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw DeviceError(
        fmt::format("the graphics driver has no framebuffer of {} x {} pixels", size.width, size.height));
}

void texture_storage(const GlTexture& texture, GLint format, ScreenSize size) {
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glTexImage2D(GL_TEXTURE_2D, 0, format, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void filter_between_texels(const GlTexture& texture) {
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

void attach(GLenum place, const GlTexture& texture) {
  glFramebufferTexture2D(GL_FRAMEBUFFER, place, GL_TEXTURE_2D, texture.name(), 0);
}

void attach_rendered(const GlRenderbuffer* colour, const GlRenderbuffer& depth, int samples,
                     ScreenSize size) {
  const auto one = [&](const GlRenderbuffer& buffer, GLenum format, GLenum place) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, size.width, size.height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer.name());
  };
  if (colour != nullptr) one(*colour, GL_SRGB8_ALPHA8, GL_COLOR_ATTACHMENT0);
  one(depth, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT);
}

}  // namespace luxel
