// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "luxel/math/vector.h"
#include "luxel/report/log.h"

namespace luxel {

// The mean linear colours of textures, each file read once. Those that cannot be had are remembered, for one
// warning at the end.
class TextureMeans {
 public:
  // The texture as an MTL file in `folder` names it for a material, or nothing where it is missing or cannot
  // be read.
  std::optional<Vec3> mean(const std::filesystem::path& folder, const std::string& texture,
                           const std::string& material);

  // `consequence` ends the sentence: "0.5 is taken for ...".
  void say_warnings(const std::string& source, const std::string& consequence, const LogSink& log) const;

 private:
  struct Trouble {
    std::string texture, material, reason;
  };

  std::map<std::filesystem::path, std::optional<Vec3>> means_;  // of the files seen
  std::set<std::string> missing_;                               // texture names
  std::optional<Trouble> first_missing_, first_unreadable_;
  std::size_t unreadable_ = 0;
};

}  // namespace luxel
