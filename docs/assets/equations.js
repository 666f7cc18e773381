// SPDX-License-Identifier: Apache-2.0
// Draws the equations of a page with KaTeX. Without KaTeX, their TeX source stays.
for (const element of window.katex ? document.querySelectorAll(".arithmatex") : []) {
  const source = element.textContent.trim();  // \( ... \) inline, \[ ... \] displayed
  katex.render(source.slice(2, -2), element, { displayMode: source.startsWith("\\["), throwOnError: false });
}
