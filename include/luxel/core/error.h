// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace luxel {

/// \file
/// The four kinds of errors. Each message is one sentence: the expected value, the value found, and a remedy.
/// The library throws; only programs print and exit.

struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
  Error(const std::string& message, std::string of_file, std::size_t of_line = 0)
      : std::runtime_error(message), file(std::move(of_file)), line(of_line) {}

  std::string file;      // where the cause is; empty: in no file, or unknown
  std::size_t line = 0;  // from 1; 0: unknown
};

/// A file or option that the user provides is invalid. what() begins with "FILE:LINE: " or "FILE: " where
/// they are known.
struct InputError : Error {
  explicit InputError(const std::string& message) : Error(message) {}
  InputError(const std::string& of_file, const std::string& message)
      : Error(of_file + ": " + message, of_file) {}
  InputError(const std::string& of_file, std::size_t of_line, const std::string& message)
      : Error(of_file + ":" + std::to_string(of_line) + ": " + message, of_file, of_line) {}
};

/// A file that Luxel wrote is damaged, has another type than its name, or is of a newer version.
struct FormatError : Error {
  FormatError(const std::string& of_file, const std::string& message)
      : Error(of_file + ": " + message, of_file) {}
};

/// Two inputs that must belong together do not, for example a solution and a scene.
struct MismatchError : Error {
  using Error::Error;
};

/// A disk, a device or the operating system failed.
struct DeviceError : Error {
  using Error::Error;
};

/// A file cannot be written, for a reason that follows "cannot write FILE: ".
inline DeviceError cannot_write(const std::string& file, const std::string& reason) {
  return {"cannot write " + file + ": " + reason, file};
}

}  // namespace luxel
