// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/compression_setting.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace luxel {

void declare_compression(OptionSet& set, MeshCompression& compression, const std::string& file) {
  set.add({"compress", fmt::format("{}", fmt::join(mesh_compression_names(), "|")),
           fmt::format(
               "how the arrays of {} are stored: none: as floats; quantize: as integers of 8 and 16 bits, "
               "where that is not visible; meshopt: these, compressed",
               file),
           [&compression](const std::string& text) {
             const auto found = mesh_compression(text);
             if (!found)
               throw UsageError(fmt::format("--compress: expected one of {}, not '{}'",
                                            fmt::join(mesh_compression_names(), ", "), text));
             compression = *found;
           },
           [&compression] { return std::string(name(compression)); }});
}

void check_compression(MeshCompression compression, TargetApplication program) {
  if (!is_available(compression))
    throw UsageError(
        fmt::format("--compress {}: this luxel was built without meshoptimizer; install libmeshoptimizer-dev "
                    "and build again, or use --compress {}",
                    name(compression), name(MeshCompression::quantised)));
  if (compression == MeshCompression::meshopt && !profile_of(program).reads_meshopt)
    throw UsageError(fmt::format("--compress {}: {} does not read EXT_meshopt_compression; use --compress {}",
                                 name(compression), name(program), name(MeshCompression::quantised)));
}

}  // namespace luxel
