// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/uri.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace luxel {
namespace {

constexpr std::string_view data_scheme = "data:", base64_mark = ";base64";

// The six bits of a character, or nothing. URLs may write - and _ for + and /.
std::optional<std::uint32_t> six_bits(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+' || c == '-') return 62;
  if (c == '/' || c == '_') return 63;
  return std::nullopt;
}

std::optional<std::string> from_base64(std::string_view text) {
  while (text.ends_with('=')) text.remove_suffix(1);
  if (text.size() % 4 == 1) return std::nullopt;
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t pending = 0;
  int bits = 0;
  for (const auto c : text) {
    const auto six = six_bits(c);
    if (!six) return std::nullopt;
    pending = pending << 6 | *six;
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes.push_back(static_cast<char>(pending >> bits & 0xFF));
  }
  return bytes;
}

std::optional<std::string> without_percents(std::string_view text) {
  std::string plain;
  while (!text.empty()) {
    const auto percent = text.find('%');
    plain += text.substr(0, percent);
    if (percent == std::string_view::npos) break;
    const auto digits = text.substr(percent + 1, 2);
    unsigned code = 0;
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    if (error != std::errc() || digits.size() != 2 || stop != digits.data() + 2 || code == 0)
      return std::nullopt;
    plain.push_back(static_cast<char>(code));
    text.remove_prefix(percent + 3);
  }
  return plain;
}

}  // namespace

bool is_data_uri(std::string_view uri) { return uri.starts_with(data_scheme); }

std::optional<std::string> data_of_uri(std::string_view uri) {
  const auto comma = uri.find(',');
  if (!is_data_uri(uri) || comma == std::string_view::npos) return std::nullopt;
  if (!uri.substr(0, comma).ends_with(base64_mark)) return std::nullopt;
  return from_base64(uri.substr(comma + 1));
}

std::optional<std::filesystem::path> file_of_uri(std::string_view uri) {
  auto plain = without_percents(uri.substr(0, uri.find_first_of("?#")));
  if (!plain || plain->empty() || plain->find('\0') != std::string::npos) return std::nullopt;
  // A colon before the first slash ends a scheme or a drive letter.
  const auto colon = uri.find(':');
  if (colon != std::string_view::npos && colon < uri.find('/')) return std::nullopt;
  std::replace(plain->begin(), plain->end(), '\\', '/');  // not valid in a URI, but some programs write it
  return std::filesystem::path(*plain);
}

}  // namespace luxel
