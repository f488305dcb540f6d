// Where in the recording one is: the slider, the strip under it, the buttons, and playing.
'use strict';

// Columns of the numbers of a frame, as shown_recording.h has them.
const columns = ['time_s', 'strain', 'penetrations', 'stage', 'progress', 'pull', 'contact', 'readable'];

class Timeline {
  // elements: slider, strip, first, back, play, forward, last, speed. wanted(index) is called whenever
  // another frame is to be shown.
  constructor(elements, wanted) {
    Object.assign(this, elements);
    this.wanted = wanted;
    this.index = 0;
    this.frames = 0;
    this.is_playing = false;
    this.slider.addEventListener('input', () => this.go_to(this.slider.valueAsNumber - 1));
    this.first.addEventListener('click', () => this.go_to(0));
    this.back.addEventListener('click', () => this.go_to(this.index - 1));
    this.play.addEventListener('click', () => this.toggle());
    this.forward.addEventListener('click', () => this.go_to(this.index + 1));
    this.last.addEventListener('click', () => this.go_to(this.frames - 1));
    new ResizeObserver(() => this.draw_strip()).observe(this.strip);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.draw_strip());
  }

  open({numbers, frames, frames_per_second}) {
    this.pause();
    this.numbers = numbers;
    this.frames = frames;
    this.frames_per_second = frames_per_second;
    this.slider.max = frames;
    this.index = -1;
    this.move_to(this.next_readable(0, 1) ?? 0);
    this.draw_strip();
  }

  // The same recording has become longer.
  grow({numbers, frames}) {
    this.numbers = numbers;
    this.frames = frames;
    this.slider.max = frames;
    this.draw_strip();
  }

  number(column, index = this.index) {
    return this.numbers[columns.length * index + columns.indexOf(column)];
  }

  // A lost frame has no time of its own.
  time_s(index) {
    const known = this.number('time_s', index);
    return Number.isNaN(known) ? index / this.frames_per_second : known;
  }

  next_readable(index, step) {
    for (; index >= 0 && index < this.frames; index += step)
      if (this.number('readable', index)) return index;
    return null;
  }

  // By hand: playing ends. Over lost frames it goes on in the same direction, at the end back.
  go_to(index) {
    if (!this.frames) return;
    this.pause();
    const inside = Math.min(this.frames - 1, Math.max(0, index));
    const step = inside < this.index ? -1 : 1;
    this.move_to(this.next_readable(inside, step) ?? this.next_readable(inside, -step) ?? this.index);
  }

  move_to(index) {
    this.slider.value = index + 1;  // it may have been drawn to a lost frame
    if (index === this.index) return;
    this.index = index;
    this.slider.setAttribute(
        'aria-valuetext',
        `frame ${index + 1} of ${this.frames}, ${this.time_s(index).toFixed(2)} seconds`);
    this.wanted(index);
  }

  toggle() {
    if (this.is_playing) this.pause();
    else this.start();
  }

  // From the beginning where the end has been reached.
  start() {
    if (this.frames < 2) return;
    if (this.next_readable(this.index + 1, 1) === null)
      this.move_to(this.next_readable(0, 1) ?? this.index);
    this.is_playing = true;
    this.tell_play();
    this.played_s = this.time_s(this.index);
    this.seen_ms = null;
    requestAnimationFrame(now => this.tick(now));
  }

  pause() {
    this.is_playing = false;
    this.tell_play();
  }

  tell_play() {
    this.play.textContent = this.is_playing ? 'Pause' : 'Play';
  }

  // A page in the background is not called; it goes on where it was.
  tick(now_ms) {
    if (!this.is_playing) return;
    const passed_s = this.seen_ms === null ? 0 : Math.min(0.25, (now_ms - this.seen_ms) / 1000);
    this.seen_ms = now_ms;
    this.played_s += passed_s * Number(this.speed.value);
    let index = this.index;
    while (index + 1 < this.frames && this.time_s(index + 1) <= this.played_s) ++index;
    this.move_to(this.next_readable(index, -1) ?? this.index);
    if (index >= this.frames - 1) return this.pause();
    requestAnimationFrame(now => this.tick(now));
  }

  // How tight the ribbon is over time: as high as what is left of the way that it was pulled, dark
  // where it touches something. Stages begin at lines, lost frames are crossed out.
  draw_strip() {
    const scale = devicePixelRatio || 1;
    const width = Math.round(this.strip.clientWidth * scale);
    const height = Math.round(this.strip.clientHeight * scale);
    if (!this.frames || width === 0) return;
    this.strip.width = width;
    this.strip.height = height;
    const pen = this.strip.getContext('2d');
    const style = getComputedStyle(this.strip);
    for (let x = 0; x < width; ++x) {
      const index = Math.min(this.frames - 1, Math.floor(x / width * this.frames));
      this.draw_column(pen, style, index, x, height);
    }
    pen.globalAlpha = 1;
    pen.fillStyle = style.color;
    for (let index = 1; index < this.frames; ++index)
      if (this.number('stage', index) > this.number('stage', index - 1))
        pen.fillRect(Math.round(index / this.frames * width), 0, Math.ceil(scale), height);
  }

  draw_column(pen, style, index, x, height) {
    const progress = this.number('progress', index);
    const contact = this.number('contact', index);
    if (!this.number('readable', index)) {
      pen.fillStyle = style.color;
      pen.globalAlpha = (x & 3) < 2 ? 0.6 : 0.1;
      pen.fillRect(x, 0, 1, height);
    } else if (!Number.isNaN(progress)) {
      const tight = 1 - Math.min(1, Math.max(0, progress));
      pen.fillStyle = style.getPropertyValue('--accent');
      pen.globalAlpha = 0.35 + 0.65 * Math.min(1, contact * 2);
      pen.fillRect(x, height * (1 - tight), 1, height * tight);
    }
  }
}
