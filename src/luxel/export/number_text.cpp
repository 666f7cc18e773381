// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/number_text.h"

#include <cmath>

#include <fmt/format.h>

namespace luxel {
namespace {

using Text = std::string (*)(double, int);

// One more decimal place where the ends of the interval would read alike.
int decimals_more(const Figure& number, Text text) {
  return text(number.low, 0) == text(number.high, 0) ? 1 : 0;
}

std::string with_interval(const Figure& number, Text text) {
  const auto interval = interval_text(number, text);
  return interval.empty() ? text(number.value, 0)
                          : text(number.value, decimals_more(number, text)) + " (" + interval + ")";
}

Text text_for(const Verdict& verdict) {
  return verdict.quantity.starts_with("E") ? Text(lux_text)
         : verdict.quantity == "UGR"       ? Text(ugr_text)
                                           : Text(ratio_text);
}

// Empty for numbers that are not illuminances.
std::string unit_of(const Verdict& verdict) { return verdict.quantity.starts_with("E") ? " lx" : ""; }

}  // namespace

std::string lux_text(double lux, int more) {
  return fmt::format("{:.{}f}", lux, (lux >= 99.95 ? 0 : lux >= 9.995 ? 1 : 2) + more);
}
std::string ratio_text(double ratio, int more) { return fmt::format("{:.{}f}", ratio, 2 + more); }
std::string ugr_text(double ugr, int more) {
  return std::isfinite(ugr) ? fmt::format("{:.{}f}", ugr, 1 + more) : "–";
}

std::string interval_text(const Figure& number, std::string (*text)(double, int)) {
  if (!(number.low < number.high) || !std::isfinite(number.value)) return "";
  const auto more = decimals_more(number, text);
  return text(number.low, more) + " to " + text(number.high, more);
}

std::string lux_text(const Figure& number) { return with_interval(number, lux_text); }
std::string ratio_text(const Figure& number) { return with_interval(number, ratio_text); }
std::string ugr_text(const Figure& number) { return with_interval(number, ugr_text); }

std::string requirement_text(const Verdict& verdict) {
  return fmt::format("{} {} {:.4g}{}", verdict.quantity == "max_over_min" ? "Emax : Emin" : verdict.quantity,
                     verdict.is_at_least ? "≥" : "≤", verdict.required, unit_of(verdict));
}

std::string measured_text(const Verdict& verdict) {
  if (verdict.compliance == Compliance::not_known) return "–";
  if (verdict.quantity == "Ra") return fmt::format("{:g}", verdict.measured.value);
  return text_for(verdict)(verdict.measured.value, 0) + unit_of(verdict);
}

std::string interval_text(const Verdict& verdict) {
  if (verdict.compliance == Compliance::not_known) return "";
  if (verdict.quantity == "Ra")
    return verdict.measured.low < verdict.measured.high
               ? fmt::format("{:g} to {:g}", verdict.measured.low, verdict.measured.high)
               : "";
  const auto interval = interval_text(verdict.measured, text_for(verdict));
  return interval.empty() ? interval : interval + unit_of(verdict);
}

std::string beginning_of(const Verdict& verdict) {
  const auto text = verdict.compliance == Compliance::not_known || verdict.quantity == "Ra"
                        ? measured_text(verdict)
                        : with_interval(verdict.measured, text_for(verdict)) + unit_of(verdict);
  return fmt::format("{} {}, {} {:g}{}: ", verdict.quantity, text,
                     verdict.is_at_least ? "at least" : "at most", verdict.required, unit_of(verdict));
}

}  // namespace luxel
