// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/gltf_writer.h"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "luxel/core/error.h"
#include "luxel/import/drop_unused.h"
#include "luxel/import/glb_container.h"

namespace luxel {
namespace {

constexpr std::size_t alignment = 4;  // of every array
enum Target : int { no_target = 0, vertices = 34962, indices = 34963 };
enum Component : int { u16 = 5123, u32 = 5125, f32 = 5126 };

SortedJson::json_pointer pointer(const std::string& path) { return SortedJson::json_pointer(path); }

std::size_t aligned(std::size_t size) { return (size + alignment - 1) / alignment * alignment; }

template <typename T>
std::string_view bytes_of(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

// Recognises the type by the first bytes, for files that do not declare it.
std::string_view picture_type(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG")) return "image/png";
  if (bytes.starts_with("\xff\xd8")) return "image/jpeg";
  if (bytes.starts_with("RIFF") && bytes.substr(0, 12).ends_with("WEBP")) return "image/webp";
  if (bytes.starts_with("\xabKTX 20\xbb")) return "image/ktx2";
  return {};
}

}  // namespace

struct GltfWriter::Document {
  SortedJson root;
  std::vector<bool> once_used;  // [texture], by the file's materials
  SortedJson& place(const std::string& path);
};

struct GltfWriter::Element {
  int component;
  const char* type;
  bool normalised;
  int target;
};

namespace {

// Checks data that is copied without being read.
void check_unread(GltfFile& file) {
  const auto views = file.root()["bufferViews"];
  for (std::size_t i = 0; i < views.size(); ++i) file.view(i);
  const auto used = file.root()["extensionsUsed"];
  for (std::size_t i = 0; i < used.size(); ++i) used[i].text();
}

// Returns an array to append to. A value of another kind is replaced.
SortedJson& array_at(SortedJson& root, const std::string& path) {
  auto& array = root[pointer(path)];
  if (!array.is_array()) array = SortedJson::array();
  return array;
}

}  // namespace

GltfWriter::GltfWriter() : document_(std::make_unique<Document>()) {
  document_->root = {{"asset", {{"version", "2.0"}}}, {"buffers", SortedJson::array({SortedJson::object()})}};
}

GltfWriter::GltfWriter(GltfFile& file) : document_(std::make_unique<Document>()) {
  check_unread(file);
  document_->root = SortedJson::parse(file.text());
  document_->once_used = used_textures(document_->root);
  take_buffers(file);
  take_pictures(file);
}

GltfWriter::~GltfWriter() = default;

// Merges all buffers into one and updates the offsets of the views, including those of compressed meshes.
void GltfWriter::take_buffers(GltfFile& file) {
  auto& root = document_->root;
  const auto buffers = file.root()["buffers"];
  std::vector<std::size_t> begin;
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    begin.push_back(bytes_.size());
    bytes_ += file.buffer(i);
    bytes_.resize(aligned(bytes_.size()));
  }
  const auto move = [&](SortedJson& view) {
    const auto of = view.find("buffer");
    if (of == view.end() || !of->is_number_unsigned() || of->get<std::size_t>() >= begin.size()) return;
    view["byteOffset"] = view.value("byteOffset", std::size_t{0}) + begin[of->get<std::size_t>()];
    *of = 0;
  };
  if (root.contains("bufferViews"))
    for (auto& view : root["bufferViews"]) {
      move(view);
      if (view.contains("extensions"))
        for (auto& extension : view["extensions"])
          if (extension.is_object()) move(extension);
    }
  root["buffers"] = SortedJson::array({SortedJson::object()});
}

// Pictures that cannot be read, or whose format is not one of glTF's own, stay as references to their files.
void GltfWriter::take_pictures(GltfFile& file) {
  const auto images = file.root()["images"];
  for (std::size_t i = 0; i < images.size(); ++i) {
    const auto uri = images[i]["uri"];
    if (!uri) continue;
    std::string picture;
    try {
      picture = file.resource(uri);
    } catch (const InputError&) {
      continue;  // reported by the program that reads it
    }
    const auto type = picture_type(picture);
    if (type.empty()) continue;
    auto& image = document_->root["images"][i];
    image.erase("uri");
    image["mimeType"] = std::string(type);
    image["bufferView"] = add_view(picture, no_target);
  }
}

bool GltfWriter::has(const std::string& path) const { return document_->root.contains(pointer(path)); }

std::size_t GltfWriter::size(const std::string& path) const {
  return has(path) ? document_->root.at(pointer(path)).size() : 0;
}

std::vector<std::string> GltfWriter::keys(const std::string& path) const {
  std::vector<std::string> found;
  if (has(path))
    for (const auto& member : document_->root.at(pointer(path)).items()) found.push_back(member.key());
  return found;
}

std::size_t GltfWriter::index_at(const std::string& path) const {
  return document_->root.at(pointer(path)).get<std::size_t>();
}

double GltfWriter::number_at(const std::string& path, double otherwise) const {
  return has(path) ? document_->root.at(pointer(path)).get<double>() : otherwise;
}

std::string GltfWriter::text_at(const std::string& path, const std::string& otherwise) const {
  return has(path) ? document_->root.at(pointer(path)).get<std::string>() : otherwise;
}

// Replaces a value that is no object where one is needed, as extras may be of any kind.
SortedJson& GltfWriter::Document::place(const std::string& path) {
  const auto whole = pointer(path);
  if (const auto above = whole.parent_pointer(); root.contains(above))
    if (auto& parent = root.at(above); !parent.is_structured()) parent = SortedJson::object();
  return root[whole];
}

void GltfWriter::put(const std::string& path, const Json& value) {
  document_->place(path) = SortedJson(value);
}

void GltfWriter::put_copy(const std::string& path, const std::string& of) {
  auto copy = document_->root.at(pointer(of));
  document_->place(path) = std::move(copy);
}

void GltfWriter::erase(const std::string& path) {
  if (!has(path)) return;
  const auto place = pointer(path);
  auto& owner = document_->root.at(place.parent_pointer());
  if (owner.is_array())
    owner.erase(std::stoul(place.back()));
  else
    owner.erase(place.back());
}

std::size_t GltfWriter::append(const std::string& array, const Json& value) {
  auto& into = array_at(document_->root, array);
  into.push_back(SortedJson(value));
  return into.size() - 1;
}

std::size_t GltfWriter::append_copy(const std::string& array, const std::string& of) {
  auto copy = document_->root.at(pointer(of));
  auto& into = array_at(document_->root, array);
  into.push_back(std::move(copy));
  return into.size() - 1;
}

void GltfWriter::use_extension(std::string_view name) {
  auto& used = array_at(document_->root, "/extensionsUsed");
  if (std::find(used.begin(), used.end(), name) == used.end()) used.push_back(std::string(name));
}

std::size_t GltfWriter::add_view(std::string_view bytes, int target) {
  auto& views = array_at(document_->root, "/bufferViews");
  SortedJson view = {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}};
  if (target != no_target) view["target"] = target;
  views.push_back(std::move(view));
  bytes_ += bytes;
  bytes_.resize(aligned(bytes_.size()));
  return views.size() - 1;
}

std::size_t GltfWriter::add_array(std::string_view bytes, std::size_t count, const Element& element) {
  SortedJson accessor = {{"bufferView", add_view(bytes, element.target)},
                         {"componentType", element.component},
                         {"type", element.type},
                         {"count", count}};
  if (element.normalised) accessor["normalized"] = true;
  auto& accessors = array_at(document_->root, "/accessors");
  accessors.push_back(std::move(accessor));
  return accessors.size() - 1;
}

std::size_t GltfWriter::add_positions(std::span<const Vec3> values) {
  auto low = values[0], high = values[0];
  for (const auto& p : values) low = glm::min(low, p), high = glm::max(high, p);
  const auto index = add_vectors(values);
  auto& accessor = document_->root["accessors"][index];
  accessor["min"] = {low.x, low.y, low.z};
  accessor["max"] = {high.x, high.y, high.z};
  return index;
}

std::size_t GltfWriter::add_vectors(std::span<const Vec3> values) {
  return add_array(bytes_of(values), values.size(), {f32, "VEC3", false, vertices});
}

std::size_t GltfWriter::add_vectors(std::span<const Vec2> values) {
  return add_array(bytes_of(values), values.size(), {f32, "VEC2", false, vertices});
}

std::size_t GltfWriter::add_floats(std::span<const float> values, int components) {
  constexpr std::array types = {"SCALAR", "VEC2", "VEC3", "VEC4"};
  return add_array(bytes_of(values), values.size() / static_cast<std::size_t>(components),
                   {f32, types.at(static_cast<std::size_t>(components) - 1), false, vertices});
}

std::size_t GltfWriter::add_colours(std::span<const std::array<std::uint16_t, 4>> values) {
  return add_array(bytes_of(values), values.size(), {u16, "VEC4", true, vertices});
}

std::size_t GltfWriter::add_joints(std::span<const std::array<std::uint16_t, 4>> values) {
  return add_array(bytes_of(values), values.size(), {u16, "VEC4", false, vertices});
}

// Indices of all ones are forbidden: programs may take them for the end of a strip.
std::size_t GltfWriter::add_indices(std::span<const std::array<std::uint32_t, 3>> triangles,
                                    std::size_t vertices) {
  const auto count = 3 * triangles.size();
  if (vertices > std::numeric_limits<std::uint16_t>::max())
    return add_array(bytes_of(triangles), count, {u32, "SCALAR", false, indices});
  std::vector<std::uint16_t> narrow;
  for (const auto& triangle : triangles)
    for (const auto index : triangle) narrow.push_back(static_cast<std::uint16_t>(index));
  return add_array(bytes_of(std::span<const std::uint16_t>(narrow)), count, {u16, "SCALAR", false, indices});
}

std::size_t GltfWriter::add_picture(std::string_view bytes, std::string_view type, std::string_view name) {
  auto& images = array_at(document_->root, "/images");
  images.push_back({{"bufferView", add_view(bytes, no_target)},
                    {"mimeType", std::string(type)},
                    {"name", std::string(name)}});
  return images.size() - 1;
}

std::string GltfWriter::bytes(const std::string& source) const {
  auto root = document_->root;
  auto binary = bytes_;
  drop_unused(root, binary, document_->once_used);
  return glb_container(std::move(root), binary, source);
}

}  // namespace luxel
