// The page in which one draws: what is drawn goes to the worker, which answers with the knot diagram, and
// ties it when asked to.
'use strict';

// ---- Scenes: objects to draw round, and drawings to begin with

let scenes = [];       // as scene_json() has them; the first ones are offered as objects. None where one is given
let scene = null;      // the one whose text is changed
let given = null;      // the user's own, where the page was written for one
const object_count = 4;
let is_new_object = false;  // its outline has not been seen yet
let grain = 1;         // in drawing units: about a two-thousandth of what is drawn there
const title_of = name => name.charAt(0).toUpperCase() + name.slice(1).replaceAll('-', ' ');

const pairs = flat => Array.from({length: flat.length / 2}, (_, i) => flat.slice(2 * i, 2 * i + 2));

function object_of({object}) {
  return object && {name: object.name,
                    vertices: new Float32Array(object.vertices),
                    triangles: new Int32Array(object.triangles)};
}

// Of one scene's drawing, in the drawing units of another, as few points as tell it.
function points_for(target, {points, unit_m, origin}) {
  const scale = unit_m / target.unit_m;
  const placed = pairs(points).map(
      point => point.map((value, axis) => (value - origin[axis]) * scale + target.origin[axis]));
  return rounded(simplified(placed, 3 * grain), grain);
}

// ---- What is drawn

// points; what is told of their curve round `of`, a scene's object, once the worker has found it (null
// before); and from what that is found: the letters that come with a drawing, or what was told before.
let states = new History({points: [], told: nothing_told, of: null, letters: '', before: nothing_told});
let answer = null;   // the worker's last one of what is drawn now: its text, letters, knot, problem
let looked = 0;      // the number of the last question
const asked = new Map();

const board = new Board(
    {
      board: element('board'),
      paper: element('paper'),
      shape: element('shape'),
      band: element('band'),
      band_behind: element('band_behind'),
      dots: element('dots'),
      cursor: element('cursor'),
      mistake: element('mistake'),
      crossing_buttons: element('crossings'),
      pass_buttons: element('passes'),
      all_seen: element('all_seen'),
    },
    {
      points_changed: points => change(points, null),
      crossing_exchanged: index => {
        change(states.state.points, with_crossing_exchanged(states.state.told, index));
        tell(board.spoken_crossing(index));
      },
      pass_exchanged: index => {
        change(states.state.points, with_pass_exchanged(states.state.told, index));
        tell(board.spoken_pass(index));
      },
      said: sentence => tell(sentence),
    });

// What is not told yet is as it was, as far as it is still there.
function change(points, told) {
  const {state} = states;
  states.add({points, told, of: scene, letters: '', before: state.told ?? state.before});
  show_drawing();
}

// What is lost when the page is closed.
const unsaved = {drawing: false, recording: false};
addEventListener('beforeunload', event => {
  if (unsaved.drawing || unsaved.recording || is_tying) event.preventDefault();
});

// Without what binary fractions add.
const plain = value => +value.toPrecision(12);

// What of the scene is changed besides its drawing.
function settings() {
  const lines = [];
  if (!given) lines.push('name="sketch"', `obstacle.mesh="${scene.object.file}"`);
  const width_m = element('width').disabled ? 0 : plain(Number(element('width').value) / 100);
  if (width_m > 0 && width_m !== plain(scene.width_m)) lines.push(`ribbon.width=${width_m}`);
  if (element('mesh').value !== 'given') lines.push(...mesh_settings(width_m));
  return lines.join('\n');
}

// As fine along as across.
function mesh_settings(width_m) {
  const across = Number(element('mesh').value);
  const length_m = (lengths_of(states.state.points).at(-1) ?? 0) * scene.unit_m;
  const along = Math.round(length_m / (width_m || scene.width_m || 0.06) * (across - 1) / 10) * 10;
  return [`ribbon.across=${across}`, `ribbon.along=${Math.min(1500, Math.max(40, along))}`];
}

function show_drawing() {
  const {state} = states;
  if (state.of !== scene)
    Object.assign(state, {told: null, of: scene, letters: '', before: state.told ?? state.before});
  const {points, told} = state;
  unsaved.drawing = points.length > 0;
  answer = null;
  ties_once_answered = false;
  element('undo').disabled = !states.can_undo;
  element('redo').disabled = !states.can_redo;
  board.show(points, told ?? nothing_told);
  board.show_mistake(null);
  if (points.length > 1) return look(told ? letters_of(told) : state.letters);
  states.state.told = nothing_told;
  element('knot').textContent = '';
  tell('Draw a curve that begins and ends outside of the object, and leads round it.');
}

function look(letters) {
  asked.clear();
  asked.set(++looked, {state: states.state, letters});
  const svg = drawing_svg(states.state.points, grain);
  send({diagram: {scene: scene.text, svg, letters, settings: settings(), number: looked}});
}

function take_diagram({drawn, number}) {
  const question = asked.get(number);
  if (!question) return;
  asked.delete(number);
  const {state} = question;
  if (!state.told && state.letters !== '' && (drawn.problem || !drawn.crossings)) {
    state.letters = '';  // of another object, or of a curve that is less simple
    return look('');
  }
  if (!state.told && drawn.crossings) {
    state.told = with_choices_kept(drawn, state.before, grain);
    board.show(state.points, state.told);
    tell_passes(state.told.passes);
    const letters = letters_of(state.told);
    if (letters !== '' && (letters !== drawn.letters || drawn.knot === '')) return look(letters);
  }
  answer = {...drawn, svg: drawing_svg(state.points, grain)};
  element('knot').textContent = drawn.knot ? `This ties: ${drawn.knot}` : '';
  if (drawn.problem) tell_mistake(drawn.problem);
  else if (status_line.className === 'problem' || status_line.textContent.startsWith('Draw a curve'))
    tell('');
  if (ties_once_answered) tie();
}

// Who only meant to lead the curve round the object shall hear of it.
function tell_passes(passes) {
  if (passes.length === 0) return;
  const where = passes.map(({in_front}) => (in_front ? 'in front' : 'behind')).join(', then ');
  tell(`The curve passes the object ${where}; F and B in the drawing exchange that.`);
}

function tell_mistake(sentence) {
  tell_problem(sentence.replaceAll('sketch.svg', 'drawing'));
  board.show_mistake(place_in(sentence));
}

function take_outline({outlined, problem}) {
  board.show_object(outlined);
  if (problem) tell_problem(problem);
  if (is_new_object) fit_board();
  is_new_object = false;
  say_ready();
}

// The object and the drawing with room around them.
function fit_board() {
  const points = states.state.points.slice();
  const path = element('shape').getAttribute('d') ?? '';
  for (const [, x, y] of path.matchAll(/[ML](\S+?) ([^MLZ]+)/g)) points.push([Number(x), Number(y)]);
  if (points.length === 0) points.push([-500, -500], [500, 500]);
  const box = box_around(points);
  const room = states.state.points.length > 0 ? 0.08 : 1.2;
  const margin = room * Math.max(box[2] - box[0], box[3] - box[1]);
  board.fit([box[0] - margin, box[1] - margin, box[2] + margin, box[3] + margin]);
}

// ---- Modes

const is_watching = () => document.body.dataset.mode === 'watch';

function set_mode(mode) {
  if (mode === 'watch') board.let_go();
  document.body.dataset.mode = mode;
  for (const name of ['draw', 'watch'])
    element(name + '_mode').setAttribute('aria-pressed', String(name === mode));
  timeline.pause();
  if (mode === 'draw') board.draw();
  else if (view && recording) view.draw_soon();
}

// ---- Tying

let begun = null;         // what a start is looked for: its scene, drawing, name, object
let tied = null;          // what is being tied or was: likewise, and its recording once it has ended
let ties_once_answered = false;  // Tie was pressed before the worker had read the drawing
let is_tying = false;     // or a start is looked for
let begun_ms = 0;
let most_frames = 0;

function tie() {
  if (states.state.points.length < 2) return tell_problem('there is no curve to tie; draw one');
  ties_once_answered = answer === null;
  if (ties_once_answered) return;
  if (!answer.text) return tell_mistake(answer.problem);
  const name = given ? given.file.replace(/\.toml$/, '') + '-sketch' : 'sketch';
  begun = {scene: answer.text, svg: answer.svg, name, object: object_of(scene),
           object_file: scene.object?.file};
  is_tying = true;
  wanted.is_asked = true;
  wanted.frame = null;
  show_ending();
  tell('Looking for a start…');
  send({tie: {scene: begun.scene, svg: begun.svg, file: name + '.rbn'}});
}

// A worker that looks for a start hears nothing: another one takes its place.
async function stop_looking() {
  if (!begun) return;
  begun = null;
  is_tying = false;
  show_ending();
  tell('Stopped before a start was found.');
  await begin_anew();
}

// With a new worker, which is given what the one before had.
async function begin_anew() {
  end_worker();
  send_object();
  if (tied?.recording) send({open: tied.recording.slice().buffer, name: tied.name + '.rbn'});
  if (!answer && states.state.points.length > 1) show_drawing();
  await start_worker();
}

// By a new worker; who had turned it looks at it as before.
function take_reopened(opened) {
  const index = timeline.index;
  const camera = view?.camera;
  wanted.is_asked = false;
  show_recording(opened);
  if (camera?.is_moved) view.camera = camera;
  timeline.go_to(Math.min(index, opened.frames - 1));
}

function take_opened(opened, most) {
  if (most === undefined) return take_reopened(opened);
  tied = begun;
  begun = null;
  unsaved.recording = true;
  most_frames = most;
  begun_ms = performance.now();
  wanted.is_asked = false;
  element('watch_mode').disabled = false;
  set_mode('watch');
  show_recording(opened);
  show_ending();
  tell('Tying…');
}

// Frames may come faster than a page without a graphics card can show them: then only the newest is shown.
let grown = null;

function take_grown(frames, numbers) {
  if (!grown) requestAnimationFrame(show_grown);
  grown = {frames, numbers};
}

// Who watches the last frame goes on to watch the last one.
function show_grown() {
  if (!grown) return;
  const {frames, numbers} = grown;
  grown = null;
  const follows = timeline.index === recording.frames - 1 && !timeline.is_playing;
  recording.frames = frames;
  recording.numbers = numbers;
  timeline.grow(recording);
  if (!recording.strain_limit) show_strain();
  if (follows) timeline.move_to(frames - 1);
  const took_s = (performance.now() - begun_ms) / 1000;
  const left = known(timeline.number('progress', frames - 1), value => `, ${progress_percent(value)} to go`);
  element('tying').textContent =
      `frame ${frames} of at most ${most_frames}${left}, ${(frames / took_s).toFixed(0)} frames/s`;
}

function take_tied({tied: summary, frames, numbers, bytes}) {
  tied.recording = bytes;
  grown = {frames, numbers};
  show_grown();
  is_tying = false;
  show_ending();
  tell(`Tied: ${summary}`);
}

// What was tied before can still be watched.
function take_refusal(sentence, left) {
  show_grown();
  keep_left(left);
  begun = null;
  is_tying = false;
  wanted.is_asked = recording === null;
  show_ending();
  tell_mistake(sentence);
}

function show_ending() {
  element('tie').disabled = is_tying;
  element('stop_looking').hidden = begun === null;
  element('stop').hidden = !is_tying;
  for (const kind of ['recording', 'shape', 'motion', 'scene', 'object'])
    element('save_' + kind).disabled = is_tying;
  element('save_object').hidden = given !== null;
  if (!is_tying) element('tying').textContent = '';
}

// ---- Files to take away

function save(name, content) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([content]));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

function save_recording() {
  save(tied.name + '.rbn', tied.recording);
  unsaved.recording = false;
}

function save_scene() {
  save(tied.name + '.toml', tied.scene);
  save('sketch.svg', tied.svg);
  if (answer?.text === tied.scene && answer.svg === tied.svg) unsaved.drawing = false;
  tell((given ? `Put ${tied.name}.toml and sketch.svg into the folder of ${given.file}`
              : `Put ${tied.name}.toml, sketch.svg and ${tied.object_file} into one folder`) +
       ', under these names: the browser may have numbered them.');
}

// ---- The worker

function take(answered) {
  if (answered.drawn) take_diagram(answered);
  else if (answered.outlined) take_outline(answered);
  else if (answered.opened) take_opened(answered.opened, answered.most_frames);
  else if (answered.refused) tell_problem(answered.refused);
  else if (answered.grown) take_grown(answered.grown, answered.numbers);
  else if (answered.tied) take_tied(answered);
  else if (answered.not_tied) take_refusal(answered.not_tied, answered.left);
  else if (answered.exported) for (const [name, bytes] of answered.exported) save(name, bytes);
  else if (answered.not_exported) tell_problem(answered.not_exported);
  else if (answered.broken) take_over(answered.broken, answered.left);
  else take_frame(answered);
}

// Out of memory, most likely: the drawing is here, and so is what was tied before, or `left` of what was
// being tied.
let last_fall_ms = -Infinity;
async function take_over(reason, left) {
  begun = null;
  grown = null;
  is_tying = false;
  keep_left(left);
  show_ending();
  const falls_again = performance.now() - last_fall_ms < 5000;
  last_fall_ms = performance.now();
  tell_problem(`it could not be computed (${reason}); ` +
               (falls_again ? 'reload the page' : 'choose a coarser mesh') +
               (left ? '. What was tied until then can be watched and saved' : ''));
  if (falls_again) end_worker();
  else await begin_anew();
}

// Of what was being tied, or of what was tied before, there is a recording; or there is none.
function keep_left(left) {
  if (left) tied.recording = left;
  else if (!tied?.recording) forget_recording();
}

function forget_recording() {
  recording = null;
  tied = null;
  unsaved.recording = false;
  element('watch_mode').disabled = true;
  set_mode('draw');
}

// ---- Controls

function choose_object(index) {
  scene = given ?? scenes[index];
  grain = board.grain = given ? grain_of(pairs(given.points)) : 1;
  element('width').disabled = scene.width_m === 0;
  element('width').value = scene.width_m > 0 ? plain(100 * scene.width_m) : '';
  is_new_object = true;
  send_object();
}

function send_object() {
  send({object: object_of(scene) ?? null});
  send({outline: scene.text});
}

// Empty: as it is.
function begin_with(index) {
  if (index === '') return;
  const begun = given ?? scenes[index];
  const points = points_for(scene, begun);
  states.add({points, told: null, of: scene, letters: begun.letters, before: nothing_told});
  show_drawing();
  fit_board();
}

function offer(select, options) {
  element(select).replaceChildren(...options.map(([value, text]) => new Option(text, value)));
}

function offer_scenes() {
  element('object_label').hidden = given !== null;
  if (given) {
    offer('ready', [['', 'nothing'], ['0', 'its own drawing']]);
    element('mesh').prepend(new Option(`${given.across} × ${given.along}, as in the scene`, 'given'));
    element('mesh').value = 'given';
    return;
  }
  offer('object', scenes.slice(0, object_count).map((one, i) => [i, `${one.object.name}`]));
  const drawings = scenes.slice(object_count);
  offer('ready', [['', 'nothing'], ['0', 'overhand knot'],
                  ...drawings.map((one, i) => [object_count + i, title_of(one.name).toLowerCase() + ' knot'])]);
}

element('undo').addEventListener('click', () => (states.undo(), show_drawing()));
element('redo').addEventListener('click', () => (states.redo(), show_drawing()));
element('clear').addEventListener('click', () => {
  change([], nothing_told);
  element('ready').value = '';  // so that the same may be chosen again
});
element('mirror').addEventListener('click', () => {
  const {points, told} = states.state;
  if (told && letters_of(told)) change(points, mirrored(told));
});
element('alternate').addEventListener('click', () => {
  const {points, told} = states.state;
  const crossings = alternated(told?.crossings ?? []);
  if (!crossings) return tell_problem('over and under cannot alternate: an end is shut in by a loop of the curve; lead it out, or exchange crossings one by one');
  if (crossings.length) change(points, {...told, crossings});
});
element('object').addEventListener('change', event => {
  choose_object(event.target.value);
  show_drawing();
});
element('ready').addEventListener('change', event => begin_with(event.target.value));
for (const id of ['width', 'mesh']) element(id).addEventListener('change', show_drawing);
element('tie').addEventListener('click', tie);
element('stop_looking').addEventListener('click', stop_looking);
element('stop').addEventListener('click', () => send({stop: true}));
element('save_recording').addEventListener('click', save_recording);
element('save_shape').addEventListener(
    'click', () => send({shape: {name: tied.name, frame: timeline.index}}));
element('save_motion').addEventListener('click', () => send({motion: {name: tied.name}}));
element('save_scene').addEventListener('click', save_scene);
element('save_object').addEventListener(
    'click', () => send({object_file: {file: tied.object_file, object: tied.object}}));
for (const mode of ['draw', 'watch'])
  element(mode + '_mode').addEventListener('click', () => set_mode(mode));
addEventListener('keydown', event => {
  if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== 'z' || is_watching()) return;
  event.preventDefault();
  element(event.shiftKey ? 'redo' : 'undo').click();
});

// ---- The beginning

async function begin() {
  start_view();
  show_ending();
  given = element('scene').textContent ? await unpacked_json('scene') : null;
  if (!given) scenes = await unpacked_json('scenes');
  offer_scenes();
  choose_object(0);
  show_drawing();
  await start_worker();
}

begin().catch(error => tell_problem(`this browser cannot tie knots (${error.message})`));
