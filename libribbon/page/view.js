// Draws the ribbon and its obstacle by WebGL2: each in one call.
'use strict';

// Light is linear in the normal but for its sign: what vertices hand on is little, and pixels are cheap
// without a graphics card, too.
const light_on_vertex = `
uniform vec3 light[4];  // direction of the sun, its radiance, that of the sky above and below
out vec2 facing;        // the sun, the sky

void hand_on(vec3 normal) {
  facing = vec2(dot(normal, light[0]), normal.y);
}`;

const light_on_pixel = `
uniform vec3 light[4];
in vec2 facing;

vec3 lit(vec3 albedo) {
  vec2 seen = gl_FrontFacing ? facing : -facing;
  return albedo * (light[1] * max(seen.x, 0.0) + mix(light[3], light[2], 0.5 + seen.y / 3.0));
}
vec4 on_screen(vec3 linear) {
  vec3 shown = min(linear, 1.0);
  return vec4(mix(12.92 * shown, 1.055 * pow(shown, vec3(1.0 / 2.4)) - 0.055,
                  step(0.0031308, shown)), 1);
}`;

const cloth_vertex_shader = `#version 300 es
in vec3 position;
in vec3 normal;
in float strain;
in vec2 thread;
uniform mat4 clip_from_world;
out vec2 place;
out float strained;
${light_on_vertex}
void main() {
  hand_on(normal);
  place = thread;
  strained = strain;
  gl_Position = clip_from_world * vec4(position, 1);
}`;

// Where colours tell strain, bars across the back alone still tell the sides apart: a light and a dark line
// side by side, which stand out from any colour.
const cloth_fragment_shader = `#version 300 es
precision highp float;
precision highp sampler2DArray;
in vec2 place;
in float strained;
uniform sampler2DArray cloth;  // front, back
uniform float pattern_period;  // in ribbon widths
uniform sampler2D strain_colors;
uniform float most_strain;     // 0: the cloth is shown
out vec4 color;
${light_on_pixel}
void main() {
  vec3 albedo;
  if (most_strain > 0.0) {
    vec3 told = pow(texture(strain_colors, vec2(strained / most_strain, 0.5)).rgb, vec3(2.2));
    float bar = gl_FrontFacing ? 1.0 : fract(place.x);
    albedo = bar < 0.2 ? mix(told, vec3(1), 0.8) : bar < 0.4 ? 0.1 * told : told;
  } else {
    vec3 root = texture(cloth, vec3(place.x / pattern_period, place.y, gl_FrontFacing ? 0.0 : 1.0)).rgb;
    albedo = root * root;
  }
  color = on_screen(lit(albedo));
}`;

const obstacle_vertex_shader = `#version 300 es
in vec3 position;
in vec3 normal;
uniform mat4 clip_from_world;
${light_on_vertex}
void main() {
  hand_on(normal);
  gl_Position = clip_from_world * vec4(position, 1);
}`;

const obstacle_fragment_shader = `#version 300 es
precision highp float;
out vec4 color;
${light_on_pixel}
void main() {
  color = on_screen(lit(vec3(0.50, 0.47, 0.43)));
}`;

function compiled_program(gl, vertex, fragment) {
  const program = gl.createProgram();
  for (const [kind, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost())
    throw new Error(gl.getProgramInfoLog(program));
  const uniforms = {};
  const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) || 0;
  for (let i = 0; i < count; ++i) {
    const name = gl.getActiveUniform(program, i).name;
    uniforms[name.replace('[0]', '')] = gl.getUniformLocation(program, name);
  }
  return {program, uniforms};
}

// attributes: [name, how many floats], which lie one behind the other.
function interleaved(gl, program, buffer, attributes) {
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  const stride = 4 * attributes.reduce((sum, [, size]) => sum + size, 0);
  let offset = 0;
  for (const [name, size] of attributes) {
    const place = gl.getAttribLocation(program, name);
    if (place >= 0) {
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, size, gl.FLOAT, false, stride, offset);
    }
    offset += 4 * size;
  }
}

// Of the upper border of what is seen: a lens of 60 mm, as ribbon-play has.
const lens_slope = 12 / 60;

// Turns about a point of the scene; y is up. First it has the three-quarter view of ribbon-play.
class Camera {
  constructor() {
    this.azimuth = 36 * Math.PI / 180;
    this.elevation = 22 * Math.PI / 180;
    this.distance = 1;
    this.eye = [0, 0, 0];
    this.matrix = new Float32Array(16);
    this.is_moved = false;  // by who looks
    this.surround([-1, -1, -1], [1, 1, 1]);
    this.fit(1);
  }

  // A box that may be seen.
  surround(low, high) {
    this.target = low.map((value, axis) => (value + high[axis]) / 2);
    this.half = low.map((value, axis) => Math.max(1e-6, (high[axis] - value) / 2));
    this.radius = Math.hypot(...this.half);
  }

  // To where the box's corners just fit.
  fit(aspect) {
    this.middle = this.target.slice();
    const {right, up, back} = this.axes();
    const margin = 1.05;
    this.distance = 0;
    for (let number = 0; number < 8; ++number) {
      const corner = this.half.map((value, axis) => (number >> axis & 1 ? value : -value));
      const aside = Math.max(Math.abs(dot3(corner, right)) / aspect, Math.abs(dot3(corner, up)));
      this.distance = Math.max(this.distance, dot3(corner, back) + margin / lens_slope * aside);
    }
  }

  orbit(right, up) {
    this.is_moved = true;
    this.azimuth -= right;
    this.elevation = Math.min(1.57, Math.max(-1.57, this.elevation + up));
  }

  zoom(factor) {
    this.is_moved = true;
    this.distance = Math.min(50 * this.radius, Math.max(0.05 * this.radius, this.distance / factor));
  }

  axes() {
    const [ca, sa] = [Math.cos(this.azimuth), Math.sin(this.azimuth)];
    const [ce, se] = [Math.cos(this.elevation), Math.sin(this.elevation)];
    return {right: [ca, 0, -sa], up: [-se * sa, ce, -se * ca], back: [ce * sa, se, ce * ca]};
  }

  // By shares of the picture's height.
  pan(right, up) {
    this.is_moved = true;
    const axes = this.axes();
    const height = 2 * this.distance * lens_slope;
    this.middle = this.middle.map(
        (value, i) => value - height * (right * axes.right[i] + up * axes.up[i]));
  }

  // Column by column, in an array that stays the same one.
  clip_from_world(aspect) {
    const {right, up, back} = this.axes();
    const {eye, matrix, target} = this;
    for (let i = 0; i < 3; ++i) eye[i] = this.middle[i] + this.distance * back[i];
    const reach = Math.hypot(eye[0] - target[0], eye[1] - target[1], eye[2] - target[2]);
    const far = reach + 3 * this.radius;
    const near = Math.max(reach - 3 * this.radius, far / 2000);
    const fy = 1 / lens_slope;
    const fx = fy / aspect;
    const depth = (far + near) / (near - far);
    const set_row = (row, axis, scale) => {
      for (let i = 0; i < 3; ++i) matrix[4 * i + row] = scale * axis[i];
      matrix[12 + row] = -scale * dot3(axis, eye);
    };
    set_row(0, right, fx);
    set_row(1, up, fy);
    set_row(2, back, depth);
    set_row(3, back, -1);
    matrix[14] += 2 * far * near / (near - far);
    return matrix;
  }
}

function dot3(a, b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// How many pixels are drawn for one of the screen's in each direction, and how long a picture may take
// among others before they become fewer: more than one only where that costs no pictures.
const sharpness = [
  {share: 2, most_ms: 20},
  {share: 1, most_ms: 36},
  {share: 0.7, most_ms: 36},
  {share: 0.5, most_ms: Infinity},
];
const most_pixels = 8e6;
const rest_ms = 250;

// Which of them, by how long pictures take while something moves.
class Pace {
  constructor() {
    this.patience = 30;  // pictures in time before more pixels are tried
    this.set_level(1);
  }

  set_level(level) {
    this.level = Math.min(sharpness.length - 1, Math.max(0, level));
    this.count = 0;
    this.mean_ms = 0;
  }

  // From the beginning of a picture to when the next one could begin.
  took(ms) {
    if (ms > 1000) return;  // nobody saw it
    const window = 8;
    ++this.count;
    this.mean_ms += (Math.min(100, ms) - this.mean_ms) / Math.min(window, this.count);
    if (this.count < window) return;
    const {most_ms} = sharpness[this.level];
    if (this.mean_ms > most_ms) {
      if (this.count < 2 * window) this.patience *= 2;
      this.set_level(this.level + (this.mean_ms > 2 * most_ms ? 2 : 1));
    } else if (this.level > 0 && this.mean_ms < sharpness[0].most_ms && this.count >= this.patience) {
      this.set_level(this.level - 1);
    }
  }
}

const floats_per_particle = 7;  // position, normal, strain
const floats_per_corner = 6;    // of the obstacle: position, normal

class View {
  // Throws where the browser has no WebGL2.
  constructor(canvas) {
    this.canvas = canvas;
    this.camera = new Camera();
    this.most_strain = 0;
    this.particles = null;
    this.recording = null;
    this.pace = new Pace();
    this.drawn_ms = null;   // when the last picture was begun, until the next one could be
    this.drawn_level = 0;
    // Edges become smooth by more pixels, and nothing is seen through it: both are cheaper without a
    // graphics card.
    this.gl = canvas.getContext('webgl2', {antialias: false, alpha: false});
    if (!this.gl) throw new Error('no WebGL2');
    this.prepare();
    canvas.addEventListener('webglcontextlost', event => event.preventDefault());
    canvas.addEventListener('webglcontextrestored', () => this.restore());
    new ResizeObserver(() => this.keep_all_seen()).observe(canvas);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.match_paper());
  }

  prepare() {
    const gl = this.gl;
    this.cloth = compiled_program(gl, cloth_vertex_shader, cloth_fragment_shader);
    this.stone = compiled_program(gl, obstacle_vertex_shader, obstacle_fragment_shader);
    gl.enable(gl.DEPTH_TEST);
    this.match_paper();
  }

  // The canvas itself has the page's colour.
  match_paper() {
    const [red, green, blue] = getComputedStyle(this.canvas).backgroundColor.match(/\d+/g).map(Number);
    this.gl.clearColor(red / 255, green / 255, blue / 255, 1);
    this.draw_soon();
  }

  // The browser took the graphics card away, and gave it back empty.
  restore() {
    this.prepare();
    if (!this.recording) return;
    const particles = this.particles;
    this.load(this.recording);
    if (particles) this.show(particles);
  }

  open(recording) {
    this.recording = recording;
    this.widens_box(recording.obstacle, floats_per_corner);
    this.load(recording);
    this.show_all();
  }

  show_all() {
    this.camera = new Camera();
    this.keep_all_seen();
  }

  // Until who looks has turned, moved or zoomed. A picture that is hidden has no size to fit in.
  keep_all_seen() {
    const {camera, canvas, recording} = this;
    if (recording) camera.surround(recording.box_min, recording.box_max);
    if (!camera.is_moved && canvas.clientWidth > 0 && canvas.clientHeight > 0)
      camera.fit(canvas.clientWidth / canvas.clientHeight);
    this.draw_soon();
  }

  load(recording) {
    const gl = this.gl;
    this.particles = null;
    this.release();
    this.buffers = {
      particles: this.filled(gl.ARRAY_BUFFER, recording.threads.length / 2 * floats_per_particle * 4,
                             gl.STREAM_DRAW),
      threads: this.filled(gl.ARRAY_BUFFER, recording.threads, gl.STATIC_DRAW),
      obstacle: this.filled(gl.ARRAY_BUFFER, recording.obstacle, gl.STATIC_DRAW),
    };
    this.ribbon = gl.createVertexArray();
    gl.bindVertexArray(this.ribbon);
    this.buffers.triangles = this.filled(gl.ELEMENT_ARRAY_BUFFER, recording.triangles, gl.STATIC_DRAW);
    interleaved(gl, this.cloth.program, this.buffers.particles,
                [['position', 3], ['normal', 3], ['strain', 1]]);
    interleaved(gl, this.cloth.program, this.buffers.threads, [['thread', 2]]);
    this.obstacle = gl.createVertexArray();
    gl.bindVertexArray(this.obstacle);
    interleaved(gl, this.stone.program, this.buffers.obstacle, [['position', 3], ['normal', 3]]);
    gl.bindVertexArray(null);
    this.load_textures(recording);
  }

  filled(target, content, usage) {
    const buffer = this.gl.createBuffer();
    this.gl.bindBuffer(target, buffer);
    this.gl.bufferData(target, content, usage);
    return buffer;
  }

  release() {
    const gl = this.gl;
    for (const buffer of Object.values(this.buffers ?? {})) gl.deleteBuffer(buffer);
    for (const array of [this.ribbon, this.obstacle]) gl.deleteVertexArray(array ?? null);
    for (const texture of this.textures ?? []) gl.deleteTexture(texture);
  }

  load_textures({pattern, pattern_along, pattern_across, strain_colors}) {
    const gl = this.gl;
    this.textures = [gl.createTexture(), gl.createTexture()];
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, this.textures[0]);
    gl.texImage3D(gl.TEXTURE_2D_ARRAY, 0, gl.RGBA8, pattern_along, pattern_across, 2, 0, gl.RGBA,
                  gl.UNSIGNED_BYTE, pattern);
    gl.generateMipmap(gl.TEXTURE_2D_ARRAY);
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
    this.anisotropy = gl.getExtension('EXT_texture_filter_anisotropic');
    gl.activeTexture(gl.TEXTURE1);
    gl.bindTexture(gl.TEXTURE_2D, this.textures[1]);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 256, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, strain_colors);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
    gl.activeTexture(gl.TEXTURE0);  // its anisotropy changes
  }

  // Keeps the array until the next frame is shown, and returns the one before.
  show(particles) {
    const before = this.particles;
    this.particles = particles;
    this.gl.bindBuffer(this.gl.ARRAY_BUFFER, this.buffers.particles);
    this.gl.bufferSubData(this.gl.ARRAY_BUFFER, 0, particles);
    if (this.widens_box(particles, floats_per_particle)) this.keep_all_seen();
    else this.draw_soon();
    return before;
  }

  // The box that the worker tells is that of the ribbon alone, and a recording that still grows is pulled out
  // of it. floats: of each point, whose place they begin with.
  widens_box(points, floats) {
    const {box_min, box_max} = this.recording;
    let widens = false;
    for (let i = 0; i < points.length; i += floats)
      for (let axis = 0; axis < 3; ++axis) {
        const value = points[i + axis];
        if (value < box_min[axis]) box_min[axis] = value;
        else if (value > box_max[axis]) box_max[axis] = value;
        else continue;
        widens = true;
      }
    return widens;
  }

  // At most once each time the screen is renewed, and only when something has changed.
  draw_soon() {
    this.is_wanted = true;
    this.await_screen();
  }

  await_screen() {
    if (this.is_waiting) return;
    this.is_waiting = true;
    requestAnimationFrame(now_ms => this.renew(now_ms));
  }

  renew(now_ms) {
    this.is_waiting = false;
    if (this.drawn_ms !== null) this.pace.took(now_ms - this.drawn_ms);
    this.drawn_ms = null;
    if (!this.is_wanted) return;
    this.is_wanted = false;
    this.draw(this.pace.level);
    this.drawn_ms = now_ms;
    this.await_screen();
    clearTimeout(this.rest);
    if (this.drawn_level > 0) this.rest = setTimeout(() => this.draw(0), rest_ms);
  }

  fit_to_screen(level) {
    const {clientWidth, clientHeight} = this.canvas;
    const scale = Math.min(Math.min(2, devicePixelRatio || 1) * sharpness[level].share,
                           Math.sqrt(most_pixels / Math.max(1, clientWidth * clientHeight)));
    const width = Math.max(1, Math.round(clientWidth * scale));
    const height = Math.max(1, Math.round(clientHeight * scale));
    if (this.canvas.width !== width) this.canvas.width = width;
    if (this.canvas.height !== height) this.canvas.height = height;
    this.gl.viewport(0, 0, width, height);
    return width / height;
  }

  draw(level = 0) {
    const gl = this.gl;
    if (!this.recording || gl.isContextLost()) return;
    this.drawn_level = level;
    const clip_from_world = this.camera.clip_from_world(this.fit_to_screen(level));
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    // The ribbon hides more of the obstacle than the other way round.
    if (this.particles) {
      const uniforms = this.use(this.cloth, clip_from_world);
      gl.uniform1i(uniforms.cloth, 0);
      gl.uniform1i(uniforms.strain_colors, 1);
      gl.uniform1f(uniforms.pattern_period, this.recording.pattern_period);
      gl.uniform1f(uniforms.most_strain, this.most_strain);
      if (this.anisotropy)
        gl.texParameterf(gl.TEXTURE_2D_ARRAY, this.anisotropy.TEXTURE_MAX_ANISOTROPY_EXT,
                         sharpness[level].share < 1 ? 1 : 8);
      gl.bindVertexArray(this.ribbon);
      gl.drawElements(gl.TRIANGLES, this.recording.triangles.length, gl.UNSIGNED_INT, 0);
    }
    if (this.recording.obstacle.length > 0) {
      this.use(this.stone, clip_from_world);
      gl.bindVertexArray(this.obstacle);
      gl.drawArrays(gl.TRIANGLES, 0, this.recording.obstacle.length / floats_per_corner);
    }
    gl.bindVertexArray(null);
  }

  use({program, uniforms}, clip_from_world) {
    const gl = this.gl;
    gl.useProgram(program);
    gl.uniformMatrix4fv(uniforms.clip_from_world, false, clip_from_world);
    gl.uniform3fv(uniforms.light, this.recording.light);
    return uniforms;
  }
}
