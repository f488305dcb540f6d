// What the page in which one draws knows of a curve (recorder/page/curve.js), the file that CURVE names.
'use strict';
const assert = require('node:assert');
const {test} = require('node:test');
const curve = require(require('node:path').resolve(process.env.CURVE));

// An overhand knot as the page finds it: three crossings, passages 0 1 2 0 1 2.
const overhand = [[10, 0], [20, 10], [30, 0]].map(
    (at, i) => ({at, first: 1 + i, second: 4 + i, first_over: i % 2 === 0}));
const told = {crossings: overhand, passes: []};
// It passes an object before its first crossing, and between the second and the third passage.
const round_object = {crossings: overhand, passes: [{at: [5, 0], begin: 0.25, end: 0.75, in_front: true},
                                                    {at: [250, 0], begin: 2.25, end: 2.75, in_front: false}]};

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

test('a drawing in metres is taken as finely as one in millimetres', () => {
  const in_millimetres = [[-640, 570], [12.3456, -7.891], [650, -420]];
  const in_metres = in_millimetres.map(point => point.map(value => value / 1000));
  assert.strictEqual(curve.grain_of(in_millimetres), 1);
  assert.strictEqual(curve.grain_of(in_metres), 0.001);
  assert.strictEqual(curve.grain_of([[3, 4], [3, 4]]), 1);
  assert.deepStrictEqual(curve.rounded(in_millimetres, 1)[1], [12.35, -7.89]);
  assert.deepStrictEqual(curve.rounded(in_metres, 0.001)[1], [0.01235, -0.00789]);
  assert.match(curve.drawing_svg(in_metres, 0.001), /viewBox="-0.7045 -0.4845 1.419 1.119"/);
});

test('any number of points has a box', () => {
  const points = Array.from({length: 300000}, (_, i) => [i, 7 - 2 * i]);
  assert.deepStrictEqual(curve.box_around(points), [0, -599991, 299999, 7]);
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
  assert.strictEqual(curve.letters_of(told), 'OUOUOU');
  assert.strictEqual(curve.letters_of(curve.with_crossing_exchanged(told, 1)), 'OOOUUU');
  assert.strictEqual(curve.letters_of(curve.mirrored(told)), 'UOUOUO');
});

test('letters tell in front and behind where the curve passes the object', () => {
  assert.strictEqual(curve.letters_of(round_object), 'FOUBOUOU');
  assert.strictEqual(curve.letters_of(curve.with_pass_exchanged(round_object, 0)), 'BOUBOUOU');
  assert.strictEqual(curve.letters_of(curve.with_pass_exchanged(round_object, 1)), 'FOUFOUOU');
  assert.strictEqual(curve.letters_of(curve.mirrored(round_object)), 'BUOFUOUO');
});

test('alternating is refused where a crossing has two odd passages', () => {
  const {crossings} = curve.with_crossing_exchanged(told, 1);
  assert.strictEqual(curve.letters_of({crossings: curve.alternated(crossings), passes: []}), 'OUOUOU');
  const shut_in = [{at: [0, 0], first: 1, second: 3, first_over: true},
                   {at: [0, 1], first: 2, second: 4, first_over: true}];
  assert.strictEqual(curve.alternated(shut_in), null);
});

test('a crossing that is dragged along stays as it was chosen', () => {
  const chosen = curve.with_crossing_exchanged(told, 2);
  const moved = overhand.map(one => ({...one, at: [one.at[0] + 3, one.at[1] - 2]}));
  const kept = crossings => curve.with_choices_kept({crossings, passes: []}, chosen, 1).crossings;
  assert.deepStrictEqual(kept(moved).map(one => one.first_over), [true, false, false]);
  const one_more = [...moved, {at: [500, 500], first: 2.5, second: 9, first_over: true}];
  assert.strictEqual(kept(one_more)[3].first_over, true);
});

test('what was led behind the object stays behind it', () => {
  const found = {crossings: [], passes: [{at: [12, -4], begin: 0.3, end: 0.8, in_front: true},
                                         {at: [900, 0], begin: 5, end: 6, in_front: true}]};
  const chosen = {crossings: [], passes: [{at: [5, 0], begin: 0.25, end: 0.75, in_front: false}]};
  assert.deepStrictEqual(curve.with_choices_kept(found, chosen, 1).passes.map(one => one.in_front), [false, true]);
  // In a drawing a hundred times as fine it is another place.
  assert.deepStrictEqual(curve.with_choices_kept(found, chosen, 0.01).passes.map(one => one.in_front), [true, true]);
});

const line = Array.from({length: 8}, (_, i) => [100 * i, 0]);
const reaches = pieces => pieces.map(piece => [piece[0][0], piece.at(-1)[0]]);

test('the curve has a gap at each passage under and nowhere else', () => {
  const {seen, behind} = curve.drawn_pieces(line, told, 5);
  assert.deepStrictEqual(reaches(seen), [[0, 195], [205, 395], [405, 595], [605, 700]]);
  assert.deepStrictEqual(behind, []);
});

test('what lies behind the object is drawn by itself', () => {
  const {seen, behind} = curve.drawn_pieces(line, round_object, 5);
  assert.deepStrictEqual(reaches(seen), [[0, 195], [205, 225], [275, 395], [405, 595], [605, 700]]);
  assert.deepStrictEqual(reaches(behind), [[225, 275]]);
  const over_a_gap = {crossings: overhand, passes: [{at: [200, 0], begin: 1.5, end: 2.5, in_front: false}]};
  const pieces = curve.drawn_pieces(line, over_a_gap, 5);
  assert.deepStrictEqual(reaches(pieces.seen), [[0, 150], [250, 395], [405, 595], [605, 700]]);
  assert.deepStrictEqual(reaches(pieces.behind), [[150, 195], [205, 250]]);
});

test('gaps are small where passages are close', () => {
  const close = [{at: [0, 0], first: 1, second: 1.03, first_over: false}];
  const points = [[0, 0], [100, 0], [200, 0]];
  const [first, second] = curve.drawn_pieces(points, {crossings: close, passes: []}, 5).seen;
  assert.ok(Math.abs(second[0][0] - first.at(-1)[0] - 2) < 1e-9);
});

test('sentences tell their place in the drawing', () => {
  assert.deepStrictEqual(curve.place_in('drawing at (12.5, -4): two pieces touch'), [12.5, -4]);
  assert.deepStrictEqual(curve.place_in('drawing at (1e+03, -4.2e-05): x'), [1000, -4.2e-5]);
  assert.strictEqual(curve.place_in('sketch.toml:3:1: a (wrong) key'), null);
});
