// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <utility>

namespace luxel {

// The room's own tools for the HDF5 C library. hdf5.h itself stays in the sources: an id is its hid_t, a
// closer one of its H5?close functions.
using Hdf5Id = std::int64_t;

// An open object of the library, closed when it goes. Below zero where opening failed.
class Hdf5Handle {
 public:
  using Closer = int (*)(Hdf5Id);

  Hdf5Handle() = default;
  Hdf5Handle(Hdf5Id id, Closer closer) : id_(id), closer_(closer) {}
  ~Hdf5Handle() { close(); }
  Hdf5Handle(Hdf5Handle&& other) noexcept { swap(other); }
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
    swap(other);
    return *this;
  }

  bool is_open() const { return id_ >= 0; }
  Hdf5Id id() const { return id_; }
  // Returns false where the library reports a failure.
  bool close() {
    const auto id = std::exchange(id_, -1);
    return id < 0 || closer_(id) >= 0;
  }

 private:
  void swap(Hdf5Handle& other) {
    std::swap(id_, other.id_);
    std::swap(closer_, other.closer_);
  }

  Hdf5Id id_ = -1;
  Closer closer_ = nullptr;
};

// Suppresses the library's own error output in this thread during its lifetime; the destructor restores it.
class Hdf5Silence {
 public:
  Hdf5Silence();
  ~Hdf5Silence();
  Hdf5Silence(const Hdf5Silence&) = delete;
  Hdf5Silence& operator=(const Hdf5Silence&) = delete;

 private:
  int (*print_)(Hdf5Id, void*) = nullptr;
  void* print_data_ = nullptr;
};

// Why the last call of the library failed, in its own words: the innermost entry of its error stack.
std::string hdf5_reason();

}  // namespace luxel
