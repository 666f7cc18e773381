# SPDX-License-Identifier: Apache-2.0
"""A small table as a picture, in the look of the charts: for measured numbers, which change from run to run."""
from xml.sax.saxutils import escape

from draw_charts import style

WIDTH, ROW, MARGIN, FIRST = 760, 28, 24, 190


def table(title, heads, rows):
    """The SVG: the first column is names, the others are numbers; all cells are text."""
    height = 84 + ROW * len(rows)
    step = (WIDTH - 2 * MARGIN - FIRST) / (len(heads) - 1)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" width="{WIDTH}" '
           f'height="{height}" role="img">', f"<title>{escape(title)}</title>", f"<style>{style()}</style>",
           f'<rect width="{WIDTH}" height="{height}" rx="6" class="page"/>',
           f'<text x="{MARGIN}" y="30" class="title">{escape(title)}</text>']
    for i, row in enumerate([heads, *rows]):
        y = 62 + ROW * i
        kind = ' class="quiet"' if i == 0 else ""
        out.append(f'<text x="{MARGIN}" y="{y}"{kind}>{escape(row[0])}</text>')
        out += [f'<text x="{MARGIN + FIRST + step * (k + 1):.1f}" y="{y}" text-anchor="end"{kind}>{escape(cell)}</text>'
                for k, cell in enumerate(row[1:])]
        if i < len(rows):
            out.append(f'<line x1="{MARGIN}" y1="{y + 10}" x2="{WIDTH - MARGIN}" y2="{y + 10}" class="grid"/>')
    return "\n".join(out + ["</svg>", ""])
