// The drawn curve: its points, what was undone, and its crossings. Points are [x, y] in drawing units.
'use strict';

// ---- Points

const distance = ([ax, ay], [bx, by]) => Math.hypot(bx - ax, by - ay);

// Left, top, right and bottom of points; these may be more than a call takes arguments.
const box_around = points => points.reduce(
    ([left, top, right, bottom], [x, y]) =>
        [Math.min(left, x), Math.min(top, y), Math.max(right, x), Math.max(bottom, y)],
    [Infinity, Infinity, -Infinity, -Infinity]);

// From a point to the segment between two others.
function distance_to_segment([x, y], [ax, ay], [bx, by]) {
  const [dx, dy] = [bx - ax, by - ay];
  const share = ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1);
  const t = Math.min(1, Math.max(0, share));
  return Math.hypot(x - ax - t * dx, y - ay - t * dy);
}

// As few of the points as lie within `tolerance` of all (Douglas and Peucker 1973).
function simplified(points, tolerance) {
  if (points.length < 3) return points.slice();
  const keep = new Uint8Array(points.length);
  keep[0] = keep[points.length - 1] = 1;
  const pending = [[0, points.length - 1]];
  while (pending.length > 0) {
    const [begin, end] = pending.pop();
    let [worst, most] = [0, tolerance];
    for (let i = begin + 1; i < end; ++i) {
      const off = distance_to_segment(points[i], points[begin], points[end]);
      if (off > most) [worst, most] = [i, off];
    }
    if (!worst) continue;
    keep[worst] = 1;
    pending.push([begin, worst], [worst, end]);
  }
  return points.filter((_, i) => keep[i]);
}

// To a hundredth of `grain`, a power of ten.
function rounded(points, grain) {
  const digits = digits_for(grain);
  return points.map(point => point.map(value => +value.toFixed(digits)));
}
const digits_for = grain => Math.max(0, 2 - Math.round(Math.log10(grain)));

// The power of ten that is about a two-thousandth of what the points take up.
function grain_of(points) {
  const [left, top, right, bottom] = box_around(points);
  return 10 ** Math.round(Math.log10(Math.max(right - left, bottom - top) / 2000 || 1));
}

// What can be undone. States stay as they are, but for what is told of them once it is found.
class History {
  constructor(state) {
    this.states = [state];
    this.at = 0;
  }
  get state() {
    return this.states[this.at];
  }
  get can_undo() {
    return this.at > 0;
  }
  get can_redo() {
    return this.at + 1 < this.states.length;
  }
  // What was undone before is forgotten.
  add(state) {
    this.states.length = ++this.at;
    this.states.push(state);
  }
  undo() {
    if (this.can_undo) --this.at;
  }
  redo() {
    if (this.can_redo) ++this.at;
  }
}

// ---- Crossings: {at, first, second, first_over}, in the order of their first passages; and passes of the
// object: {at, begin, end, in_front}, in the order of the walk. What is told of a curve are both.

const nothing_told = {crossings: [], passes: []};

// The two passages of each in the order of the walk.
function passages(crossings) {
  return crossings
      .flatMap((crossing, index) => [{index, parameter: crossing.first, over: crossing.first_over},
                                     {index, parameter: crossing.second, over: !crossing.first_over}])
      .sort((a, b) => a.parameter - b.parameter);
}

// "OUOUOU", as a scene has it; "FOUBOU" where the curve passes the object.
const letters_of = ({crossings, passes}) =>
    [...passages(crossings).map(({parameter, over}) => [parameter, over ? 'O' : 'U']),
     ...passes.map(({begin, in_front}) => [begin, in_front ? 'F' : 'B'])]
        .sort(([a], [b]) => a - b).map(([, letter]) => letter).join('');

// How far a crossing may have moved and still be the same, in grains.
const same_place = 60;

// What was chosen where there was one before stays chosen; what is new is as it was found. `choice` is
// where crossings or passes have it.
function kept(found, before, choice, within) {
  const free = before.slice();
  return found.map(one => {
    let [nearest, least] = [-1, within];
    free.forEach((old, i) => {
      const way = old ? distance(old.at, one.at) : Infinity;
      if (way < least) [nearest, least] = [i, way];
    });
    if (nearest < 0) return one;
    const [old] = free.splice(nearest, 1, null);
    return {...one, [choice]: old[choice]};
  });
}

const with_choices_kept = (found, before, grain) => ({
  crossings: kept(found.crossings, before.crossings, 'first_over', same_place * grain),
  passes: kept(found.passes, before.passes, 'in_front', same_place * grain),
});

const turned_over = crossing => ({...crossing, first_over: !crossing.first_over});
const turned_back = pass => ({...pass, in_front: !pass.in_front});

const with_crossing_exchanged = ({crossings, passes}, index) =>
    ({crossings: crossings.with(index, turned_over(crossings[index])), passes});
const with_pass_exchanged = ({crossings, passes}, index) =>
    ({crossings, passes: passes.with(index, turned_back(passes[index]))});

// As seen from behind the board: over and under, in front and behind.
const mirrored = ({crossings, passes}) =>
    ({crossings: crossings.map(turned_over), passes: passes.map(turned_back)});

// By turns, where each crossing has an odd and an even passage; null where one has not.
function alternated(crossings) {
  const odd = crossings.map(() => []);
  passages(crossings).forEach(({index}, i) => odd[index].push(i % 2));
  if (odd.some(([first, second]) => first === second)) return null;
  return crossings.map((crossing, i) => ({...crossing, first_over: odd[i][0] === 0}));
}

// ---- Pieces between gaps

// Lengths of the walk up to each point.
function lengths_of(points) {
  const lengths = [0];
  for (let i = 1; i < points.length; ++i)
    lengths.push(lengths[i - 1] + distance(points[i - 1], points[i]));
  return lengths;
}

function length_at(lengths, parameter) {
  const i = Math.min(Math.floor(parameter), lengths.length - 2);
  return lengths[i] + (parameter - i) * (lengths[i + 1] - lengths[i]);
}

// The part of the walk from one length to another.
function part_of(points, lengths, begin, end) {
  const at = (i, length) => {
    const share = (length - lengths[i]) / (lengths[i + 1] - lengths[i] || 1);
    return [0, 1].map(axis => points[i][axis] + share * (points[i + 1][axis] - points[i][axis]));
  };
  const part = [];
  for (let i = 0; i + 1 < points.length; ++i) {
    if (lengths[i + 1] <= begin || lengths[i] >= end) continue;
    if (part.length === 0) part.push(at(i, Math.max(begin, lengths[i])));
    part.push(lengths[i + 1] > end ? at(i, end) : points[i + 1]);
  }
  return part;
}

// What of the walk is to be drawn, by lengths, with a gap before and behind each passage under; where
// passages are close, gaps are small.
function spans_with_gaps(lengths, crossings, widest_half_gap) {
  const all = passages(crossings).map(
      passage => ({...passage, length: length_at(lengths, passage.parameter)}));
  const spans = [];
  let begin = 0;
  all.forEach(({over, length}, i) => {
    if (over) return;
    const before = i > 0 ? length - all[i - 1].length : length;
    const next = (i + 1 < all.length ? all[i + 1].length : lengths.at(-1)) - length;
    const half = Math.min(widest_half_gap, before / 3, next / 3);
    spans.push([begin, length - half]);
    begin = length + half;
  });
  spans.push([begin, lengths.at(-1)]);
  return spans;
}

// The pieces of the curve that are to be drawn, with gaps; those behind the object by themselves.
function drawn_pieces(points, {crossings, passes}, widest_half_gap) {
  const lengths = lengths_of(points);
  const pieces_of = spans => spans.filter(([begin, end]) => begin < end)
                                 .map(([begin, end]) => part_of(points, lengths, begin, end))
                                 .filter(piece => piece.length > 1);
  const hidden = passes.filter(({in_front}) => !in_front)
                     .map(({begin, end}) => [begin, end].map(parameter => length_at(lengths, parameter)));
  const seen = [], behind = [];
  for (let [begin, end] of spans_with_gaps(lengths, crossings, widest_half_gap)) {
    for (const [from, to] of hidden) {
      if (to <= begin || from >= end) continue;
      seen.push([begin, Math.max(begin, from)]);
      behind.push([Math.max(begin, from), Math.min(end, to)]);
      begin = Math.min(end, to);
    }
    seen.push([begin, end]);
  }
  return {seen: pieces_of(seen), behind: pieces_of(behind)};
}

// ---- Files

// The drawing as libribbon reads it.
function drawing_svg(points, grain) {
  const told = value => +value.toFixed(digits_for(grain));
  const [left, top, right, bottom] = box_around(points);
  const [width, height] = [right - left, bottom - top];
  const margin = 0.05 * Math.max(width, height, grain);
  const box = [left - margin, top - margin, width + 2 * margin, height + 2 * margin];
  return '<svg xmlns="http://www.w3.org/2000/svg" viewBox="' +
      box.map(told).join(' ') + '">\n' +
      `  <path id="band" fill="none" stroke="#8f1d3c" stroke-width="${told(margin / 10)}" d="M` +
      points.map(([x, y]) => ` ${x} ${y}`).join('') + '"/>\n</svg>\n';
}

// Where in the drawing a sentence of libribbon says that something is wrong; null where it does not.
function place_in(sentence) {
  const found = /\((-?[\d.]+(?:e[-+]?\d+)?), (-?[\d.]+(?:e[-+]?\d+)?)\)/.exec(sentence);
  return found && [Number(found[1]), Number(found[2])];
}

if (typeof module !== 'undefined')
  module.exports = {box_around, simplified, rounded, grain_of, History, passages, letters_of, nothing_told,
                    with_choices_kept, with_crossing_exchanged, with_pass_exchanged, mirrored, alternated,
                    drawn_pieces, drawing_svg, place_in};
