// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "luxel/core/json.h"
#include "luxel/import/packed_column.h"

namespace luxel {

// Arrays for a glTF file that is written. Those of one kind share a bufferView, since each view costs some
// 100 bytes of JSON and compresses better the longer it is.
class ArrayStore {
 public:
  // Each adds an accessor to the file and returns its number. The file's JSON must outlive the store.
  explicit ArrayStore(SortedJson& root) : root_(root) {}
  std::size_t add(std::string_view name, const PackedColumn& column);
  // is_list: three indices per triangle; otherwise strips, fans, lines or points.
  std::size_t add_indices(const std::vector<std::uint32_t>& indices, std::size_t vertices, bool is_list);

  // Appends the arrays to the file's one buffer, and their views behind its own. Returns the number of views.
  std::size_t append_views(std::string& binary);
  // Compresses the last views of the file, those of append_views(), by EXT_meshopt_compression. Nothing may
  // lie behind them in the buffer.
  void compress_views(std::string& binary) const;

 private:
  using Key = std::tuple<int, std::size_t, std::string>;  // type, bytes per element, what it is
  struct Stream {
    std::string bytes;
    std::string mode, filter = "NONE";  // see MeshoptView
    std::vector<std::size_t> accessors;
  };
  std::size_t append(Stream& stream, SortedJson accessor, std::string_view bytes);

  SortedJson& root_;
  std::map<Key, Stream> streams_;
};

}  // namespace luxel
