// SPDX-License-Identifier: Apache-2.0
import { drawLegend } from './legend.js';
import { Labels } from './labels.js';
import { readLightFile } from './light_file.js';
import { LitScene } from './lit_scene.js';
import { lookFrom, readAddress } from './look.js';
import { isTyping, Navigation } from './navigation.js';
import { Panel } from './panel.js';
import { Probe } from './probe.js';
import { View } from './view.js';

const canvas = document.getElementById('view');

function stop(sentence) {
  const message = document.getElementById('message');
  message.textContent = sentence;
  message.hidden = false;
  document.documentElement.dataset.state = 'failed';
}

// A click is a short press without movement.
function listenToTaps(tapped, tappedTwice) {
  let down = null, last = { time: -1e9 };
  canvas.addEventListener('pointerdown', (e) => {
    down = e.isPrimary && e.button === 0 ? { x: e.clientX, y: e.clientY, time: e.timeStamp } : null;
  });
  canvas.addEventListener('pointerup', (e) => {
    if (!down || !e.isPrimary || Math.hypot(e.clientX - down.x, e.clientY - down.y) > 6 || e.timeStamp - down.time > 500)
      return;
    const isSecond = e.timeStamp - last.time < 350 && Math.hypot(e.clientX - last.x, e.clientY - last.y) < 25;
    last = isSecond ? { time: -1e9 } : { x: e.clientX, y: e.clientY, time: e.timeStamp };
    (isSecond ? tappedTwice : tapped)(e.clientX, e.clientY);
  });
}

function listenToKeys(page, mouse) {
  window.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || isTyping(event) || document.getElementById('help').open) return;
    if (event.code === 'KeyH') page.navigation.home();
    if (event.code === 'KeyP') page.panel.fold();
    if (event.key === '?') page.panel.help();
    if (event.code === 'KeyI') {
      page.look.show = page.look.show === 'light' ? 'illuminance' : 'light';
      page.changed();
    }
    if (event.code === 'KeyC') {
      page.look.solids = !page.look.solids;
      page.changed();
    }
    if (event.code === 'Escape') page.probe.clear();
    if (event.key === '+' || event.key === '-') page.navigation.near(event.key === '+' ? 0.9 : 1.1);
    if (event.code === 'KeyM') {
      page.navigation.setMode(page.navigation.mode === 'orbit' ? 'walk' : 'orbit');
      page.changed();
    }
    if (event.code === 'KeyF') {
      const hit = page.probe.at(mouse.x, mouse.y);
      if (hit) page.navigation.focus(hit.at);
    }
  });
}

function follow(mouse) {
  canvas.addEventListener('pointermove', (e) => Object.assign(mouse, { x: e.clientX, y: e.clientY }));
  return mouse;
}

// Camera, look and lamps as in the address, the rest as in the file.
function obeyAddress(page) {
  const { scene, look, navigation } = page;
  Object.assign(look, lookFrom(scene.about));
  scene.weights.forEach((w) => w.fill(1));
  const said = readAddress(look, scene);
  const here = (point) => point?.map((x, i) => x - scene.about.origin[i]);
  const { eye, target, fov } = scene.about.camera;
  navigation.stand(here(said.eye) ?? eye, here(said.target) ?? target, said.fov ?? fov);
  navigation.setMode(said.mode);
  document.getElementById('panel').hidden = said.bare;
  page.view.resize();
  page.view.refit();
  page.lampsChanged();
}

async function start() {
  if (!document.createElement('canvas').getContext('webgl2'))
    return stop('This page needs WebGL 2, which this browser does not have or has switched off.');
  const scene = new LitScene(await readLightFile());
  const look = lookFrom(scene.about);
  const page = { scene, look };
  page.view = new View(canvas, scene, look, () => {
    page.probe.place();
    page.labels.drawn(look, page.view.scale);
    document.documentElement.dataset.state = 'ready';
    delete document.documentElement.dataset.picture;
  }, () => {
    document.documentElement.dataset.picture = 'smooth';
  });
  page.navigation = new Navigation(canvas, scene, () => page.view.ask());
  page.probe = new Probe(scene, look, page.navigation, page.view.luminaires);
  const lineNumbers = document.getElementById('line-numbers');
  page.labels = new Labels(lineNumbers, (width, height) => page.view.measured(width, height), () => page.panel.boxes());
  page.changed = () => {
    page.panel.show();
    drawLegend(look, page.view.scale);
    page.panel.layOut();
    page.probe.fill();
    page.view.ask();
  };
  page.lampsChanged = () => {
    page.view.lampsChanged();
    page.changed();
  };
  page.view.follow(page.navigation);
  page.panel = new Panel(page);
  page.panel.fold(window.matchMedia('(max-width: 640px), (max-height: 480px)').matches);
  page.view.covered = () => page.panel.covered();
  obeyAddress(page);
  window.addEventListener('hashchange', () => obeyAddress(page));
  listenToTaps((x, y) => page.probe.pin(page.probe.at(x, y)), (x, y) => {
    const hit = page.probe.at(x, y);
    if (hit) page.navigation.approach(hit.at);
  });
  listenToKeys(page, follow({ x: window.innerWidth / 2, y: window.innerHeight / 2 }));
}

start().catch((error) => stop(error.message));
