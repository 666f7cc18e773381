// SPDX-License-Identifier: Apache-2.0
#pragma once

/// \file
/// The version of Luxel, by semantic versioning: before 1.0 a minor version may change the interface. CMake
/// holds these lines to the version of the project.

#define LUXEL_VERSION_MAJOR 0
#define LUXEL_VERSION_MINOR 1
#define LUXEL_VERSION_PATCH 0

#define LUXEL_VERSION_TEXT_OF(number) #number
#define LUXEL_VERSION_TEXT(major, minor, patch) \
  LUXEL_VERSION_TEXT_OF(major) "." LUXEL_VERSION_TEXT_OF(minor) "." LUXEL_VERSION_TEXT_OF(patch)
/// As text: "0.1.0".
#define LUXEL_VERSION LUXEL_VERSION_TEXT(LUXEL_VERSION_MAJOR, LUXEL_VERSION_MINOR, LUXEL_VERSION_PATCH)
