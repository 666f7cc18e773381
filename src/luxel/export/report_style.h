// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace luxel {

// The style sheet of the report: screens, phones, and A4 paper.
inline constexpr const char* report_style = R"(
@page { size: A4; margin: 16mm 15mm 18mm 15mm; @bottom-right { content: counter(page) " / " counter(pages); } }
* { box-sizing: border-box; }
body { font: 15px/1.45 Helvetica, Arial, "Liberation Sans", sans-serif; color: #222; background: #fff;
  max-width: 780px; margin: 0 auto; padding: 16px; }
header { border-bottom: 2px solid #c98a00; margin-bottom: 18px; }
h1 { font-size: 1.7em; line-height: 1.2; margin: 0.3em 0; }
h2 { font-size: 1.25em; margin: 1.6em 0 0.5em; border-bottom: 1px solid #ddd; padding-bottom: 0.15em; }
h3 { font-size: 1.05em; margin: 1.2em 0 0.4em; }
h1, h2, h3, p, li { overflow-wrap: anywhere; }
td { overflow-wrap: break-word; }
p { margin: 0.5em 0; }
table { border-collapse: collapse; width: 100%; font-size: 0.92em; }
th, td { text-align: left; vertical-align: top; padding: 3px 10px 3px 0; border-bottom: 1px solid #e4e4e4; }
th { font-weight: bold; border-bottom: 1px solid #999; vertical-align: bottom; }
td.n, th.n { text-align: right; padding: 3px 0 3px 10px; white-space: nowrap;
  font-variant-numeric: tabular-nums; }
.dense table { font-size: 0.8em; } .dense td, .dense th { padding-top: 1px; padding-bottom: 1px; }
.dense td { white-space: nowrap; }
.narrow table { width: auto; }
.verdicts table { font-size: 0.86em; } .verdicts td:last-child, .verdicts th:last-child { padding-left: 18px; }
.more { display: block; font-size: 0.85em; color: #555; }
.i { white-space: nowrap; }
.scroll { overflow-x: auto; margin: 0.5em 0; }
figure { margin: 0.8em 0; break-inside: avoid; }
figure > svg, figure > img { display: block; width: 100%; height: auto; margin: 0 auto; max-width: 720px; }
figcaption, .note { font-size: 0.85em; color: #555; }
.meta { display: grid; grid-template-columns: max-content 1fr; gap: 0 14px; margin: 0.4em 0 0.8em; }
.meta dt { color: #555; } .meta dd { margin: 0; overflow-wrap: anywhere; }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(150px, 1fr)); gap: 10px; margin: 0.8em 0; }
.figures div { border: 1px solid #ddd; border-left: 4px solid #c98a00; padding: 6px 10px; break-inside: avoid; }
.figures b { display: block; font-size: 1.35em; } .figures span { font-size: 0.82em; color: #555; display: block; }
.verdict { font-weight: bold; } .met { color: #17692b; } .not-met { color: #a81515; } .open { color: #8a5a00; }
.plans { display: grid; grid-template-columns: repeat(auto-fit, minmax(300px, 1fr)); gap: 0 10px; }
.luminaire { display: grid; grid-template-columns: 1fr 230px; gap: 0 20px; break-inside: avoid; }
.luminaire svg { width: 100%; height: auto; }
code { font: 0.88em/1.4 "DejaVu Sans Mono", monospace; overflow-wrap: anywhere; white-space: pre-wrap; }
h2, h3 { break-after: avoid; }
tr { break-inside: avoid; }
thead { display: table-header-group; }
@media (max-width: 560px) {
  body { padding: 10px; font-size: 15px; }
  .luminaire { grid-template-columns: 1fr; } .luminaire svg { max-width: 260px; }
  td.n, th.n { white-space: normal; padding-left: 4px; }
  th, td { padding-right: 4px; }
  table { font-size: 0.86em; }
  .verdicts table { font-size: 0.78em; }
  td.n .i { display: block; font-size: 0.8em; }
  .meta { grid-template-columns: 1fr; } .meta dd { margin-bottom: 4px; }
}
@media print {
  body { font-size: 10pt; max-width: none; margin: 0; padding: 0; }
  .plane { break-inside: avoid; }
  table { font-size: 8.5pt; }
  .scroll { overflow: visible; }
  figure > img { max-height: 92mm; width: auto; max-width: 100%; }
  .whole { break-inside: avoid; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)";

}  // namespace luxel
