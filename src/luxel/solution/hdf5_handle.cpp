// SPDX-License-Identifier: Apache-2.0
#include "luxel/solution/hdf5_handle.h"

#include <type_traits>

#include <hdf5.h>

namespace luxel {
namespace {

static_assert(std::is_same_v<hid_t, Hdf5Id>);
static_assert(std::is_same_v<herr_t, int>);

herr_t keep_first(unsigned position, const H5E_error2_t* entry, void* result) {
  if (position == 0 && entry->desc) *static_cast<std::string*>(result) = entry->desc;
  return 0;
}

}  // namespace

Hdf5Silence::Hdf5Silence() {
  // HDF5 1.10.8 leaks some memory on a damaged header, and therefore prints that it "loops" at the program's
  // end. Luxel closes everything that it opens, so no clean-up is left then. The call fails, rightly, where
  // another part of the program started the library before.
  H5dont_atexit();
  H5Eget_auto2(H5E_DEFAULT, &print_, &print_data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Silence::~Hdf5Silence() { H5Eset_auto2(H5E_DEFAULT, print_, print_data_); }

std::string hdf5_reason() {
  std::string reason = "the HDF5 library gives no reason";
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &reason);
  return reason;
}

}  // namespace luxel
