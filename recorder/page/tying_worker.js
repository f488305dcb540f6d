// Reads drawings and ties knots, by libribbon's own code, in the worker that decodes frames. The page
// sends beside what worker.js knows
//   {object}      what to tie round, once for each: {name, vertices, triangles}, or null
//   {diagram}     {scene, svg, letters, settings, number}; answered by {drawn}: of that number, the scene's
//                 text with the diagram, or the sentence why there is none
//   {outline}     a scene's text; answered by {outlined}
//   {tie}         {scene, svg, file}; answered by {opened} with its first frame, by {grown} as frames
//                 are added, at last by {tied} with the recording's bytes; or by {not_tied}. Where that
//                 or {broken} comes between, `left` are the bytes of the recording so far
//   {stop}        ends it; it is answered by {tied} as well
//   {shape}       {name, frame}; answered by {exported}: names and bytes of files with this frame
//   {motion}      {name}; likewise, with all frames; or by {not_exported}
//   {object_file} {file, object}; likewise, with that object alone
'use strict';

const folder = '/sketch';
const scene_file = 'sketch.toml';
let tied_file = '';    // of the recording
let ties = false;
const longest_turn_ms = 40;  // until messages are heard again

const sketch_text = () => library.UTF8ToString(library._sketch_text());

function enter_folder() {
  if (!library.FS.analyzePath(folder).exists) library.FS.mkdir(folder);
  library.FS.chdir(folder);
}

function write_scene(scene, svg) {
  enter_folder();
  library.FS.writeFile(scene_file, scene);
  if (svg) library.FS.writeFile('sketch.svg', svg);
}

function with_array(array, heap, call) {
  const address = allocated(array.byteLength);
  library[heap].set(array, address / 4);
  const answer = call(address);
  library._free(address);
  return answer;
}

// call(name, vertices, their number, triangles, their number)
function with_mesh({name, vertices, triangles}, call) {
  return with_array(vertices, 'HEAPF32', v => with_array(triangles, 'HEAP32', t => call_with_texts(
      text => call(text, v, vertices.length / 3, t, triangles.length / 3), name)));
}

answers.object = ({object}) => {
  if (object) with_mesh(object, library._sketch_object);
  else call_with_texts(name => library._sketch_object(name, 0, 0, 0, 0), '');
};

// The text of the scene with this drawing, and its diagram.
function drawn({scene, svg, letters, settings}) {
  enter_folder();
  const text = call_with_texts(library._sketch_scene, scene_file, scene, letters, settings) < 0
      ? null : sketch_text();
  if (text === null) return {problem: sketch_text()};
  write_scene(text, svg);
  const failed = call_with_texts(library._sketch_diagram, scene_file) < 0;
  return failed ? {text, problem: sketch_text()} : {text, ...JSON.parse(sketch_text())};
}

answers.diagram = ({diagram}) =>
    postMessage({drawn: drawn(diagram), number: diagram.number});

answers.outline = ({outline}) => {
  write_scene(outline, null);
  const length = call_with_texts(library._sketch_outline_length, scene_file);
  if (length < 0) return postMessage({outlined: new Float32Array(0), problem: sketch_text()});
  postMessage({outlined: copied(Float32Array, library.HEAPF32, library._sketch_outline(), length)});
};

answers.tie = ({tie}) => {
  ties = false;
  write_scene(tie.scene, tie.svg);
  const most_frames = call_with_texts(library._sketch_tie, scene_file, tie.file);
  if (most_frames < 0) return postMessage({not_tied: sketch_text()});
  tied_file = folder + '/' + tie.file;
  const state = library._sketch_next();
  if (state < 0) return postMessage({not_tied: sketch_text()});
  const opened = description_of(tied_file, tie.file);
  if (!opened) return postMessage({not_tied: playback_text()});
  postMessage({opened, most_frames});
  ties = true;
  if (state === 0) return tell_tied();
  go_on();
};

// Until all of it is there, what fails leaves the recording so far.
function tell_tied() {
  const summary = sketch_text();
  const frames = refreshed();
  const bytes = library.FS.readFile(tied_file);
  postMessage({tied: summary, frames, numbers: numbers_of(frames), bytes});
  ties = false;
}

function refreshed() {
  const frames = library._playback_refresh();
  if (frames < 0) throw new Error(playback_text());
  return frames;
}

// The recording so far; files are not lost with the memory of what wrote them.
left = () => {
  if (!ties) return null;
  ties = false;
  try {
    return library.FS.readFile(tied_file);
  } catch {
    return null;  // there is no room for a copy
  }
};

// Some frames, and again after what has been asked meanwhile.
function go_on() {
  setTimeout(() => do_next(record_frames));
}

function record_frames() {
  if (!ties) return;
  const begun = performance.now();
  let state;
  do state = library._sketch_next();
  while (state === 1 && performance.now() - begun < longest_turn_ms);
  if (state === 0) return tell_tied();
  if (state < 0) return postMessage({not_tied: sketch_text(), left: left()});
  const frames = refreshed();
  postMessage({grown: frames, numbers: numbers_of(frames)});
  go_on();
}

answers.stop = () => {
  if (!ties) return;
  if (library._sketch_stop() < 0) return postMessage({not_tied: sketch_text(), left: left()});
  tell_tied();
};

// What `write` writes is handed out and not kept.
function hand_out(names, write) {
  enter_folder();
  if (write() < 0) return postMessage({not_exported: sketch_text()});
  const files = names.map(name => [name, library.FS.readFile(name)]);
  for (const name of names) library.FS.unlink(name);
  postMessage({exported: files});
}

const recording_file = () => tied_file || open_file.path;

answers.shape = ({shape: {name, frame}}) => hand_out([name + '.obj', name + '.mtl'], () => call_with_texts(
    (recording, file) => library._sketch_write_shape(recording, frame, file), recording_file(), name + '.obj'));

answers.motion = ({motion: {name}}) => hand_out([name + '.glb'], () => call_with_texts(
    library._sketch_write_motion, recording_file(), name + '.glb'));

answers.object_file = ({object_file: {file, object}}) => hand_out([file], () => with_mesh(
    object, (...mesh) => call_with_texts(path => library._sketch_write_object(path, ...mesh), file)));
