// The sheet in space, by WebGL: facets lit from the viewer's side, lines of a width in pixels.

import { Camera, moveCamera, type Vector } from "./camera.ts";

/** Vertices that belong together. */
export interface Group {
  name: string;
  count: number;
}

/** What a module says of a design in space; see `modules/designs/src/scene.rs`. */
export interface Scene {
  triangles: Group[];
  lines: Group[];
}

/** How facets are coloured. */
export type Shade = "pieces" | "curvature" | "strain";

/** Floats of a vertex of a triangle: place, normal, curvature. */
const FLOATS = 7;

const FACETS = {
  vertex: `#version 300 es
    in vec3 place; in vec3 normal; in float curvature;
    uniform mat4 view; uniform vec3 right, up, towards;
    out vec3 n; out float k;
    void main() {
      gl_Position = view * vec4(place, 1.0);
      gl_Position.z += 0.0008;
      n = vec3(dot(normal, right), dot(normal, up), dot(normal, towards));
      k = curvature;
    }`,
  fragment: `#version 300 es
    precision highp float;
    in vec3 n; in float k;
    uniform vec3 front, back; uniform float most;
    out vec4 colour;
    void main() {
      vec3 m = normalize(n);
      bool turned = m.z < 0.0;
      if (turned) m = -m;
      vec3 base = turned ? back : front;
      if (most > 0.0) {
        float s = clamp(k / most, 0.0, 1.0);
        vec3 low = vec3(0.13, 0.24, 0.55), middle = vec3(0.22, 0.66, 0.62), high = vec3(0.98, 0.85, 0.30);
        base = s < 0.5 ? mix(low, middle, 2.0 * s) : mix(middle, high, 2.0 * s - 1.0);
      }
      float light = 0.55 + 0.47 * max(0.0, dot(m, normalize(vec3(-0.35, 0.5, 0.8))));
      float shine = 0.12 * pow(max(0.0, dot(m, normalize(vec3(-0.2, 0.35, 1.0)))), 40.0);
      colour = vec4(base * light + shine, 1.0);
    }`,
};

const LINES = {
  vertex: `#version 300 es
    in vec3 from; in vec3 to;
    uniform mat4 view; uniform vec2 pixel; uniform float width;
    void main() {
      vec4 a = view * vec4(from, 1.0), b = view * vec4(to, 1.0);
      vec2 along = (b.xy - a.xy) / pixel;
      // A point is no line: the edge of regression of a cone is its apex.
      float there = length(along) > 0.02 ? 1.0 : 0.0;
      along = there > 0.0 ? normalize(along) : vec2(1.0, 0.0);
      float end = float(gl_VertexID & 1), side = float(gl_VertexID >> 1) - 0.5;
      vec2 out_ = vec2(-along.y, along.x) * side * width + along * (end - 0.5) * width * 0.5;
      gl_Position = mix(a, b, end);
      gl_Position.xy += out_ * pixel * there;
      gl_Position.z -= 0.0008;
    }`,
  fragment: `#version 300 es
    precision highp float;
    uniform vec4 ink;
    out vec4 colour;
    void main() { colour = ink; }`,
};

/** Widths in CSS pixels. */
const WIDTHS: Record<string, number> = { outline: 2, joint: 1.6, ruling: 0.9, regression: 2, mark: 1.6 };

/** The view of a design in space. */
export class Viewer {
  readonly camera = new Camera();
  shade: Shade = "pieces";
  private readonly gl: WebGL2RenderingContext;
  private readonly facets: WebGLProgram;
  private readonly lines: WebGLProgram;
  private readonly triangleBuffer: WebGLBuffer;
  private readonly lineBuffer: WebGLBuffer;
  private scene: Scene = { triangles: [], lines: [] };
  private centre: Vector = [0, 0, 0];
  private half: Vector = [1, 1, 1];
  private radius = 1;
  private most = 0;
  private angles: [number, number] | null = null;
  private waiting = false;
  /** Called when the view was drawn. */
  onDraw: () => void = () => {};
  /** Pieces that miss what is demanded of them. */
  private missed = new Set<string>();

  /** Throws where the browser has no WebGL. */
  constructor(private readonly canvas: HTMLCanvasElement) {
    const gl = canvas.getContext("webgl2", { antialias: true, alpha: true, preserveDrawingBuffer: true });
    if (!gl) throw new Error("This browser shows no WebGL; the pattern and the files are made all the same.");
    this.gl = gl;
    this.facets = program(gl, FACETS);
    this.lines = program(gl, LINES);
    this.triangleBuffer = gl.createBuffer();
    this.lineBuffer = gl.createBuffer();
    moveCamera(canvas, this.camera, () => this.redraw(), () => this.home());
    new ResizeObserver(() => this.redraw()).observe(canvas);
  }

  /** Looks at everything again, from where the design asks for. */
  home(): void {
    this.camera.home(this.angles);
    this.camera.fit(this.half, this.radius, this.canvas.clientWidth || 1, this.canvas.clientHeight || 1);
    this.redraw();
  }

  /** Shows a scene. The frame stays where it is unless `frame` is set: what bends or is dragged is not chased. */
  show(scene: Scene, body: Uint8Array<ArrayBuffer>, frame: boolean, angles: [number, number] | null): void {
    const gl = this.gl;
    const vertices = scene.triangles.reduce((sum, group) => sum + group.count, 0);
    const triangles = new Float32Array(body.buffer, body.byteOffset, vertices * FLOATS);
    const lines = new Float32Array(body.buffer, body.byteOffset + triangles.byteLength);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.triangleBuffer);
    gl.bufferData(gl.ARRAY_BUFFER, triangles, gl.DYNAMIC_DRAW);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.lineBuffer);
    gl.bufferData(gl.ARRAY_BUFFER, lines, gl.DYNAMIC_DRAW);
    this.scene = scene;
    this.most = largest(triangles);
    if (frame) {
      this.frame(triangles);
      this.angles = angles;
      this.home();
    }
    this.redraw();
  }

  /** Where a point is seen, in CSS pixels from the upper left corner. */
  project(point: Vector): [number, number] {
    const [width, height] = [this.canvas.clientWidth || 1, this.canvas.clientHeight || 1];
    const m = this.camera.matrix(this.centre, this.radius, width, height);
    const [x, y] = [0, 1].map((row) => (m[row] ?? 0) * point[0] + (m[4 + row] ?? 0) * point[1] + (m[8 + row] ?? 0) * point[2] + (m[12 + row] ?? 0));
    return [(((x ?? 0) + 1) / 2) * width, ((1 - (y ?? 0)) / 2) * height];
  }

  /** How many millimetres a pixel is. */
  perPixel(): number {
    const side = Math.min(this.canvas.clientWidth || 1, this.canvas.clientHeight || 1);
    return (2 * this.radius) / (this.camera.zoom * side);
  }

  /** Half of the diagonal of what was framed, in millimetres. */
  get size(): number {
    return this.radius;
  }

  /** The curvature that has the last colour, in one over millimetres. */
  get mostCurvature(): number {
    return this.most;
  }

  /** The names of what is shown. */
  names(): string[] {
    return this.scene.triangles.map((group) => group.name);
  }

  /** Marks pieces in red. */
  mark(missed: Set<string>): void {
    this.missed = missed;
    this.redraw();
  }

  redraw(): void {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.draw();
    });
  }

  private frame(triangles: Float32Array): void {
    const low: Vector = [Infinity, Infinity, Infinity];
    const high: Vector = [-Infinity, -Infinity, -Infinity];
    for (let k = 0; k < triangles.length; k += FLOATS) {
      for (let axis = 0; axis < 3; axis++) {
        const value = triangles[k + axis] ?? 0;
        low[axis] = Math.min(low[axis] ?? value, value);
        high[axis] = Math.max(high[axis] ?? value, value);
      }
    }
    if (!Number.isFinite(low[0])) return;
    this.centre = low.map((value, axis) => (value + (high[axis] ?? 0)) / 2) as Vector;
    this.half = low.map((value, axis) => ((high[axis] ?? 0) - value) / 2) as Vector;
    this.radius = Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) / 2 || 1;
  }

  private draw(): void {
    const { gl, canvas } = this;
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((n) => Math.max(1, Math.round(n * ratio)));
    if (!width || !height) return;
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    const view = this.camera.matrix(this.centre, this.radius, width, height);
    this.drawFacets(view);
    this.drawLines(view, width, height, ratio);
    this.onDraw();
  }

  private drawFacets(view: Float32Array): void {
    const { gl, facets } = this;
    gl.useProgram(facets);
    const at = (name: string) => gl.getUniformLocation(facets, name);
    gl.uniformMatrix4fv(at("view"), false, view);
    this.camera.axes().forEach((axis, k) => gl.uniform3fv(at(["right", "up", "towards"][k] ?? ""), axis));
    gl.uniform1f(at("most"), this.shade === "pieces" ? 0 : this.most);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.triangleBuffer);
    attribute(gl, facets, "place", 3, 4 * FLOATS, 0);
    attribute(gl, facets, "normal", 3, 4 * FLOATS, 12);
    attribute(gl, facets, "curvature", 1, 4 * FLOATS, 24);
    let first = 0;
    this.scene.triangles.forEach(({ name, count }, number) => {
      const colour = this.missed.has(name) ? "missed" : `sheet-${number % 4}`;
      gl.uniform3fv(at("front"), this.colour(`--${colour}`));
      gl.uniform3fv(at("back"), this.colour(`--${colour}-back`));
      gl.drawArrays(gl.TRIANGLES, first, count);
      first += count;
    });
  }

  private drawLines(view: Float32Array, width: number, height: number, ratio: number): void {
    const { gl, lines } = this;
    gl.useProgram(lines);
    const at = (name: string) => gl.getUniformLocation(lines, name);
    gl.uniformMatrix4fv(at("view"), false, view);
    gl.uniform2f(at("pixel"), 2 / width, 2 / height);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.lineBuffer);
    let first = 0;
    for (const { name, count } of this.scene.lines) {
      gl.uniform1f(at("width"), (WIDTHS[name] ?? 1) * ratio);
      gl.uniform4f(at("ink"), ...this.colour(`--line-${name}`), 1);
      attribute(gl, lines, "from", 3, 24, 12 * first);
      attribute(gl, lines, "to", 3, 24, 12 * first + 12);
      for (const name of ["from", "to"]) gl.vertexAttribDivisor(gl.getAttribLocation(lines, name), 1);
      if (count > 0) gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, count / 2);
      for (const name of ["from", "to"]) gl.vertexAttribDivisor(gl.getAttribLocation(lines, name), 0);
      first += count;
    }
  }

  /** A colour of the style sheet, `#rrggbb`. */
  private colour(name: string): Vector {
    const text = getComputedStyle(this.canvas).getPropertyValue(name).trim() || "#808080";
    const number = Number.parseInt(text.slice(1), 16);
    return [(number >> 16) / 255, ((number >> 8) & 255) / 255, (number & 255) / 255];
  }
}

/** The largest curvature, without the few vertices near an apex where it has no end. */
function largest(triangles: Float32Array): number {
  const all: number[] = [];
  for (let k = 6; k < triangles.length; k += FLOATS) all.push(triangles[k] ?? 0);
  all.sort((a, b) => a - b);
  return all[Math.floor(0.97 * (all.length - 1))] ?? 0;
}

function attribute(gl: WebGL2RenderingContext, of: WebGLProgram, name: string, size: number, stride: number, offset: number) {
  const place = gl.getAttribLocation(of, name);
  if (place < 0) return;
  gl.enableVertexAttribArray(place);
  gl.vertexAttribPointer(place, size, gl.FLOAT, false, stride, offset);
}

function program(gl: WebGL2RenderingContext, source: { vertex: string; fragment: string }): WebGLProgram {
  const made = gl.createProgram();
  for (const [type, text] of [[gl.VERTEX_SHADER, source.vertex], [gl.FRAGMENT_SHADER, source.fragment]] as const) {
    const shader = gl.createShader(type);
    if (!shader) throw new Error("WebGL makes no shader");
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader) ?? "shader");
    gl.attachShader(made, shader);
  }
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(made) ?? "program");
  return made;
}
