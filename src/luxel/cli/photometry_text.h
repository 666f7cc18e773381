// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/photometry/figures.h"
#include "luxel/photometry/photometry.h"

namespace luxel {

// The output of `luxel photometry`.
struct PhotometryText {
  const Photometry* photometry = nullptr;
  PhotometricFigures figures;
  std::string output;  // the diagram, if one was written

  std::string as_text() const;
  std::string as_json() const;
};

}  // namespace luxel
