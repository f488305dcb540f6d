// tie_in_node.js SCENES FOLDER [FRAMES]: draws the first of the packed scenes (pack_scenes) and ties it by
// what the worker of the page in which one draws is made of, without a browser. Leaves sketch.toml and
// sketch.svg, as the page would save them, page.rbn, and of it page.obj (its last frame) with page.mtl,
// page.glb and page-object.obj in FOLDER. Stops after FRAMES.
'use strict';
const fs = require('node:fs');
const path = require('node:path');
const vm = require('node:vm');

const root = path.resolve(__dirname, '../..');
const [, , scenes_file, folder, most_frames] = process.argv;
const module_file = path.join(root, 'build/page/recorder/page/sketch');
const curve = require(path.join(root, 'recorder/page/curve.js'));
const [scene] = JSON.parse(fs.readFileSync(scenes_file));

const points = curve.rounded(curve.simplified(
    Array.from({length: scene.points.length / 2}, (_, i) => scene.points.slice(2 * i, 2 * i + 2)), 3), 1);
const svg = curve.drawing_svg(points, 1);
const settings = ['name="sketch"', `obstacle.mesh="${scene.object.file}"`].join('\n');

// The worker's other side.
const answered = {
  drawn({drawn}) {
    if (drawn.problem) throw new Error(drawn.problem);
    fs.writeFileSync(path.join(folder, 'sketch.toml'), drawn.text);
    fs.writeFileSync(path.join(folder, 'sketch.svg'), svg);
    ask({tie: {scene: drawn.text, svg, file: 'sketch.rbn'}});
  },
  opened() {},
  grown({grown}) {
    if (most_frames && grown >= most_frames) ask({stop: true});
  },
  tied({tied, frames, bytes}) {
    console.log(`${frames} frames: ${tied}`);
    fs.writeFileSync(path.join(folder, 'page.rbn'), bytes);
    ask({shape: {name: 'page', frame: frames - 1}});
    ask({motion: {name: 'page'}});
    ask({object_file: {file: 'page-object.obj', object: given}});
  },
  exported({exported}) {
    for (const [name, bytes] of exported) fs.writeFileSync(path.join(folder, name), bytes);
  },
};

const worker = vm.createContext({
  createLibrary: require(module_file + '.js'),
  performance,
  setTimeout,
  postMessage(message) {
    const kind = Object.keys(answered).find(key => key in message);
    if (!kind) throw new Error(message.not_tied ?? message.not_exported ?? message.broken ?? JSON.stringify(message));
    answered[kind](message);
  },
});
for (const script of ['libribbon/page/worker.js', 'recorder/page/tying_worker.js'])
  vm.runInContext(fs.readFileSync(path.join(root, script), 'utf8'), worker, {filename: script});
const ask = data => worker.onmessage({data});

const {object} = scene;
const given = {name: object.name, vertices: new Float32Array(object.vertices),
               triangles: new Int32Array(object.triangles)};
ask({wasm: fs.readFileSync(module_file + '.wasm')});
ask({object: given});
ask({diagram: {scene: scene.text, svg, letters: scene.letters, settings, number: 1}});
