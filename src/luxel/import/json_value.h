// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace luxel {

// A value in a JSON text, which may be missing, and its path, which every error names: "room.gltf:
// /nodes/3/mesh: expected ...". Copies refer to the same text. Accessors return the caller's default where
// the value is missing; a value that is present must be of the requested kind. Cheap: a path and a pointer.
class JsonValue {
 public:
  // Parses a text; source is for errors. Throws InputError naming the line where it is no JSON.
  static JsonValue parse(std::string_view text, std::string source);

  explicit operator bool() const { return node_ != nullptr; }
  const std::string& path() const { return path_; }
  const std::string& source() const;

  bool is_object() const;
  bool is_text() const;
  bool is_truth() const;

  // Returns a member of an object; a missing value if there is none, or if this value itself is missing.
  JsonValue operator[](std::string_view key) const;
  // An element of an array, below size().
  JsonValue operator[](std::size_t index) const;
  // The number of elements of an array; 0 where this is not there.
  std::size_t size() const;
  std::vector<std::string> keys() const;  // of an object, in the order of the alphabet

  double number(double otherwise) const;  // finite
  double number() const;                  // which must be there
  std::size_t whole(std::size_t otherwise) const;
  std::size_t whole() const;
  bool truth(bool otherwise) const;
  std::string text(const std::string& otherwise) const;
  std::string text() const;
  // as many as `otherwise` has, each finite
  std::vector<double> numbers(const std::vector<double>& otherwise) const;

  // Throws InputError: "source: path: message".
  [[noreturn]] void refuse(const std::string& message) const;

 private:
  struct Document;
  JsonValue(std::shared_ptr<const Document> document, const void* node, std::string path);
  JsonValue at(const void* node, std::string path) const;
  [[noreturn]] void refuse_kind(std::string_view expected) const;
  void expect_there(std::string_view expected) const;

  std::shared_ptr<const Document> document_;
  const void* node_ = nullptr;  // in the document
  std::string path_;
};

}  // namespace luxel
