// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/page_parts.h"

#include <fmt/format.h>

#include "luxel/export/html_text.h"
#include "luxel/export/report_style.h"

namespace luxel {

std::string page_begin(const std::string& title, const std::string& version,
                       const std::vector<std::pair<std::string, std::string>>& rows) {
  std::string html = "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n";
  html +=
      "<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" content=\"width=device-width, "
      "initial-scale=1\"/>\n"
      // No script runs in a report and nothing is fetched, whatever text a name contains.
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
      "img-src data:; base-uri 'none'; form-action 'none'\"/>\n";
  html += fmt::format("<meta name=\"generator\" content=\"Luxel {}\"/>\n", html_escaped(version));
  html += "<title>" + html_escaped(title) + "</title>\n<style>";
  html += report_style;
  html += "</style>\n</head>\n<body>\n<header>\n<h1>" + html_escaped(title) + "</h1>\n<dl class=\"meta\">\n";
  for (const auto& [name, value] : rows)
    if (!value.empty()) html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", name, html_escaped(value));
  return html + "</dl>\n</header>\n";
}

std::string page_heading(const std::string& text) { return "<h2>" + text + "</h2>\n"; }

std::string page_figure(const std::string& content, const std::string& caption) {
  return fmt::format("<figure>\n{}<figcaption>{}</figcaption>\n</figure>\n", content, caption);
}

std::string page_box(const std::string& name, const std::string& value, const std::string& note) {
  return fmt::format("<div><span>{}</span><b>{}</b><span>{}</span></div>\n", name, value, note);
}

std::string compliance_span(Compliance compliance) {
  const auto* kind = compliance == Compliance::met       ? "met"
                     : compliance == Compliance::not_met ? "not-met"
                                                         : "open";
  return fmt::format("<span class=\"verdict {}\">{}</span>", kind, name(compliance));
}

std::string room_tables(const RoomData& room) {
  const auto size = room.high - room.low;
  HtmlTable data({}, 2);
  data.add({"Size", fmt::format("{:.2f} × {:.2f} m, height {:.2f} m", size.x, size.y, size.z)});
  data.add({"Floor area", fmt::format("{:.2f} m²", room.floor_area)});
  HtmlTable materials({"Material", "Area, m²", "Reflectance"}, 1);
  for (const auto& m : room.materials)
    materials.add({html_escaped(m.name) + (m.emits ? " (emits light)" : ""), fmt::format("{:.2f}", m.area),
                   fmt::format("{:.0f} %", 100.0 * m.reflectance)});
  return data.html() + materials.html();
}

}  // namespace luxel
