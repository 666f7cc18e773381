// SPDX-License-Identifier: Apache-2.0
// The panel: settings go into the look and the weights of the lamps, and are shown as these have them.
import { addressOf } from './look.js';
import { numberText } from './tone.js';

const element = (id) => document.getElementById(id);
const stops = (v) => `${v >= 0 ? '+' : '−'}${Math.abs(v).toFixed(2)} stops`;
const small = matchMedia('(max-width: 640px)'); // as in style.css
const help = {
  mouse: {
    orbit: 'Drag to turn, wheel to come closer. Click a surface to measure its light.',
    walk: 'Drag to look around; W A S D to walk.',
  },
  touch: {
    orbit: 'Drag to turn, pinch to come closer. Tap a surface to measure its light.',
    walk: 'Drag to look around, push the pad to walk.',
  },
};

export class Panel {
  // page: { scene, look, view, navigation, probe, changed() }
  constructor(page) {
    this.page = page;
    this.lamps = page.scene.about.groups.map((name, g) => this.#addLamp(name || nameOfAll(page.scene), g));
    element('unit-choice').hidden = page.scene.isSpectral;
    element('solids-row').hidden = page.scene.about.luminaires.places.length === 0;
    this.#listenToLook();
    this.#listenToCamera();
    element('made').textContent = madeText(page.scene);
    this.show();
  }

  // Everything as the look has it.
  show() {
    const { look, scene, navigation } = this.page;
    check('show', look.show);
    check('unit', look.unit);
    check('mode', navigation.mode);
    element('tone').value = look.op;
    element('exposure').value = look.exposure;
    element('exposure-text').textContent = stops(look.exposure);
    element('white').value = look.white;
    element('white-text').textContent = look.white > 0 ? numberText(look.white) : 'none';
    element('white-row').hidden = look.op !== 'reinhard';
    for (const name of ['adapt', 'automatic', 'logarithmic', 'isolines']) element(name).checked = look[name];
    element('see-through').checked = look.seeThrough;
    element('solids').checked = look.solids;
    element('ends').hidden = look.automatic;
    for (const name of ['low', 'high']) {
      if (document.activeElement !== element(name)) element(name).value = Number(look[name].toPrecision(4));
    }
    element('light-controls').hidden = look.show !== 'light';
    element('scale-controls').hidden = look.show === 'light';
    element('mode-help').textContent = help[isTouch() ? 'touch' : 'mouse'][navigation.mode];
    element('pad').hidden = navigation.mode !== 'walk' || !isTouch();
    this.lamps.forEach((show) => show());
    element('lamps-reset').disabled = scene.isAsSolved;
  }

  // On a small screen the picture ends where the folded panel and the legend begin.
  layOut() {
    const { panel, legend } = Object.fromEntries(['panel', 'legend'].map((id) => [id, element(id)]));
    const header = panel.hidden ? 0 : panel.offsetHeight - element('sheet').offsetHeight;
    const height = small.matches ? header + legend.offsetHeight : 0;
    if (height === this.dock) return;
    this.dock = height;
    document.documentElement.style.setProperty('--dock', `${height}px`);
    this.page.view.resize();
  }

  // Rectangles of the window that elements cover.
  boxes() {
    return ['panel', 'legend', 'card'].map((id) => element(id)).filter((e) => !e.hidden).map((e) => e.getBoundingClientRect());
  }

  fold(folded = !element('panel').classList.contains('folded')) {
    element('panel').classList.toggle('folded', folded);
    element('fold').setAttribute('aria-expanded', String(!folded));
    this.page.view.resize();
  }

  help() {
    element('help').showModal();
  }

  // How far the middle of what the open panel leaves free is from the picture's: to the left, upwards.
  covered() {
    const panel = element('panel');
    if (panel.hidden || panel.classList.contains('folded')) return [0, 0];
    return small.matches ? [0, element('sheet').offsetHeight / 2] : [panel.offsetWidth / 2, 0];
  }

  #listenToLook() {
    const { look, view, changed } = this.page;
    const set = (name, value, also = () => {}) => {
      look[name] = value;
      also();
      changed();
    };
    const scaleChanged = () => view.lampsChanged();
    radios('show', (value) => set('show', value));
    radios('unit', (value) => set('unit', value, scaleChanged));
    element('exposure').addEventListener('input', (e) => set('exposure', Number(e.target.value)));
    element('white').addEventListener('input', (e) => set('white', Number(e.target.value)));
    element('tone').addEventListener('change', (e) => set('op', e.target.value));
    element('adapt').addEventListener('change', (e) => set('adapt', e.target.checked));
    element('isolines').addEventListener('change', (e) => set('isolines', e.target.checked));
    element('see-through').addEventListener('change', (e) => set('seeThrough', e.target.checked, scaleChanged));
    element('solids').addEventListener('change', (e) => set('solids', e.target.checked));
    element('automatic').addEventListener('change', (e) => set('automatic', e.target.checked, scaleChanged));
    element('logarithmic').addEventListener('change', (e) => set('logarithmic', e.target.checked, () => this.#takeScale()));
    for (const name of ['low', 'high']) element(name).addEventListener('input', () => this.#takeScale());
    element('fold').addEventListener('click', () => this.fold());
    element('help-open').addEventListener('click', () => this.help());
    element('help-close').addEventListener('click', () => element('help').close());
    element('help').addEventListener('click', ({ target }) => target === element('help') && target.close()); // outside
    small.addEventListener('change', () => this.layOut());
  }

  // A manual scale: its ends must be in order, and above 0 where it is logarithmic.
  #takeScale() {
    const { look, view, changed } = this.page;
    if (!look.automatic) {
      const low = element('low').valueAsNumber, high = element('high').valueAsNumber;
      const fault = !(high > low) ? '“To” must be more than “from”.'
        : look.logarithmic && !(low > 0) ? 'A logarithmic scale begins above 0.' : '';
      element('scale-fault').textContent = fault;
      element('scale-fault').hidden = fault === '';
      if (fault !== '') return;
      Object.assign(look, { low, high });
    }
    view.lampsChanged();
    changed();
  }

  #listenToCamera() {
    const { look, scene, navigation, changed } = this.page;
    radios('mode', (mode) => {
      navigation.setMode(mode);
      changed();
    });
    element('home').addEventListener('click', () => navigation.home());
    element('lamps-reset').addEventListener('click', () => {
      scene.weights.forEach((w) => w.fill(1));
      this.page.lampsChanged();
    });
    element('link').addEventListener('click', async ({ target }) => {
      const address = addressOf(look, scene, navigation);
      history.replaceState(null, '', address);
      const isCopied = await navigator.clipboard?.writeText(address).then(() => true, () => false);
      target.textContent = isCopied ? 'Copied' : 'In the address bar';
      setTimeout(() => (target.textContent = 'Copy link'), 2000);
    });
    this.#listenToPad();
  }

  #listenToPad() {
    const pad = element('pad'), knob = element('pad-knob');
    const { navigation, view } = this.page;
    const push = (x, y) => {
      navigation.push = [x, y];
      knob.style.transform = `translate(${34 * x}px, ${-34 * y}px)`;
      view.ask();
    };
    const follow = (event) => {
      const box = pad.getBoundingClientRect();
      const x = (2 * (event.clientX - box.left)) / box.width - 1, y = 1 - (2 * (event.clientY - box.top)) / box.height;
      const length = Math.max(1, Math.hypot(x, y));
      push(x / length, y / length);
    };
    pad.addEventListener('pointerdown', (event) => {
      pad.setPointerCapture(event.pointerId);
      follow(event);
    });
    pad.addEventListener('pointermove', (event) => pad.hasPointerCapture(event.pointerId) && follow(event));
    for (const end of ['pointerup', 'pointercancel']) pad.addEventListener(end, () => push(0, 0));
  }

  // A slider, and a colour where light has one; returns what shows the weight.
  #addLamp(name, g) {
    const { scene } = this.page;
    const row = document.createElement('div');
    row.className = 'lamp';
    const label = document.createElement('span'), text = document.createElement('output');
    const colour = document.createElement('input'), slider = document.createElement('input');
    label.textContent = name;
    label.title = name;
    Object.assign(colour, { type: 'color', value: '#ffffff', hidden: scene.isSpectral });
    colour.setAttribute('aria-label', `Colour of ${name}`);
    Object.assign(slider, { type: 'range', min: 0, max: 3, step: 0.01 });
    slider.setAttribute('aria-label', `Brightness of ${name}`);
    row.append(label, text, colour, slider);
    element('lamp-list').append(row);
    const take = () => {
      const tint = scene.isSpectral ? [1, 1, 1] : linearOf(colour.value);
      scene.setLamp(g, tint, Number(slider.value));
      this.page.lampsChanged();
    };
    colour.addEventListener('input', take);
    slider.addEventListener('input', take);
    return () => {
      const factor = scene.factor(g), largest = Math.max(...scene.weights[g]);
      if (document.activeElement !== slider) slider.value = factor;
      if (largest > 0) colour.value = codeOf(scene.weights[g].map((w) => w / largest));
      text.textContent = `${Math.round(100 * factor)} %`;
    };
  }
}

const percent = (share) => `${numberText(100 * Number(share.toPrecision(2)))}\u00a0%`; // never on a line of its own
const isTouch = () => matchMedia('(pointer: coarse)').matches;

function check(name, value) {
  for (const radio of document.getElementsByName(name)) radio.checked = radio.value === value;
}

function radios(name, chosen) {
  for (const radio of document.getElementsByName(name)) radio.addEventListener('change', () => chosen(radio.value));
}

const linearOf = (code) => [1, 3, 5].map((at) => {
  const c = parseInt(code.slice(at, at + 2), 16) / 255;
  return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
});
const codeOf = (linear) => '#' + linear.map((c) => {
  const code = c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055;
  return Math.round(255 * code).toString(16).padStart(2, '0');
}).join('');

// The light that is not divided among lamps.
function nameOfAll({ about }) {
  const hasLamps = about.materials.some(({ emittance }) => emittance.some((e) => e > 0));
  return !about.hasSky ? 'All lamps' : hasLamps ? 'All light' : 'Daylight';
}

function madeText({ about, triangleCount }) {
  const { luxel, error, seenError } = about.made;
  const parts = [`Made with Luxel ${luxel}`];
  if (seenError > 0) parts.push(`errors below ${percent(seenError)} in 95 of 100 views`);
  else if (error > 0) parts.push(`mean error ${percent(error)}`);
  parts.push(`${triangleCount.toLocaleString('en')} triangles`);
  return parts.join(' · ');
}
