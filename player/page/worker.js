// Decodes frames beside the page, by libribbon's playback in WebAssembly. The page sends
//   {wasm}               once, the module's bytes
//   {open, name}         a recording's bytes; answered by {opened} or {refused}
//   {show, buffer}       a frame's index, and a buffer to fill if there is one; answered by {shown} or
//                        {lost}
// and what cannot be gone on from by {broken}.
'use strict';

let playback;

// What C++ has at an address, as a copy: its memory moves when it grows.
function copied(Type, heap, address, length) {
  return new Type(heap.buffer, address, length).slice();
}

function text() {
  return playback.UTF8ToString(playback._playback_text());
}

// The file's name is that of the user's, so that sentences about it name it.
function path_of(name) {
  const plain = name.replace(/[\/\0]/g, '_');
  return plain === '' || plain === '.' || plain === '..' ? 'recording' : plain;
}

// Each recording in a folder of its own: one that is refused leaves the one before open.
let folders = 0;
let open_file = null;

function write_file(bytes, name) {
  const folder = '/' + ++folders;
  playback.FS.mkdir(folder);
  const file = {folder, path: folder + '/' + path_of(name)};
  playback.FS.writeFile(file.path, new Uint8Array(bytes), {canOwn: true});
  return file;
}

function remove_file(file) {
  playback.FS.unlink(file.path);
  playback.FS.rmdir(file.folder);
}

function opened_arrays(frames) {
  const p = playback;
  const bytes = (address, length) => copied(Uint8Array, p.HEAPU8, address, length);
  const floats = (address, length) => copied(Float32Array, p.HEAPF32, address, length);
  return {
    numbers: copied(Float64Array, p.HEAPF64, p._playback_numbers(), 8 * frames),
    triangles: copied(Uint32Array, p.HEAPU32, p._playback_triangles(), p._playback_triangles_length()),
    threads: floats(p._playback_threads(), p._playback_threads_length()),
    obstacle: floats(p._playback_obstacle(), p._playback_obstacle_length()),
    pattern: bytes(p._playback_pattern(), 2 * 4 * 128 * 256),
    strain_colors: bytes(p._playback_strain_colors(), 4 * 256),
    light: floats(p._playback_light(), 12),
  };
}

// A C string that lives as long as the call.
function with_c_string(string, call) {
  const length = 4 * string.length + 1;
  const address = playback._malloc(length);
  playback.stringToUTF8(string, address, length);
  const answer = call(address);
  playback._free(address);
  return answer;
}

function open(bytes, name) {
  const file = write_file(bytes, name);
  const frames = with_c_string(file.path, playback._playback_open);
  if (frames < 0) {
    const sentence = text().replace(file.folder + '/', '');
    remove_file(file);
    return postMessage({refused: sentence});
  }
  if (open_file) remove_file(open_file);
  open_file = file;
  const opened = {...JSON.parse(text()), ...opened_arrays(frames), file: name};
  postMessage({opened});
}

function show(frame, buffer) {
  const length = playback._playback_show(frame);
  if (length < 0) return postMessage({lost: frame, sentence: text().replace(/^\/\d+\//, '')});
  const particles =
      buffer && buffer.byteLength === 4 * length ? new Float32Array(buffer) : new Float32Array(length);
  const address = playback._playback_particles() / 4;
  particles.set(playback.HEAPF32.subarray(address, address + length));
  postMessage({shown: frame, particles}, [particles.buffer]);
}

async function answer(message) {
  if (message.wasm) playback = await createPlayback({wasmBinary: message.wasm});
  else if (message.open) open(message.open, message.name);
  else show(message.show, message.buffer);
}

// One after the other, those that came while the module was made included.
let last = Promise.resolve();
onmessage = ({data}) => {
  last = last.then(() => answer(data)).catch(error => postMessage({broken: String(error)}));
};
