// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/view_factor_report.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "luxel/cli/run_report.h"
#include "luxel/core/process_usage.h"

namespace luxel {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t max_shown = 12;  // elements

std::string describe(const FactorCheck& check, const ViewFactors& factors) {
  if (!check.is_whole) return fmt::format("stopped after {} rows had been checked", check.rows);
  auto text = fmt::format("row sums: 1 to within {:.1g}", check.worst_row_sum);
  if (check.worst_row_sum > 1e-9) text += fmt::format(" ('{}')", factors.name[check.worst_row]);
  text += fmt::format("; {:.4g} % goes to the environment", 100.0 * check.environment);
  if (check.backs > 0.0) text += fmt::format(", {:.4g} % to backs", 100.0 * check.backs);
  if (check.dropped > 0.0) text += fmt::format(", {:.4g} % was dropped", 100.0 * check.dropped);
  text += fmt::format("\nreciprocity: off by {:.2g} (root mean square; {:.2g} at most", check.reciprocity,
                      check.worst_reciprocity);
  if (check.worst_reciprocity > 1e-12)
    text +=
        fmt::format(", '{}' and '{}'", factors.name[check.worst_pair[0]], factors.name[check.worst_pair[1]]);
  text += ')';
  if (check.expected_reciprocity > 0.0 && check.reciprocity > 1e-12)
    text += fmt::format(", standard errors let expect {:.2g}", check.expected_reciprocity);
  return text + fmt::format("\nbounds: listed factors from {:.3g} to {:.6g}", check.smallest, check.largest);
}

std::string matrix(const ViewFactors& f) {
  std::size_t widest = 11;  // (environment), plus the extra width of the second column
  for (const auto& name : f.name) widest = std::max(widest, name.size());
  std::string text;
  for (std::size_t i = 0; i < f.size(); ++i) {
    for (auto at = f.row_begin[i]; at < f.row_begin[i + 1]; ++at)
      text += fmt::format("\n  {:<{}} -> {:<{}}  {:.6f} ± {:.6f}", f.name[i], widest, f.name[f.column[at]],
                          widest + 2, f.factor[at], f.standard_error[at]);
    for (std::size_t k = 0; k < ViewFactors::sinks; ++k)
      if (f.sink[k].factor[i] > 0.0)
        text += fmt::format("\n  {:<{}} -> {:<{}}  {:.6f} ± {:.6f}", f.name[i], widest,
                            fmt::format("({})", ViewFactors::sink_name[k]), widest + 2, f.sink[k].factor[i],
                            f.sink[k].standard_error[i]);
  }
  return text;
}

Json to_json(const FactorCheck& c) {
  return {{"factors", c.count},
          {"rows", c.rows},
          {"is_whole", c.is_whole},
          {"worst_row_sum", c.worst_row_sum},
          {"smallest", c.smallest},
          {"largest", c.largest},
          {"reciprocity", c.reciprocity},
          {"expected_reciprocity", c.expected_reciprocity},
          {"worst_reciprocity", c.worst_reciprocity},
          {"environment", c.environment},
          {"backs", c.backs},
          {"dropped", c.dropped}};
}

}  // namespace

std::string ViewFactorReport::as_text() const {
  const auto& f = *factors;
  auto text = fmt::format("{} factors {} between {} {}", check.count, sampled ? "counted" : "found", f.size(),
                          between);
  if (sampled) {
    text += fmt::format("; {} rays, {} a patch side; standard error {:.3g}", sampled->rays,
                        sampled->rays_per_side, sampled->error);
    if (error_target > 0.0) text += fmt::format(" (requested {:g})", error_target);
    if (sampled->row_error > 0.0) text += fmt::format(", {:.2g} % of a row", 100.0 * sampled->row_error);
    if (row_error_target > 0.0) text += fmt::format(" (requested {:g} %)", 100.0 * row_error_target);
  }
  if (exact) text += fmt::format("; {} pairs of patches in closed form", exact->pairs);
  text += '\n';
  text += describe(check, f);
  if (enforcement) {
    const auto& e = *enforcement;
    text += fmt::format(
        "\nenforced: factors changed by {:.2g} (root mean square; {:.2g} at most), exchange areas by {:.2g} "
        "standard errors; rows were off by {:.2g}",
        e.rms_change, e.max_change, e.change_in_standard_errors, e.worst_row_sum_before);
    text += fmt::format("\n{} factors after it: every pair is listed both ways\n", e.count);
    if (check_after) text += describe(*check_after, f);
  }
  if (f.size() <= max_shown) text += matrix(f);
  return text;
}

std::string ViewFactorReport::as_json() const {
  Json json = {{"command", "viewfactors"}, {"between", between},          {"sides", sides},
               {"patches", patches},       {"elements", factors->size()}, {"factors", factors->count()}};
  if (sampled)
    json["sampled"] = {{"rays", sampled->rays},
                       {"rays_per_side", sampled->rays_per_side},
                       {"error", sampled->error},
                       {"error_target", error_target},
                       {"stop_reason", name(sampled->stop)},
                       {"row_error", sampled->row_error},
                       {"row_error_target", row_error_target},
                       {"predicted_factors", sampled->predicted_factors},
                       {"predicted_bytes", sampled->predicted_bytes},
                       {"predicted_memory_bytes", predicted_memory}};
  if (exact) json["exact"] = {{"pairs", exact->pairs}, {"predicted_seconds", exact->predicted_seconds}};
  json["check"] = to_json(check);
  if (enforcement) {
    json["enforced"] = {{"rms_change", enforcement->rms_change},
                        {"largest_change", enforcement->max_change},
                        {"change_in_standard_errors", enforcement->change_in_standard_errors},
                        {"worst_row_sum_before", enforcement->worst_row_sum_before},
                        {"steps", enforcement->steps},
                        {"passes", enforcement->passes},
                        {"is_stopped", enforcement->is_stopped},
                        {"factors", enforcement->count}};
    if (check_after) json["check_after"] = to_json(*check_after);
  }
  json["outputs"] = outputs;
  Json stages = Json::array();
  for (const auto& s : record->stages())
    stages.push_back({{"name", s.name}, {"seconds", s.seconds}, {"rays", s.rays}});
  json["stages"] = stages;
  json["peak_memory_bytes"] = peak_memory();
  Json values = Json::object();
  for (const auto& [name, value] : options->values()) values[name] = value;
  json["options"] = values;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace luxel
