// Draws the ribbon and its obstacle by WebGL2: each in one call.
'use strict';

const cloth_vertex_shader = `#version 300 es
in vec3 position;
in vec3 normal;
in float strain;
in vec2 thread;
uniform mat4 clip_from_world;
out vec3 world_normal;
out vec2 place;
out float strained;

void main() {
  world_normal = normal;
  place = thread;
  strained = strain;
  gl_Position = clip_from_world * vec4(position, 1);
}`;

const light_source = `
uniform vec3 light[4];  // direction of the sun, its radiance, that of the sky above and below

vec3 light_on(vec3 normal) {
  return light[1] * max(dot(normal, light[0]), 0.0) + mix(light[3], light[2], 0.5 + normal.y / 3.0);
}
vec4 on_screen(vec3 linear) {
  vec3 shown = min(linear, 1.0);
  return vec4(mix(12.92 * shown, 1.055 * pow(shown, vec3(1.0 / 2.4)) - 0.055,
                  step(0.0031308, shown)), 1);
}`;

// Where colours tell strain, stripes on the back alone still tell the sides apart.
const cloth_fragment_shader = `#version 300 es
precision highp float;
precision highp sampler2DArray;
in vec3 world_normal;
in vec2 place;
in float strained;
uniform sampler2DArray cloth;  // front, back
uniform sampler2D strain_colors;
uniform float most_strain;     // 0: the cloth is shown
out vec4 color;
${light_source}
void main() {
  vec3 normal = normalize(gl_FrontFacing ? world_normal : -world_normal);
  vec3 root = texture(cloth, vec3(place.x / 0.5, place.y, gl_FrontFacing ? 0.0 : 1.0)).rgb;
  vec3 albedo = root * root;
  if (most_strain > 0.0) {
    vec3 told = pow(texture(strain_colors, vec2(strained / most_strain, 0.5)).rgb, vec3(2.2));
    float stripe = gl_FrontFacing ? 1.0 : 0.75 + 0.25 * step(0.5, fract(place.x * 6.0));
    albedo = told * stripe;
  }
  color = on_screen(albedo * light_on(normal));
}`;

const obstacle_vertex_shader = `#version 300 es
in vec3 position;
in vec3 normal;
uniform mat4 clip_from_world;
out vec3 world_normal;

void main() {
  world_normal = normal;
  gl_Position = clip_from_world * vec4(position, 1);
}`;

const obstacle_fragment_shader = `#version 300 es
precision highp float;
in vec3 world_normal;
out vec4 color;
${light_source}
void main() {
  vec3 normal = normalize(gl_FrontFacing ? world_normal : -world_normal);
  color = on_screen(vec3(0.50, 0.47, 0.43) * light_on(normal));
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

// Turns about a point of the scene; y is up.
class Camera {
  // A box that shall be seen.
  constructor(low = [-1, -1, -1], high = [1, 1, 1]) {
    this.target = low.map((value, axis) => (value + high[axis]) / 2);
    this.half = low.map((value, axis) => Math.max(1e-6, (high[axis] - value) / 2));
    this.radius = Math.hypot(...this.half);
    this.reset(1);
  }

  // The three-quarter view of ribbon-play, from where the box just fits.
  reset(aspect) {
    this.azimuth = 36 * Math.PI / 180;
    this.elevation = 22 * Math.PI / 180;
    this.middle = this.target.slice();
    const {right, up, back} = this.axes();
    const reach = axis => axis.reduce((sum, value, i) => sum + Math.abs(value) * this.half[i], 0);
    const margin = 1.05;
    this.distance = reach(back) +
        margin / lens_slope * Math.max(reach(right) / aspect, reach(up));
  }

  orbit(right, up) {
    this.azimuth -= right;
    this.elevation = Math.min(1.57, Math.max(-1.57, this.elevation + up));
  }

  zoom(factor) {
    this.distance = Math.min(50 * this.radius, Math.max(0.05 * this.radius, this.distance / factor));
  }

  axes() {
    const [ca, sa] = [Math.cos(this.azimuth), Math.sin(this.azimuth)];
    const [ce, se] = [Math.cos(this.elevation), Math.sin(this.elevation)];
    return {right: [ca, 0, -sa], up: [-se * sa, ce, -se * ca], back: [ce * sa, se, ce * ca]};
  }

  // By shares of the picture's height.
  pan(right, up) {
    const axes = this.axes();
    const metres = 2 * this.distance * lens_slope;
    this.middle = this.middle.map(
        (value, i) => value - metres * (right * axes.right[i] + up * axes.up[i]));
  }

  // Column by column.
  clip_from_world(aspect) {
    const {right, up, back} = this.axes();
    const eye = this.middle.map((value, i) => value + this.distance * back[i]);
    const reach = Math.hypot(...eye.map((value, i) => value - this.target[i]));
    const far = reach + 3 * this.radius;
    const near = Math.max(reach - 3 * this.radius, far / 2000);
    const fy = 1 / lens_slope;
    const fx = fy / aspect;
    const depth = (far + near) / (near - far);
    const row = (axis, scale) => [...axis.map(v => v * scale), -scale * dot3(axis, eye)];
    const x = row(right, fx);
    const y = row(up, fy);
    const w = row(back, -1);
    const z = row(back, depth);
    z[3] += 2 * far * near / (near - far);
    return new Float32Array([0, 1, 2, 3].flatMap(i => [x[i], y[i], z[i], w[i]]));
  }
}

function dot3(a, b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

class View {
  // Throws where the browser has no WebGL2.
  constructor(canvas) {
    this.canvas = canvas;
    this.camera = new Camera();
    this.most_strain = 0;
    this.particles = null;
    this.recording = null;
    this.gl = canvas.getContext('webgl2', {antialias: true, alpha: true});
    if (!this.gl) throw new Error('no WebGL2');
    this.prepare();
    canvas.addEventListener('webglcontextlost', event => event.preventDefault());
    canvas.addEventListener('webglcontextrestored', () => this.restore());
    new ResizeObserver(() => this.draw_soon()).observe(canvas);
  }

  prepare() {
    const gl = this.gl;
    this.cloth = compiled_program(gl, cloth_vertex_shader, cloth_fragment_shader);
    this.stone = compiled_program(gl, obstacle_vertex_shader, obstacle_fragment_shader);
    gl.enable(gl.DEPTH_TEST);
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
    this.load(recording);
    this.show_all();
  }

  show_all() {
    this.camera = new Camera(this.recording.box_min, this.recording.box_max);
    this.camera.reset(this.canvas.clientWidth / Math.max(1, this.canvas.clientHeight));
    this.draw_soon();
  }

  load(recording) {
    const gl = this.gl;
    this.particles = null;
    this.release();
    this.buffers = {
      particles: this.filled(gl.ARRAY_BUFFER, recording.threads.length / 2 * 7 * 4, gl.STREAM_DRAW),
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

  load_textures({pattern, strain_colors}) {
    const gl = this.gl;
    this.textures = [gl.createTexture(), gl.createTexture()];
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, this.textures[0]);
    gl.texImage3D(gl.TEXTURE_2D_ARRAY, 0, gl.RGBA8, 128, 256, 2, 0, gl.RGBA, gl.UNSIGNED_BYTE, pattern);
    gl.generateMipmap(gl.TEXTURE_2D_ARRAY);
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
    const finer = gl.getExtension('EXT_texture_filter_anisotropic');
    if (finer) gl.texParameterf(gl.TEXTURE_2D_ARRAY, finer.TEXTURE_MAX_ANISOTROPY_EXT, 8);
    gl.activeTexture(gl.TEXTURE1);
    gl.bindTexture(gl.TEXTURE_2D, this.textures[1]);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 256, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, strain_colors);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
  }

  // Keeps the array until the next frame is shown, and returns the one before.
  show(particles) {
    const before = this.particles;
    this.particles = particles;
    this.gl.bindBuffer(this.gl.ARRAY_BUFFER, this.buffers.particles);
    this.gl.bufferSubData(this.gl.ARRAY_BUFFER, 0, particles);
    this.draw_soon();
    return before;
  }

  // At most once each time the screen is renewed, and only when something has changed.
  draw_soon() {
    if (this.is_waiting) return;
    this.is_waiting = true;
    requestAnimationFrame(() => {
      this.is_waiting = false;
      this.draw();
    });
  }

  fit_to_screen() {
    const scale = Math.min(2, devicePixelRatio || 1);
    const width = Math.max(1, Math.round(this.canvas.clientWidth * scale));
    const height = Math.max(1, Math.round(this.canvas.clientHeight * scale));
    if (this.canvas.width !== width) this.canvas.width = width;
    if (this.canvas.height !== height) this.canvas.height = height;
    this.gl.viewport(0, 0, width, height);
    return width / height;
  }

  draw() {
    const gl = this.gl;
    if (!this.recording || gl.isContextLost()) return;
    const clip_from_world = this.camera.clip_from_world(this.fit_to_screen());
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const use = ({program, uniforms}) => {
      gl.useProgram(program);
      gl.uniformMatrix4fv(uniforms.clip_from_world, false, clip_from_world);
      gl.uniform3fv(uniforms.light, this.recording.light);
      return uniforms;
    };
    if (this.recording.obstacle.length > 0) {
      use(this.stone);
      gl.bindVertexArray(this.obstacle);
      gl.drawArrays(gl.TRIANGLES, 0, this.recording.obstacle.length / 6);
    }
    if (this.particles) {
      const uniforms = use(this.cloth);
      gl.uniform1i(uniforms.cloth, 0);
      gl.uniform1i(uniforms.strain_colors, 1);
      gl.uniform1f(uniforms.most_strain, this.most_strain);
      gl.bindVertexArray(this.ribbon);
      gl.drawElements(gl.TRIANGLES, this.recording.triangles.length, gl.UNSIGNED_INT, 0);
    }
    gl.bindVertexArray(null);
  }
}
