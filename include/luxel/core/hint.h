// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "luxel/core/error.h"

namespace luxel {

/// \file
/// Settings whose change may resolve an error, as data: the library names settings, a program describes how
/// its users change them (the command luxel names its options).

enum class Setting {
  allow_outside,
  bands,
  contacts,
  eye,
  flip,
  focus,
  force,
  glass,
  layout,
  light_group,
  max_contacts,
  max_edge,
  reflectance_limit,
  memory,
  method,
  min_factor,
  one_sided,
  orient,
  rays,
  scale,
  seed,
  sky,
  spectral,
  target,
  texels_per_metre,
  weld
};

/// A setting to change, and its new value; empty: the user's choice.
struct Hint {
  Setting setting;
  std::string value = {};

  bool operator==(const Hint&) const = default;
};

/// An error with hints can be caught as the original error type; hints_of() returns the hints.
class HintCarrier {
 public:
  explicit HintCarrier(std::vector<Hint> own) : hints(std::move(own)) {}
  virtual ~HintCarrier() = default;
  std::vector<Hint> hints;
};

template <typename E>
struct Hinted : E, HintCarrier {
  Hinted(const E& error, std::vector<Hint> own) : E(error), HintCarrier(std::move(own)) {}
};

template <typename E>
Hinted<E> with_hints(const E& error, std::vector<Hint> hints) {
  return {error, std::move(hints)};
}

/// The hints of an error; empty if it has none.
inline std::vector<Hint> hints_of(const std::exception& error) {
  const auto* carrier = dynamic_cast<const HintCarrier*>(&error);
  return carrier ? carrier->hints : std::vector<Hint>{};
}

/// The same error with the name of the file before its message.
inline Hinted<InputError> with_file(const std::string& file, const InputError& error) {
  return {InputError(file, error.what()), hints_of(error)};
}

}  // namespace luxel
