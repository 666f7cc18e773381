// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/gltf_array.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include <fmt/format.h>

namespace luxel {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers of glTF are little-endian, as ours are");

template <typename T>
T read(const char* place) {
  T value;
  std::memcpy(&value, place, sizeof(T));  // place may be unaligned
  return value;
}

int components_of(const JsonValue& type) {
  const auto name = type.text();
  constexpr auto names = std::to_array<std::string_view>({"SCALAR", "VEC2", "VEC3", "VEC4"});
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) type.refuse(fmt::format("expected SCALAR, VEC2, VEC3 or VEC4, found '{}'", name));
  return 1 + static_cast<int>(found - names.begin());
}

}  // namespace

GltfArray::Type GltfArray::type_of(const JsonValue& component_type) {
  switch (component_type.whole()) {
    case 5120:
      return Type::i8;
    case 5121:
      return Type::u8;
    case 5122:
      return Type::i16;
    case 5123:
      return Type::u16;
    case 5125:
      return Type::u32;
    case 5126:
      return Type::f32;
    default:
      component_type.refuse(
          fmt::format("expected one of the types 5120 to 5126 but 5124, found {}", component_type.whole()));
  }
}

GltfArray::GltfArray(GltfFile& file, const JsonValue& index, int fewest, int most)
    : accessor_(file.object(index, "accessors")),
      type_(type_of(accessor_["componentType"])),
      components_(components_of(accessor_["type"])),
      normalised_(accessor_["normalized"].truth(false)),
      count_(accessor_["count"].whole()) {
  if (components_ < fewest || components_ > most)
    index.refuse(fmt::format("expected an accessor of {} numbers an element, found {}",
                             fewest == most ? fmt::format("{}", most) : fmt::format("{} or {}", fewest, most),
                             components_));
  if (accessor_["bufferView"])
    dense_ = bytes_of(file, accessor_, count_, size_of(type_) * static_cast<std::size_t>(components_));
  else if (count_ > max_zeros)
    accessor_.refuse(fmt::format("it has {} elements and no bufferView; {} zeros are the most that are taken",
                                 count_, max_zeros));
  if (const auto sparse = accessor_["sparse"]) read_sparse(file, sparse);
}

std::size_t GltfArray::size_of(Type type) {
  if (type == Type::i8 || type == Type::u8) return 1;
  return type == Type::i16 || type == Type::u16 ? 2 : 4;
}

// Returns the bytes of `count` elements of this many bytes each, from the owner's bufferView and byteOffset.
GltfArray::Bytes GltfArray::bytes_of(GltfFile& file, const JsonValue& owner, std::size_t count,
                                     std::size_t element) {
  const auto view_index = owner["bufferView"];
  auto bytes = file.view(view_index);
  const auto stride = file.object(view_index, "bufferViews")["byteStride"];
  const auto step = stride.whole(element), offset = owner["byteOffset"].whole(0);
  if (step < element || step > 255)
    stride.refuse(
        fmt::format("expected {} to 252 bytes from one element to the next, found {}", element, step));
  if (count == 0) return {};
  // Division, since the product of such numbers can overflow.
  if (offset > bytes.size() || bytes.size() - offset < element ||
      (bytes.size() - offset - element) / step < count - 1)
    owner.refuse(
        fmt::format("{} elements of {} bytes, {} bytes apart, from byte {} on do not fit into the {} "
                    "bytes of its bufferView",
                    count, element, step, offset, bytes.size()));
  bytes.remove_prefix(offset);
  return {bytes, step};
}

void GltfArray::read_sparse(GltfFile& file, const JsonValue& sparse) {
  replaced_ = sparse["count"].whole();
  const auto indices = sparse["indices"], values = sparse["values"];
  if (!indices["bufferView"] || !values["bufferView"])
    sparse.refuse("expected indices and values, each with a bufferView");
  index_type_ = type_of(indices["componentType"]);
  if (index_type_ != Type::u8 && index_type_ != Type::u16 && index_type_ != Type::u32)
    indices["componentType"].refuse("expected a type without sign: 5121, 5123 or 5125");
  replaced_indices_ = bytes_of(file, indices, replaced_, size_of(index_type_));
  replacements_ = bytes_of(file, values, replaced_, size_of(type_) * static_cast<std::size_t>(components_));
  std::size_t next = 0;
  for (std::size_t i = 0; i < replaced_; ++i) {
    const std::size_t element = whole(replaced_indices_.at(i), index_type_);
    if (element < next || element >= count_)
      indices.refuse(fmt::format("expected indices that ascend and are below {}, found {}", count_, element));
    next = element + 1;
  }
}

std::uint32_t GltfArray::whole(const char* place, Type type) {
  if (type == Type::u8) return read<std::uint8_t>(place);
  return type == Type::u16 ? read<std::uint16_t>(place) : read<std::uint32_t>(place);
}

// Bisects the replaced elements of a sparse accessor.
const char* GltfArray::place_of(std::size_t element) const {
  std::size_t low = 0, high = replaced_;
  while (low < high) {
    const auto middle = low + (high - low) / 2;
    const std::size_t found = whole(replaced_indices_.at(middle), index_type_);
    if (found == element) return replacements_.at(middle);
    if (found < element)
      low = middle + 1;
    else
      high = middle;
  }
  return dense_.all.empty() ? nullptr : dense_.at(element);
}

float GltfArray::component(const char* place, int number) const {
  place += size_of(type_) * static_cast<std::size_t>(number);
  switch (type_) {
    case Type::i8:
      return normalised_ ? std::max(-1.0f, read<std::int8_t>(place) / 127.0f) : read<std::int8_t>(place);
    case Type::u8:
      return normalised_ ? read<std::uint8_t>(place) / 255.0f : read<std::uint8_t>(place);
    case Type::i16:
      return normalised_ ? std::max(-1.0f, read<std::int16_t>(place) / 32767.0f) : read<std::int16_t>(place);
    case Type::u16:
      return normalised_ ? read<std::uint16_t>(place) / 65535.0f : read<std::uint16_t>(place);
    case Type::u32:
      return static_cast<float>(read<std::uint32_t>(place));
    default:
      return read<float>(place);
  }
}

std::array<float, 4> GltfArray::at(std::size_t element) const {
  std::array<float, 4> numbers = {0.0f, 0.0f, 0.0f, 0.0f};
  if (const auto* place = place_of(element))
    for (int i = 0; i < components_; ++i) numbers[static_cast<std::size_t>(i)] = component(place, i);
  return numbers;
}

std::uint32_t GltfArray::index_at(std::size_t element) const {
  const auto* place = place_of(element);
  return place ? whole(place, type_) : 0;
}

}  // namespace luxel
