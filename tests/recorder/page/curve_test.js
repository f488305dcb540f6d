// What the page in which one draws knows of a curve (recorder/page/curve.js), the file that CURVE names.
'use strict';
const assert = require('node:assert');
const {test} = require('node:test');
const curve = require(require('node:path').resolve(process.env.CURVE));

// An overhand knot as the page finds it: three crossings, passages 0 1 2 0 1 2.
const overhand = [[10, 0], [20, 10], [30, 0]].map(
    (at, i) => ({at, first: 1 + i, second: 4 + i, first_over: i % 2 === 0}));

test('a stroke keeps its ends and its corners, and nothing of a straight line', () => {
  const stroke = [];
  for (let i = 0; i <= 100; ++i) stroke.push([i, 0.5 * Math.sin(i)]);
  for (let i = 1; i <= 100; ++i) stroke.push([100, i]);
  assert.deepStrictEqual(curve.simplified(stroke, 3), [[0, 0], stroke[100], [100, 100]]);
});

test('a closed stroke is not taken for a point', () => {
  const ring = Array.from({length: 101}, (_, i) => [50 * Math.cos(i / 50 * Math.PI), 50 * Math.sin(i / 50 * Math.PI)]);
  assert.ok(curve.simplified(ring, 3).length > 6);
});

test('what was undone comes back, until something else is done', () => {
  const states = new curve.History(0);
  states.add(1);
  states.add(2);
  states.undo();
  states.undo();
  assert.deepStrictEqual([states.state, states.can_undo, states.can_redo], [0, false, true]);
  states.redo();
  assert.strictEqual(states.state, 1);
  states.add(3);
  assert.deepStrictEqual([states.state, states.can_redo], [3, false]);
});

test('letters tell over and under in the order of the walk', () => {
  assert.strictEqual(curve.letters_of(overhand), 'OUOUOU');
  assert.strictEqual(curve.letters_of(curve.exchanged(overhand, 1)), 'OOOUUU');
  assert.strictEqual(curve.letters_of(curve.mirrored(overhand)), 'UOUOUO');
});

test('alternating is refused where a crossing has two odd passages', () => {
  assert.strictEqual(curve.letters_of(curve.alternated(curve.exchanged(overhand, 1))), 'OUOUOU');
  const shut_in = [{at: [0, 0], first: 1, second: 3, first_over: true},
                   {at: [0, 1], first: 2, second: 4, first_over: true}];
  assert.strictEqual(curve.alternated(shut_in), null);
});

test('a crossing that is dragged along stays as it was chosen', () => {
  const chosen = curve.exchanged(overhand, 2);
  const moved = overhand.map(one => ({...one, at: [one.at[0] + 3, one.at[1] - 2]}));
  assert.deepStrictEqual(curve.with_choices_kept(moved, chosen).map(one => one.first_over),
                         [true, false, false]);
  const one_more = [...moved, {at: [500, 500], first: 2.5, second: 9, first_over: true}];
  assert.strictEqual(curve.with_choices_kept(one_more, chosen)[3].first_over, true);
});

test('the curve has a gap at each passage under and nowhere else', () => {
  const points = Array.from({length: 8}, (_, i) => [100 * i, 0]);
  const pieces = curve.pieces_with_gaps(points, overhand, 5);
  assert.deepStrictEqual(pieces.map(piece => [piece[0][0], piece.at(-1)[0]]),
                         [[0, 195], [205, 395], [405, 595], [605, 700]]);
});

test('gaps are small where passages are close', () => {
  const close = [{at: [0, 0], first: 1, second: 1.03, first_over: false}];
  const [first, second] = curve.pieces_with_gaps([[0, 0], [100, 0], [200, 0]], close, 5);
  assert.ok(Math.abs(second[0][0] - first.at(-1)[0] - 2) < 1e-9);
});

test('sentences tell their place in the drawing', () => {
  assert.deepStrictEqual(curve.place_in('drawing at (12.5, -4): two pieces touch'), [12.5, -4]);
  assert.deepStrictEqual(curve.place_in('drawing at (1e+03, -4.2e-05): x'), [1000, -4.2e-5]);
  assert.strictEqual(curve.place_in('sketch.toml:3:1: a (wrong) key'), null);
});
