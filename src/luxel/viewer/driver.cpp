// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <epoxy/gl.h>

#include "luxel/viewer/screen.h"

namespace luxel {

Driver current_driver() {
  const auto text = [](GLenum name) {
    const auto* said = glGetString(name);
    return said == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(said));
  };
  Driver driver{text(GL_RENDERER), text(GL_VERSION), false};
  for (const char* software : {"llvmpipe", "softpipe", "swrast", "SWR", "SwiftShader"})
    driver.is_software |= driver.name.find(software) != std::string::npos;
  return driver;
}

}  // namespace luxel
