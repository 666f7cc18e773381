// SPDX-License-Identifier: Apache-2.0
// Numbers on the lines of equal light: placed once the picture rests, on lines that are long enough to carry one.
import { levelsOf, numberText } from './tone.js';

const cell = 4; // CSS pixels of the coarse picture in which lines are found
const apart = 84; // CSS pixels between two numbers
const again = 260; // CSS pixels between two numbers of one line
const shortest = 12; // cells of a line that has a number
const maxNumbers = 40;
const restTime = 160; // ms

export class Labels {
  // measured(width, height): the light in view, rows from the bottom; covered(): rectangles of the window that have no
  // numbers; drawn in a canvas above the picture.
  constructor(canvas, measured, covered) {
    Object.assign(this, { canvas, measured, covered });
  }

  // After each picture: numbers vanish while it moves.
  drawn(look, scale) {
    clearTimeout(this.timer);
    const isShown = look.show === 'illuminance' && look.isolines;
    this.canvas.classList.remove('rests');
    if (isShown) this.timer = setTimeout(() => this.#place(look, scale), restTime);
  }

  #place(look, scale) {
    const { canvas } = this;
    const width = canvas.clientWidth, height = canvas.clientHeight;
    if (width === 0 || height === 0) return;
    const columns = Math.ceil(width / cell), rows = Math.ceil(height / cell);
    const light = this.measured(columns, rows);
    const taken = this.covered();
    const numbers = [];
    // Higher levels first: their lines are shorter.
    for (const level of levelsOf(scale, look.logarithmic).reverse())
      for (const line of linesAt(light, columns, rows, level, gapOf(scale, level, look.logarithmic)))
        placeOn(line, level, { width, height, rows, taken, numbers });
    draw(canvas, width, height, numbers);
    canvas.classList.add('rests');
  }
}

// A jump that is larger is an edge of a surface, not a line of equal light.
const gapOf = ({ low, high }, level, logarithmic) => (logarithmic ? level : (high - low) / 12);

// Connected cells through which the level passes: [[[column, row], ...], ...].
function linesAt(light, columns, rows, level, gap) {
  const crossed = new Uint8Array(columns * rows);
  for (let y = 0; y + 1 < rows; ++y)
    for (let x = 0; x + 1 < columns; ++x) {
      const here = light[y * columns + x];
      for (const there of [light[y * columns + x + 1], light[(y + 1) * columns + x]])
        if ((here < level) !== (there < level) && Math.abs(there - here) < gap) crossed[y * columns + x] = 1;
    }
  const lines = [];
  for (let start = 0; start < crossed.length; ++start) {
    if (!crossed[start]) continue;
    crossed[start] = 0;
    const line = [], open = [start];
    while (open.length > 0) {
      const at = open.pop(), x = at % columns, y = Math.floor(at / columns);
      line.push([x, y]);
      for (let dy = -1; dy <= 1; ++dy)
        for (let dx = -1; dx <= 1; ++dx) {
          const next = at + dy * columns + dx;
          if (x + dx < 0 || x + dx >= columns || next < 0 || next >= crossed.length || !crossed[next]) continue;
          crossed[next] = 0;
          open.push(next);
        }
    }
    if (line.length >= shortest) lines.push(line);
  }
  return lines.sort((a, b) => b.length - a.length);
}

// The middle of a line first, then its other cells.
function placeOn(line, level, { width, height, rows, taken, numbers }) {
  const mean = [0, 1].map((i) => line.reduce((sum, at) => sum + at[i], 0) / line.length);
  const distance = ([x, y]) => Math.hypot(x - mean[0], y - mean[1]);
  for (const [column, row] of [...line].sort((a, b) => distance(a) - distance(b))) {
    if (numbers.length >= maxNumbers) return;
    const x = (column + 1) * cell, y = (rows - row - 1) * cell;
    if (x < 24 || x > width - 24 || y < 14 || y > height - 14) continue;
    if (taken.some((box) => x > box.left - 24 && x < box.right + 24 && y > box.top - 14 && y < box.bottom + 14)) continue;
    const isNear = (other) => Math.hypot(other.x - x, other.y - y) < (other.line === line ? again : apart);
    if (!numbers.some(isNear)) numbers.push({ x, y, line, text: numberText(level) });
  }
}

function draw(canvas, width, height, numbers) {
  const ratio = Math.min(window.devicePixelRatio, 2);
  canvas.width = width * ratio;
  canvas.height = height * ratio;
  const pen = canvas.getContext('2d');
  pen.scale(ratio, ratio);
  pen.font = `600 12.5px ${getComputedStyle(document.body).fontFamily}`;
  pen.textAlign = 'center';
  pen.textBaseline = 'middle';
  pen.lineJoin = 'round';
  pen.lineWidth = 4;
  pen.strokeStyle = '#000000d0';
  pen.fillStyle = '#ffffff';
  for (const { x, y, text } of numbers) {
    pen.strokeText(text, x, y);
    pen.fillText(text, x, y);
  }
  canvas.dataset.numbers = String(numbers.length);
}
