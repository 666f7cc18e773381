// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/html_text.h"

#include <cstdint>

#include "luxel/core/utf8.h"

namespace luxel {

std::string html_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : valid_utf8(text)) {
    const bool is_control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += is_control ? ' ' : c;
    }
  }
  return escaped;
}

std::string interval_cell(const std::string& text) {
  const auto bracket = text.find(" (");
  if (bracket == std::string::npos) return html_escaped(text);
  return html_escaped(text.substr(0, bracket)) + " <span class=\"i\">" +
         html_escaped(text.substr(bracket + 1)) + "</span>";
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return i + k < bytes.size() ? std::uint32_t{static_cast<unsigned char>(bytes[i + k])} : 0u;
    };
    const auto three = byte(0) << 16 | byte(1) << 8 | byte(2);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : letters[three >> (18 - 6 * k) & 63u];
  }
  return text;
}

std::string HtmlTable::html() const {
  const auto cells = [&](const std::vector<std::string>& row, const char* tag) {
    std::string html = "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c) {
      const bool is_number = is_number_.empty() ? c >= texts_ : is_number_[c];
      const std::string open = is_number ? " class=\"n\"" : "";
      html += std::string("<") + tag + open + ">" + row[c] + "</" + tag + ">";
    }
    return html + "</tr>\n";
  };
  std::string html = "<div class=\"scroll\"><table>\n";
  if (!head_.empty()) html += "<thead>" + cells(head_, "th") + "</thead>\n";
  html += "<tbody>\n";
  for (const auto& row : rows_) html += cells(row, "td");
  return html + "</tbody>\n</table></div>\n";
}

}  // namespace luxel
