// node --test worker_test.js: what the worker of the page says where memory has run out.
'use strict';
const assert = require('node:assert');
const fs = require('node:fs');
const path = require('node:path');
const test = require('node:test');
const vm = require('node:vm');

const root = path.resolve(__dirname, '../../..');

// The worker with this instead of C++, and what it says.
function worker_with(library) {
  const said = [];
  const worker = vm.createContext(
      {createLibrary: async () => library, performance, setTimeout, postMessage: message => said.push(message)});
  for (const script of ['libribbon/page/worker.js', 'recorder/page/tying_worker.js'])
    vm.runInContext(fs.readFileSync(path.join(root, script), 'utf8'), worker, {filename: script});
  return {ask: data => worker.onmessage({data}), said};
}

test('what finds no room in memory is not handed to C++', async () => {
  const unexpected = () => assert.fail('C++ was called');
  const {ask, said} = worker_with({
    HEAPF32: new Float32Array(8), _malloc: () => 0, _free() {}, stringToUTF8() {}, _sketch_object: unexpected});
  ask({wasm: null});
  ask({object: {name: 'stone', vertices: new Float32Array(3), triangles: new Int32Array(3)}});
  ask({object: null});
  await new Promise(setImmediate);
  assert.deepStrictEqual(said.map(({broken}) => broken), ['memory has run out', 'memory has run out']);
});
