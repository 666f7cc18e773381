// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace luxel {

/// \file
/// The four ways the world can be wrong. Each message is one sentence: what was expected, what was found,
/// what to try. The library throws; only a program prints, and only a program exits.

struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file or option a person wrote is wrong. what() begins with "FILE:LINE: " or "FILE: " where they are
/// known.
struct InputError : Error {
  explicit InputError(const std::string& message) : Error(message) {}
  InputError(const std::string& file, const std::string& message) : Error(file + ": " + message) {}
  InputError(const std::string& file, std::size_t line, const std::string& message)
      : Error(file + ":" + std::to_string(line) + ": " + message) {}
};

/// A file of ours is damaged, is not what its name says, or was written by a newer version.
struct FormatError : Error {
  FormatError(const std::string& file, const std::string& message) : Error(file + ": " + message) {}
};

/// Two things that must belong together do not: this solution is not of this scene.
struct MismatchError : Error {
  using Error::Error;
};

/// A disk, a device or the operating system failed us.
struct DeviceError : Error {
  using Error::Error;
};

}  // namespace luxel
