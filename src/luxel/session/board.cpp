// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/board.h"

#include <new>
#include <utility>

#include <fmt/format.h>

namespace luxel {

bool Board::attempt(const std::filesystem::path& file, const std::function<void()>& work) {
  const auto fail = [&](std::string sentence) {
    const std::lock_guard lock(mutex);
    status.error_message = std::move(sentence);
    ++status.errors;
    return false;
  };
  try {
    work();
    return true;
  } catch (const std::bad_alloc&) {
    return fail(fmt::format("{}: there is not enough memory", file.string()));
  } catch (const std::exception& thrown) {
    return fail(thrown.what());
  }
}

}  // namespace luxel
