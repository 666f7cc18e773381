// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/failure_log.h"

#include <new>
#include <utility>

#include <fmt/format.h>

namespace luxel {

bool FailureLog::attempt(const std::filesystem::path& file, const std::function<void()>& work) {
  try {
    work();
    return true;
  } catch (const std::bad_alloc&) {
    return record(fmt::format("{}: there is not enough memory", file.string()));
  } catch (const std::exception& thrown) {
    return record(thrown.what());
  }
}

FailureLog::Last FailureLog::last() const {
  const std::lock_guard lock(mutex_);
  return last_;
}

bool FailureLog::record(std::string message) {
  const std::lock_guard lock(mutex_);
  last_ = {std::move(message), last_.count + 1};
  return false;
}

}  // namespace luxel
