// What pages have in common that show a recording: what was packed into them, what is told, the worker
// that decodes, the picture, and the keys. A page itself defines take(answer), for the worker's answers.
'use strict';

const element = id => document.getElementById(id);
const prefers_calm = matchMedia('(prefers-reduced-motion: reduce)');

// ---- What was packed into the page

function unpacked_base64(id) {
  const packed = atob(element(id).textContent.trim());
  const bytes = new Uint8Array(packed.length);
  for (let i = 0; i < packed.length; ++i) bytes[i] = packed.charCodeAt(i);
  return bytes;
}

// As seven_bits.h has it.
function unpacked_seven_bits(id) {
  const text = element(id).textContent;
  const bytes = new Uint8Array(Math.floor(text.length * 7 / 8));
  let [waiting, count, done] = [0, 0, 0];
  for (let i = 0; i < text.length; ++i) {
    waiting = (waiting << 7 | text.charCodeAt(i) & 127) & 0xffff;
    count += 7;
    if (count < 8) continue;
    count -= 8;
    bytes[done++] = waiting >> count;
  }
  return bytes;
}

async function unpacked_gzip(id) {
  const stream = new Blob([unpacked_seven_bits(id)]).stream();
  return new Response(stream.pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
}

async function unpacked_json(id) {
  return JSON.parse(new TextDecoder().decode(await unpacked_gzip(id)));
}

// ---- What is told

const status_line = element('status');

function tell(sentence) {
  status_line.textContent = sentence;
  status_line.className = '';
}

function tell_problem(sentence) {
  status_line.textContent = sentence;
  status_line.className = 'problem';
}

const percent = value => (100 * value).toFixed(1) + ' %';
// Springs may settle any multiple of the way that hands command.
const progress_percent = value =>
    Math.abs(value) > 10 ? (value > 0 ? 'over 1000 %' : 'below -1000 %') : percent(value);
const known = (value, written) => (Number.isNaN(value) ? '–' : written(value));

// What stands beside the picture, by the id of its place.
function numbers_told(index) {
  const n = column => timeline.number(column, index);
  const stage_name = recording.stages[n('stage') - 1];
  return {
    frame: `${index + 1} of ${recording.frames}`,
    time: timeline.time_s(index).toFixed(2) + ' s',
    strain: known(n('strain'), percent),
    penetrations: known(n('penetrations'), String),
    progress: known(n('progress'), progress_percent),
    pull: known(n('pull'), percent),
    contact: known(n('contact'), percent),
    stage_name: stage_name ?? '–',
  };
}

function tell_numbers(index) {
  for (const [id, value] of Object.entries(numbers_told(index))) element(id).textContent = value;
  stage.setAttribute('aria-label', `${recording.name}, frame ${index + 1}. ` + stage_help);
}

// ---- The worker

let recording = null;  // the one that is shown
let worker = null;     // null while it is being made
let view = null;

// What the worker is asked for: one frame at a time, the last one wanted. Until it has opened a
// recording it is not asked.
const wanted = {frame: null, is_asked: true, buffer: null};

function want(index) {
  wanted.frame = index;
  ask();
}

function ask() {
  if (wanted.is_asked || wanted.frame === null) return;
  wanted.is_asked = true;
  const buffer = wanted.buffer;
  send({show: wanted.frame, of: recording.opening, buffer}, buffer ? [buffer] : []);
  wanted.buffer = null;
  wanted.frame = null;
}

// What is sent to a worker that is being made reaches it once it is there; one that is ended before does
// not come to be.
const unsent = [];
let ended_workers = 0;

function send(message, transferred = []) {
  if (worker) worker.postMessage(message, transferred);
  else unsent.push([message, transferred]);
}

async function start_worker() {
  const ended_before = ended_workers;
  const scripts = [...document.querySelectorAll('script.of_worker')].map(one => one.textContent);
  const script = [await unpacked_gzip('glue'), ...scripts];
  const address = URL.createObjectURL(new Blob(script, {type: 'text/javascript'}));
  const wasm = await unpacked_gzip('wasm');
  if (ended_workers > ended_before) return;
  const own = worker = new Worker(address);
  worker.onmessage = ({data}) => worker === own && take(data);
  worker.onerror = event => worker === own && take({broken: event.message});
  worker.postMessage({wasm}, [wasm]);
  for (const one of unsent.splice(0)) worker.postMessage(...one);
}

// With what it was asked for and has not answered.
function end_worker() {
  worker?.terminate();
  worker = null;
  ++ended_workers;
  unsent.length = 0;
  wanted.is_asked = true;
}

function take_frame({shown, lost, particles, sentence}) {
  wanted.is_asked = false;
  if (lost !== undefined) tell_problem(sentence);
  else {
    say_ready();
    wanted.buffer = (view ? view.show(particles) : particles)?.buffer ?? null;
    tell_numbers(shown);
  }
  ask();
}

// The worker has opened it; what was shown before is left.
function show_recording(opened) {
  recording = opened;
  if (view) view.open(recording);
  paint_legend(recording);
  show_strain();
  wanted.frame = null;
  timeline.open(recording);
}

// ---- The picture

const stage = element('stage');
const stage_help = 'Drag to turn, wheel or two fingers to zoom, right button to move; arrow keys turn, ' +
    'with Shift they move, plus and minus zoom, 0 goes back.';

function most_strain() {
  const worst = recording.numbers.reduce(
      (most, value, i) => (i % columns.length === 1 && value > most ? value : most), 0);
  return Math.max(1e-6, recording.strain_limit || worst);
}

function show_strain() {
  const is_shown = element('by_strain').checked;
  element('legend').hidden = !is_shown;
  if (!recording) return;
  element('legend_most').textContent = percent(most_strain());
  if (!view) return;
  view.most_strain = is_shown ? most_strain() : 0;
  view.draw_soon();
}

function paint_legend({strain_colors}) {
  const stops = [0, 64, 128, 192, 255].map(i => `rgb(${strain_colors.slice(4 * i, 4 * i + 3).join()})`);
  element('legend_colors').style.background = `linear-gradient(to right, ${stops.join()})`;
}

function turn(right, up) {
  view.camera.orbit(right, up);
  view.draw_soon();
}

function move(right, up) {
  view.camera.pan(right, up);
  view.draw_soon();
}

function zoom(factor) {
  view.camera.zoom(factor);
  view.draw_soon();
}

// Fingers and buttons that are down, by their ids.
const pointers = new Map();

function spread(points) {
  return Math.max(1, Math.hypot(points[0].x - points[1].x, points[0].y - points[1].y));
}

function drag(event) {
  const pointer = pointers.get(event.pointerId);
  if (!pointer || !view) return;
  const before = [...pointers.values()].map(({x, y}) => ({x, y}));
  const height = stage.clientHeight;
  const [right, down] = [event.clientX - pointer.x, event.clientY - pointer.y];
  Object.assign(pointer, {x: event.clientX, y: event.clientY});
  if (pointers.size > 1) {
    zoom(spread([...pointers.values()]) / spread(before));
    move(right / height / pointers.size, -down / height / pointers.size);
  } else if (pointer.moves) {
    move(right / height, -down / height);
  } else {
    turn(4 * right / height, 4 * down / height);
  }
}

stage.addEventListener('pointerdown', event => {
  stage.setPointerCapture(event.pointerId);
  pointers.set(event.pointerId,
               {x: event.clientX, y: event.clientY, moves: event.button !== 0 || event.shiftKey});
});
stage.addEventListener('pointermove', drag);
for (const end of ['pointerup', 'pointercancel'])
  stage.addEventListener(end, event => pointers.delete(event.pointerId));
// Or Chromium takes fingers that are lifted in motion for a fling, and the tap that follows for its end.
stage.addEventListener('touchmove', event => event.preventDefault(), {passive: false});
stage.addEventListener('contextmenu', event => event.preventDefault());
stage.addEventListener('wheel', event => {
  event.preventDefault();
  const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
  if (view) zoom(Math.exp(-0.0015 * lines * event.deltaY));
}, {passive: false});
stage.addEventListener('dblclick', () => view && view.show_all());

// ---- Keys

const stage_keys = {
  ArrowLeft: shift => (shift ? move(-0.05, 0) : turn(-0.1, 0)),
  ArrowRight: shift => (shift ? move(0.05, 0) : turn(0.1, 0)),
  ArrowUp: shift => (shift ? move(0, 0.05) : turn(0, 0.1)),
  ArrowDown: shift => (shift ? move(0, -0.05) : turn(0, -0.1)),
  '+': () => zoom(1.2),
  '=': () => zoom(1.2),
  '-': () => zoom(1 / 1.2),
  '0': () => view.show_all(),
};

const page_keys = {
  ' ': () => timeline.toggle(),
  ArrowLeft: () => timeline.go_to(timeline.index - 1),
  ArrowRight: () => timeline.go_to(timeline.index + 1),
  Home: () => timeline.go_to(0),
  End: () => timeline.go_to(timeline.frames - 1),
};

// Controls keep the keys that they know themselves.
function is_used_by(control, key) {
  if (control.matches('select')) return true;
  if (control.matches('input[type=range]')) return key !== ' ';
  return control.matches('button, input, a') && key === ' ';
}

addEventListener('keydown', event => {
  const is_hidden = stage.offsetParent === null;
  if (event.ctrlKey || event.altKey || event.metaKey || !recording || is_hidden) return;
  const at_stage = document.activeElement === stage && view && stage_keys[event.key];
  if (!at_stage && is_used_by(document.activeElement, event.key)) return;
  const deed = at_stage || page_keys[event.key];
  if (!deed) return;
  event.preventDefault();
  deed(event.shiftKey);
});

element('by_strain').addEventListener('change', show_strain);
element('again').addEventListener('click', () => view && view.show_all());


// ---- The beginning

// From now on it can be used.
function say_ready() {
  if (document.body.dataset.ready !== undefined) return;
  document.body.dataset.ready = '';
  performance.mark('ready');
}

const timeline = new Timeline(
    {
      slider: element('slider'),
      strip: element('strip'),
      first: element('first'),
      back: element('back'),
      play: element('play'),
      forward: element('forward'),
      last: element('last'),
      speed: element('speed'),
    },
    want);

function start_view() {
  try {
    view = new View(stage);
    stage.setAttribute('tabindex', '0');
  } catch (error) {
    element('no_picture').hidden = false;
  }
}
