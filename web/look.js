// SPDX-License-Identifier: Apache-2.0
// What one has chosen to see, and its place in the address, so that a link shows the same.

export function lookFrom(about) {
  return {
    show: 'light', ...about.tone, adapt: false,
    unit: 'lux', automatic: true, low: 0, high: 1, logarithmic: false, isolines: true,
    seeThrough: true, solids: false,
  };
}

const words = { show: ['light', 'illuminance'], op: ['neutral', 'reinhard', 'clamp', 'maximum'], unit: ['lux', 'watts'] };
const numbers = ['exposure', 'white', 'low', 'high'];
const switches = ['adapt', 'automatic', 'logarithmic', 'isolines', 'seeThrough', 'solids'];
const three = (text) => {
  const values = text?.split(',').map(Number);
  return values?.length === 3 && values.every(Number.isFinite) ? values : null;
};
const short = (v) => String(Number(v.toPrecision(6)));

// Fills look and lamp weights from the address; returns what it says of the camera and the panel.
export function readAddress(look, scene) {
  const said = new URLSearchParams(location.hash.slice(1));
  for (const [name, among] of Object.entries(words)) if (among.includes(said.get(name))) look[name] = said.get(name);
  for (const name of numbers)
    if (said.has(name) && Number.isFinite(Number(said.get(name)))) look[name] = Number(said.get(name));
  for (const name of switches) if (said.has(name)) look[name] = said.get(name) === 'on';
  said.get('lamps')?.split(';').forEach((text, g) => {
    const weight = three(text);
    if (weight && scene.weights[g]) scene.weights[g] = weight.map((w) => Math.max(0, w));
  });
  const fov = Number(said.get('fov'));
  return {
    eye: three(said.get('eye')), target: three(said.get('target')), fov: fov > 0 && fov < 180 ? fov : null,
    mode: said.get('mode') === 'walk' ? 'walk' : 'orbit', bare: said.get('panel') === 'off',
  };
}

export function addressOf(look, scene, navigation) {
  const said = new URLSearchParams();
  const start = lookFrom(scene.about);
  for (const name of Object.keys(words)) if (look[name] !== start[name]) said.set(name, look[name]);
  for (const name of numbers) if (look[name] !== start[name]) said.set(name, short(look[name]));
  for (const name of switches) if (look[name] !== start[name]) said.set(name, look[name] ? 'on' : 'off');
  if (!scene.isAsSolved) said.set('lamps', scene.weights.map((w) => w.map(short).join(',')).join(';'));
  const { camera, orbit, mode, fov } = navigation;
  const ahead = mode === 'orbit' ? orbit.target : camera.getWorldDirection(camera.position.clone()).multiplyScalar(scene.radius).add(camera.position);
  const inFile = (v) => v.toArray().map((x, i) => short(x + scene.about.origin[i])).join(',');
  said.set('eye', inFile(camera.position));
  said.set('target', inFile(ahead));
  said.set('fov', short(fov));
  if (mode !== 'orbit') said.set('mode', mode);
  const url = new URL(location.href);
  url.hash = decodeURIComponent(said.toString());
  return url.href;
}
