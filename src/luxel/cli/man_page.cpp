// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/man_page.h"

#include <cctype>
#include <cstdint>
#include <string_view>

#include <fmt/format.h>

#include "luxel/cli/help_text.h"
#include "luxel/cli/wrapped_text.h"
#include "luxel/runs/quality.h"

namespace luxel {
namespace {

// The code point at a place of a valid text in UTF-8; moves the place behind it.
std::uint32_t next_code_point(std::string_view text, std::size_t& at) {
  const auto first = static_cast<unsigned char>(text[at++]);
  if (first < 0x80) return first;
  std::uint32_t code = first >= 0xf0 ? first & 0x07u : first >= 0xe0 ? first & 0x0fu : first & 0x1fu;
  while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80)
    code = code << 6 | (static_cast<unsigned char>(text[at++]) & 0x3fu);
  return code;
}

// Escapes text for troff: characters that it would read as commands or print differently are named. A line
// may break behind '|'.
std::string roff(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const auto code = next_code_point(text, at);
    switch (code) {
      case '\\':
        result += "\\e";
        break;
      case '-':
        result += "\\-";
        break;
      case '\'':
        result += "\\(aq";
        break;
      case '`':
        result += "\\(ga";
        break;
      case '^':
        result += "\\(ha";
        break;
      case '~':
        result += "\\(ti";
        break;
      case '"':
        result += "\\(dq";
        break;
      case '|':
        result += "|\\:";
        break;
      default:
        if (code < 0x80)
          result += static_cast<char>(code);
        else
          result += fmt::format("\\[u{:04X}]", code);
    }
  }
  return result;
}

// A line of text; one that begins with '.' would be a command.
std::string line(std::string_view text) { return (text.starts_with('.') ? "\\&" : "") + roff(text) + "\n"; }

std::string bold(std::string_view text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + roff(text) + "\\fR"; }

std::string section(std::string_view title) { return fmt::format(".SH {}\n", title); }
std::string item(const std::string& tag, std::string_view text) { return ".TP\n" + tag + "\n" + line(text); }

std::string page_name(const std::string& command) { return "luxel-" + command; }

std::string head(const std::string& name, const std::string& summary, const ManFooter& footer) {
  auto title = name;
  for (auto& c : title) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return fmt::format(".TH {} 1 {} \"luxel {}\" \"User Commands\"\n", roff(title), footer.date,
                     roff(footer.version)) +
         section("NAME") + fmt::format("{} \\- {}\n", roff(name), roff(summary));
}

std::string option_tag(char letter, const std::string& name, const std::string& unit) {
  auto tag = letter ? bold(fmt::format("-{}", letter)) + ", " : std::string();
  tag += bold("--" + name);
  return unit.empty() ? tag : tag + " " + italic(unit);
}

std::string option_item(const OptionSet::Entry& entry) {
  const auto& d = entry.declaration;
  auto text = sentence(d.help);
  if (!d.is_flag && !entry.default_value.empty()) text += fmt::format(" Default: {}.", entry.default_value);
  return item(option_tag(d.letter, d.name, d.is_flag ? "" : d.unit), text);
}

std::string options(const OptionSet& command) {
  auto text = section("OPTIONS");
  for (const auto& heading : command.headings()) {
    if (!heading.empty()) text += fmt::format(".SS {}\n", roff(heading));
    for (const auto& e : command.entries())
      if (e.heading == heading) text += option_item(e);
  }
  text += ".SS Help and configuration\n";
  for (const auto& o : common_options) text += item(option_tag(o.letter, o.name, o.unit), sentence(o.help));
  return text;
}

// A table of text as it stands.
std::string table(const std::string& title, std::string_view rows) {
  if (rows.empty()) return {};
  auto text = section(title) + ".EX\n";
  for (std::size_t begin = 0; begin < rows.size();) {
    const auto end = rows.find('\n', begin);
    text += line(rows.substr(begin, end - begin));
    begin = end == rows.npos ? rows.size() : end + 1;
  }
  return text + ".EE\n";
}

std::string examples(const OptionSet& command) {
  if (command.examples().empty()) return {};
  auto text = section("EXAMPLES");
  for (const auto& example : command.examples()) text += item(bold(example.line), example.meaning);
  return text;
}

std::string exit_status() {
  auto text = section("EXIT STATUS");
  for (const auto& exit : exit_codes)
    text += item(bold(fmt::format("{}", exit.code)), sentence(exit.meaning));
  return text;
}

std::string reference_to(const std::string& page) { return bold(page) + "(1)"; }

std::string synopsis(const OptionSet& command) {
  auto text = bold("luxel " + command.name());
  for (const auto& positional : command.positionals()) {
    const auto name = italic(positional.name + (positional.values ? "..." : ""));
    text += command.needs_positionals() ? " " + name : " [" + name + "]";
  }
  return section("SYNOPSIS") + text + " [" + italic("options") + "]\n";
}

}  // namespace

std::string man_page(const OptionSet& command, const ManFooter& footer) {
  auto text = head(page_name(command.name()), command.summary(), footer) + synopsis(command);
  if (!command.positionals().empty()) text += section("ARGUMENTS");
  for (const auto& positional : command.positionals())
    text += item(italic(positional.name), sentence(positional.help));
  text += options(command) + table("WHAT \\-\\-QUALITY SETS", quality_table(command));
  return text + examples(command) + exit_status() + section("SEE ALSO") + reference_to("luxel") + "\n";
}

std::string man_page(std::span<const std::unique_ptr<OptionSet>> commands, const ManFooter& footer) {
  auto text = head("luxel", program_summary, footer);
  text += section("SYNOPSIS") + bold("luxel") + " " + italic("COMMAND") + " [" + italic("options") + "]\n";
  text += section("DESCRIPTION");
  text +=
      line("Luxel computes the light on every surface of a scene, for any viewpoint, with standard errors.");
  text += line("The light is baked into a mesh, rendered as a picture, or reported as numbers.");
  text += section("COMMANDS");
  for (const auto& command : commands)
    text += item(reference_to(page_name(command->name())), sentence(command->summary()));
  return text + exit_status() + section("SEE ALSO") + reference_to(page_name(commands.front()->name())) +
         "\n";
}

}  // namespace luxel
