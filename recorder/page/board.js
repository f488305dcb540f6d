// The board on which one draws: pointer and keys become points; curve, gaps, crossings, passes of the
// object and mistakes are shown. It changes nothing itself: deeds.points_changed(points),
// deeds.crossing_exchanged(index), deeds.pass_exchanged(index) and deeds.said(sentence) are called.
'use strict';

const svg_name = 'http://www.w3.org/2000/svg';

// Screen pixels.
const reach = {mouse: 11, pen: 16, touch: 22};  // of a point that is to be dragged
const shortest_stroke = 6;                      // a shorter one is a click
const half_gap_px = 9;
const button_px = 44;

// Where buttons stand that belong to these places: there, or as near as may be without lying on one
// before.
function places_of_buttons(places) {
  const taken = [];
  const is_free = ([x, y]) => taken.every(
      ([left, top]) => Math.abs(x - left) >= button_px || Math.abs(y - top) >= button_px);
  const step = button_px / 2;
  for (const [x, y] of places) {
    const offsets = [];
    for (let right = -6; right <= 6; ++right)
      for (let down = -6; down <= 6; ++down) offsets.push([right * step, down * step]);
    offsets.sort((a, b) => Math.hypot(...a) - Math.hypot(...b));
    const [right, down] = offsets.find(([dx, dy]) => is_free([x + dx, y + dy])) ?? [0, 0];
    taken.push([x + right, y + down]);
  }
  return taken;
}

class Board {
  // elements: board (has the focus), paper (svg), shape, band, band_behind, dots, cursor, mistake (in it),
  // crossing_buttons, pass_buttons, all_seen (the button that goes back to that).
  constructor(elements, deeds) {
    Object.assign(this, elements);
    this.deeds = deeds;
    this.points = [];
    this.told = nothing_told;  // crossings, and passes of the object
    this.middle = [0, 0];
    this.scale = 0.3;       // screen pixels a drawing unit
    this.grain = 1;         // drawing units: what is finer is not drawn by hand
    this.spot = [0, 0];     // the keyboard's cursor
    this.selected = -1;     // the point that keys move
    this.pointers = new Map();
    this.stroke = null;     // points that are being drawn
    this.dragged = -1;      // the point that is being dragged
    this.is_moved = false;  // by who draws: zoomed or shifted
    this.listen();
    new ResizeObserver(() => this.keep_all_seen()).observe(this.board);
  }

  listen() {
    const on = (name, deed, options) => this.paper.addEventListener(name, deed, options);
    on('pointerdown', event => this.press(event));
    on('pointermove', event => this.pull(event));
    on('pointerup', event => this.lift(event));
    on('pointercancel', event => this.give_up(event));
    // Or Chromium takes fingers that are lifted in motion for a fling, and the tap that follows for its end.
    on('touchmove', event => event.preventDefault(), {passive: false});
    on('contextmenu', event => event.preventDefault());
    on('wheel', event => {
      event.preventDefault();
      this.zoom(Math.exp(-0.0015 * event.deltaY), this.on_screen(event));
    }, {passive: false});
    this.all_seen.addEventListener('click', () => {
      this.board.focus({preventScroll: true});
      this.fit(this.box);
    });
    this.board.addEventListener('keydown', event => this.key(event));
    this.board.addEventListener('focus', () => this.draw());
    this.board.addEventListener('blur', () => this.draw());
  }

  // ---- What is shown

  show(points, told) {
    if (this.dragged >= 0 && points !== this.before) this.stop_drawing();
    if (this.dragged < 0) this.points = points;
    this.told = told;
    if (this.selected >= points.length) this.selected = -1;
    this.draw();
  }

  // corners: x and y of three corners of each triangle. All are turned the same way, so that where they
  // lie over one another the object is filled.
  show_object(corners) {
    let path = '';
    for (let i = 0; i < corners.length; i += 6) {
      const [ax, ay, bx, by, cx, cy] = corners.subarray(i, i + 6);
      const is_turned = (bx - ax) * (cy - ay) < (by - ay) * (cx - ax);
      path += `M${ax} ${ay}L` + (is_turned ? `${cx} ${cy}L${bx} ${by}Z` : `${bx} ${by}L${cx} ${cy}Z`);
    }
    this.shape.setAttribute('d', path);
  }

  // Where a sentence says that something is wrong; null: nowhere.
  show_mistake(place) {
    this.mistake_at = place;
    this.draw();
  }

  // All of a box, in drawing units, and of what is drawn since.
  fit(box) {
    this.box = box;
    this.is_moved = false;
    this.keep_all_seen();
  }

  // Until who draws zooms or moves: then what is in the middle stays there. A board that is hidden has no
  // size to fit in, and one does not move under a finger.
  keep_all_seen() {
    const {clientWidth: width, clientHeight: height} = this.board;
    this.is_late = this.is_touched;
    if (this.box && width > 0 && !this.is_moved && !this.is_touched) {
      const [left, top, right, bottom] = box_around([this.box.slice(0, 2), this.box.slice(2), ...this.points]);
      this.middle = [(left + right) / 2, (top + bottom) / 2];
      this.scale = Math.min(Math.max(1, width - 40) / (right - left || 1),
                            Math.max(1, height - 40) / (bottom - top || 1));
    }
    this.draw();
  }

  zoom(factor, [x, y]) {
    this.is_moved = true;
    const before = this.in_drawing([x, y]);
    this.scale = Math.min(100 / this.grain, Math.max(1e-3 / this.grain, this.scale * factor));
    const after = this.in_drawing([x, y]);
    this.middle = this.middle.map((value, axis) => value + before[axis] - after[axis]);
    this.draw();
  }

  on_screen(event) {
    const {left, top} = this.board.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  }
  in_drawing([x, y]) {
    return [this.middle[0] + (x - this.board.clientWidth / 2) / this.scale,
            this.middle[1] + (y - this.board.clientHeight / 2) / this.scale];
  }
  to_screen([x, y]) {
    return [this.board.clientWidth / 2 + (x - this.middle[0]) * this.scale,
            this.board.clientHeight / 2 + (y - this.middle[1]) * this.scale];
  }

  draw() {
    const {clientWidth: width, clientHeight: height} = this.board;
    if (width === 0) return;
    this.all_seen.hidden = !this.is_moved;
    const [w, h] = [width / this.scale, height / this.scale];
    this.paper.setAttribute(
        'viewBox', `${this.middle[0] - w / 2} ${this.middle[1] - h / 2} ${w} ${h}`);
    this.draw_band();
    this.draw_dots();
    this.draw_marks();
    this.draw_buttons();
  }

  draw_band() {
    const is_changing = this.stroke !== null || this.dragged >= 0;
    const told = is_changing ? nothing_told : this.told;
    const curve = this.stroke ? [...this.points, ...this.stroke] : this.points;
    const {seen, behind} = curve.length < 2 ? {seen: [], behind: []}
                                            : drawn_pieces(curve, told, half_gap_px / this.scale);
    const path = pieces => pieces.map(piece => 'M' + piece.map(point => point.join(' ')).join('L')).join('');
    this.band.setAttribute('d', path(seen));
    this.band_behind.setAttribute('d', path(behind));
  }

  draw_dots() {
    const [ends, others] = ['', ''].map(() => document.createDocumentFragment());
    this.points.forEach(([x, y], i) => {
      const dot = document.createElementNS(svg_name, 'circle');
      const is_end = i === 0 || i + 1 === this.points.length;
      dot.setAttribute('cx', x);
      dot.setAttribute('cy', y);
      dot.setAttribute('r', (is_end ? 6 : 3.5) / this.scale);
      dot.setAttribute('class', (i === 0 ? 'start' : is_end ? 'end' : '') +
                                    (i === this.selected ? ' selected' : ''));
      (is_end ? ends : others).append(dot);
    });
    this.dots.replaceChildren(others, ends);
  }

  draw_marks() {
    const [x, y] = this.selected >= 0 ? this.points[this.selected] : this.spot;
    const arm = 14 / this.scale;
    this.cursor.toggleAttribute('hidden', document.activeElement !== this.board);
    this.cursor.setAttribute('d', `M${x - arm} ${y}H${x + arm}M${x} ${y - arm}V${y + arm}`);
    this.mistake.toggleAttribute('hidden', !this.mistake_at);
    if (!this.mistake_at) return;
    this.mistake.setAttribute('cx', this.mistake_at[0]);
    this.mistake.setAttribute('cy', this.mistake_at[1]);
    this.mistake.setAttribute('r', 18 / this.scale);
  }

  draw_buttons() {
    const {crossings, passes} = this.told;
    const places = places_of_buttons([...crossings, ...passes].map(({at}) => this.to_screen(at)));
    this.place_buttons(this.crossing_buttons, places.slice(0, crossings.length),
                       this.deeds.crossing_exchanged);
    this.place_buttons(this.pass_buttons, places.slice(crossings.length), this.deeds.pass_exchanged);
    crossings.forEach((_, i) => {
      const button = this.crossing_buttons.children[i];
      button.textContent = i + 1;
      button.setAttribute('aria-label', `${this.spoken_crossing(i)} Exchange`);
    });
    passes.forEach(({in_front}, i) => {
      const button = this.pass_buttons.children[i];
      button.textContent = in_front ? 'F' : 'B';
      button.setAttribute('aria-label', `${this.spoken_pass(i)} Exchange`);
    });
  }

  // As many as there are places; one that has the focus keeps it.
  place_buttons(buttons, places, exchange) {
    while (buttons.children.length > places.length) buttons.lastChild.remove();
    while (buttons.children.length < places.length) {
      const index = buttons.children.length;
      const button = document.createElement('button');
      button.type = 'button';
      button.addEventListener('click', () => exchange(index));
      buttons.append(button);
    }
    places.forEach(([x, y], i) => {
      buttons.children[i].style.left = `${x}px`;
      buttons.children[i].style.top = `${y}px`;
    });
  }

  spoken_crossing(index) {
    const {crossings} = this.told;
    const over = crossings[index].first_over ? 'first over, then under' : 'first under, then over';
    return `Crossing ${index + 1} of ${crossings.length}: the curve runs ${over}.`;
  }

  spoken_pass(index) {
    const {passes} = this.told;
    const where = passes[index].in_front ? 'in front of the object' : 'behind the object';
    return `Passage ${index + 1} of ${passes.length}: the curve runs ${where}.`;
  }

  // ---- Pointers

  get is_touched() {
    return this.pointers.size > 0;
  }

  nearest_point([x, y], within) {
    let [nearest, least] = [-1, within];
    this.points.forEach((point, i) => {
      const way = distance(this.to_screen(point), [x, y]);
      if (way < least) [nearest, least] = [i, way];
    });
    return nearest;
  }

  press(event) {
    const at = this.on_screen(event);
    this.board.focus({preventScroll: true});
    this.paper.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, at);
    if (this.pointers.size > 1 || event.button !== 0) return this.stop_drawing();
    this.dragged = this.nearest_point(at, reach[event.pointerType] ?? reach.mouse);
    this.selected = this.dragged;
    this.pressed_at = at;
    this.way_px = 0;
    this.before = this.points;
    this.stroke = this.dragged < 0 ? [this.in_drawing(at)] : null;
    this.draw();
  }

  pull(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    const at = this.on_screen(event);
    if (this.pointers.size > 1 || (!this.stroke && this.dragged < 0))
      return this.pinch(event.pointerId, at);
    this.pointers.set(event.pointerId, at);
    this.way_px = Math.max(this.way_px, distance(at, this.pressed_at));
    const place = this.in_drawing(at);
    if (this.dragged >= 0) this.points = this.before.with(this.dragged, place);
    else if (distance(before, at) > 0) this.stroke.push(place);
    this.draw();
  }

  lift(event) {
    this.pointers.delete(event.pointerId);
    const [stroke, dragged] = [this.stroke, this.dragged];
    const moved = this.points;
    this.stop_drawing();
    const is_click = this.way_px < shortest_stroke;
    if (dragged >= 0 && !is_click) this.deeds.points_changed(rounded(moved, this.grain));
    else if (stroke) this.add(is_click ? stroke.slice(0, 1) : simplified(stroke, 3 * this.grain));
    if (this.is_late) this.keep_all_seen();
  }

  give_up(event) {
    this.pointers.delete(event.pointerId);
    this.stop_drawing();
    if (this.is_late) this.keep_all_seen();
  }

  // Whatever fingers do.
  let_go() {
    this.pointers.clear();
    this.stop_drawing();
  }

  // What was not finished is forgotten.
  stop_drawing() {
    if (this.dragged >= 0) this.points = this.before;
    this.stroke = null;
    this.dragged = -1;
    this.draw();
  }

  // Two fingers, or another button than the first.
  pinch(id, at) {
    const all = [...this.pointers.values()];
    const before = this.pointers.get(id);
    this.pointers.set(id, at);
    if (all.length > 1) {
      const other = all.find(point => point !== before);
      const middle = [0, 1].map(axis => (at[axis] + other[axis]) / 2);
      this.zoom(distance(at, other) / Math.max(1, distance(before, other)), middle);
    }
    this.is_moved = true;
    const share = this.scale * all.length;
    this.middle = this.middle.map((value, axis) => value - (at[axis] - before[axis]) / share);
    this.draw();
  }

  add(points) {
    const added = rounded(points, this.grain);
    const last = this.points.at(-1);
    this.deeds.points_changed(
        [...this.points, ...(last && distance(last, added[0]) === 0 ? added.slice(1) : added)]);
  }

  // ---- Keys

  key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey || event.target !== this.board) return;
    const step = (event.shiftKey ? 40 : 8) / this.scale;
    const deeds = {
      ArrowLeft: () => this.shift(-step, 0),
      ArrowRight: () => this.shift(step, 0),
      ArrowUp: () => this.shift(0, -step),
      ArrowDown: () => this.shift(0, step),
      Enter: () => this.put(),
      ' ': () => this.put(),
      Delete: () => this.remove(),
      Backspace: () => this.remove(),
      n: () => this.select(this.selected + 1),
      p: () => this.select(this.selected < 0 ? this.points.length - 1 : this.selected - 1),
      Escape: () => this.select(-1),
      '+': () => this.zoom(1.2, this.to_screen(this.spot)),
      '-': () => this.zoom(1 / 1.2, this.to_screen(this.spot)),
      '0': () => this.fit(this.box),
    };
    const deed = deeds[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!deed) return;
    event.preventDefault();
    event.stopPropagation();
    deed();
  }

  say_spot() {
    const [[x, y]] = rounded([this.spot], 100 * this.grain);
    this.deeds.said(this.selected < 0 ? `${x}, ${y}`
                                      : `Point ${this.selected + 1} of ${this.points.length}: ${x}, ${y}`);
  }

  shift(right, down) {
    const [x, y] = this.selected < 0 ? this.spot : this.points[this.selected];
    this.spot = [x + right, y + down];
    if (this.selected >= 0)
      this.deeds.points_changed(rounded(this.points.with(this.selected, this.spot), this.grain));
    this.draw();
    this.say_spot();
  }

  put() {
    this.select(-1);
    this.add([this.spot]);
    this.deeds.said(`Point ${this.points.length} put.`);
  }

  remove() {
    if (this.points.length === 0) return;
    const index = this.selected < 0 ? this.points.length - 1 : this.selected;
    this.deeds.points_changed(this.points.filter((_, i) => i !== index));
  }

  select(index) {
    this.selected = index < 0 || this.points.length === 0 ? -1 : index % this.points.length;
    if (this.selected >= 0) this.spot = this.points[this.selected];
    this.draw();
    if (this.selected >= 0) this.say_spot();
  }
}
