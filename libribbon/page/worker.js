// Decodes frames beside the page, by libribbon's playback in WebAssembly. The page sends
//   {wasm}               once, the module's bytes
//   {open, name}         a recording's bytes; answered by {opened} or {refused}
//   {show, of, buffer}   a frame's index, the number of the opening that it is of, and a buffer to fill if
//                        there is one; answered by {shown}, and how long that took, or {lost}; not at all
//                        where another recording has been opened since
// and what cannot be gone on from is answered by {broken}. Other scripts of the worker add to `answers`.
'use strict';

let library;

// What C++ has at an address, as a copy: its memory moves when it grows.
function copied(Type, heap, address, length) {
  return new Type(heap.buffer, address, length).slice();
}

function playback_text() {
  return library.UTF8ToString(library._playback_text());
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
  library.FS.mkdir(folder);
  const file = {folder, path: folder + '/' + path_of(name)};
  library.FS.writeFile(file.path, new Uint8Array(bytes), {canOwn: true});
  return file;
}

function remove_file(file) {
  library.FS.unlink(file.path);
  library.FS.rmdir(file.folder);
}

function numbers_of(frames) {
  return copied(Float64Array, library.HEAPF64, library._playback_numbers(), 8 * frames);
}

function opened_arrays(frames) {
  const p = library;
  const bytes = (address, length) => copied(Uint8Array, p.HEAPU8, address, length);
  const floats = (address, length) => copied(Float32Array, p.HEAPF32, address, length);
  return {
    numbers: numbers_of(frames),
    triangles: copied(Uint32Array, p.HEAPU32, p._playback_triangles(), p._playback_triangles_length()),
    threads: floats(p._playback_threads(), p._playback_threads_length()),
    obstacle: floats(p._playback_obstacle(), p._playback_obstacle_length()),
    pattern: bytes(p._playback_pattern(), p._playback_pattern_length()),
    strain_colors: bytes(p._playback_strain_colors(), 4 * 256),
    light: floats(p._playback_light(), 12),
  };
}

// Memory of C++; throws a number where there is none, as C++ does.
function allocated(length) {
  const address = library._malloc(length);
  if (address === 0) throw address;
  return address;
}

// Calls a C function with strings that live as long as the call.
function call_with_texts(called, ...texts) {
  const addresses = texts.map(text => {
    const length = 4 * text.length + 1;
    const address = allocated(length);
    library.stringToUTF8(text, address, length);
    return address;
  });
  const answer = called(...addresses);
  for (const address of addresses) library._free(address);
  return answer;
}

let opening = 0;  // the number of the recording that is open

// What an open recording is to who draws it; null where it is refused, for which there is a sentence.
function description_of(path, name) {
  const frames = call_with_texts(library._playback_open, path);
  if (frames < 0) return null;
  return {...JSON.parse(playback_text()), ...opened_arrays(frames), file: name, opening: ++opening};
}

function show(frame, buffer) {
  const begun_ms = performance.now();
  const length = library._playback_show(frame);
  if (length < 0) return postMessage({lost: frame, sentence: playback_text().replace(/^\/\d+\//, '')});
  const particles =
      buffer && buffer.byteLength === 4 * length ? new Float32Array(buffer) : new Float32Array(length);
  const address = library._playback_particles() / 4;
  particles.set(library.HEAPF32.subarray(address, address + length));
  postMessage({shown: frame, particles, took_ms: performance.now() - begun_ms}, [particles.buffer]);
}

const answers = {
  async wasm(message) {
    library = await createLibrary({wasmBinary: message.wasm});
  },
  open(message) {
    const file = write_file(message.open, message.name);
    const opened = description_of(file.path, message.name);
    if (!opened) {
      const sentence = playback_text().replace(file.folder + '/', '');
      remove_file(file);
      return postMessage({refused: sentence});
    }
    if (open_file) remove_file(open_file);
    open_file = file;
    postMessage({opened});
  },
  show(message) {
    if (message.of === opening) show(message.show, message.buffer);
  },
};

// One after the other, those that came while the module was made included.
let last = Promise.resolve();
function do_next(deed) {
  last = last.then(deed).catch(error => postMessage({broken: reason_of(error), left: left()}));
}

// What C++ throws and nobody catches comes as a number; libribbon itself throws nothing.
const reason_of = error => (typeof error === 'number' ? 'memory has run out' : String(error));

let left = () => null;  // what can still be saved of what was being done
onmessage = ({data}) => {
  const kind = Object.keys(answers).find(key => key in data);
  do_next(() => answers[kind](data));
};
