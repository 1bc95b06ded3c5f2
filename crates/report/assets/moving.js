// Figures with sliders. A part's points are sums over monomials of slider values times nets, so no formula of any
// basis is needed here. Surfaces are drawn by the painter's algorithm: quadrangles, far ones first.
"use strict";
(() => {
  const TILT = { yaw: -0.9, pitch: 0.45, zoom: 1 };
  const MARGIN = 34;

  function combine(data, part, values) {
    const total = new Float64Array(part.nets[0].length);
    data.monomials.forEach((exponents, number) => {
      const weight = exponents.reduce((product, exponent, slider) => product * values[slider] ** exponent, 1);
      const net = part.nets[number];
      if (weight !== 0) for (let k = 0; k < net.length; k += 1) total[k] += weight * net[k];
    });
    return total;
  }

  // The box around all parts at the start and with each slider at its ends: it stays while sliders move.
  function boxOf(data) {
    const low = Array(data.dimension).fill(Infinity), high = Array(data.dimension).fill(-Infinity);
    const start = data.sliders.map((slider) => slider.start);
    const places = [start];
    data.sliders.forEach((slider, k) => {
      for (const end of [slider.least, slider.greatest]) places.push(start.map((value, j) => (j === k ? end : value)));
    });
    places.push(data.sliders.map((slider) => slider.least), data.sliders.map((slider) => slider.greatest));
    for (const values of places) {
      for (const part of data.parts) {
        combine(data, part, values).forEach((value, k) => {
          low[k % data.dimension] = Math.min(low[k % data.dimension], value);
          high[k % data.dimension] = Math.max(high[k % data.dimension], value);
        });
      }
    }
    return { low, high };
  }

  const mix = (colour, other, part) => colour.map((value, k) => value + (other[k] - value) * part);
  const css = (colour, opacity = 1) => `rgb(${colour.map((value) => Math.round(value)).join(" ")} / ${opacity})`;

  // The segments of a part as pairs of point numbers.
  function segments(part, count) {
    const list = [];
    if (part.shape === "net") {
      for (let k = 0; k < count; k += 1) {
        if ((k + 1) % part.columns) list.push([k, k + 1]);
        if (k + part.columns < count) list.push([k, k + part.columns]);
      }
    } else if (part.shape !== "points") for (let k = 0; k + 1 < count; k += 1) list.push([k, k + 1]);
    return list;
  }

  class Moving {
    constructor(details) {
      this.data = JSON.parse(details.querySelector("script").textContent);
      this.box = boxOf(this.data);
      this.values = this.data.sliders.map((slider) => slider.start);
      Object.assign(this, TILT);
      this.canvas = document.createElement("canvas");
      this.canvas.tabIndex = 0;
      this.canvas.setAttribute("role", "img");
      this.canvas.setAttribute("aria-label", `${details.dataset.alt} With sliders; arrow keys turn it.`);
      details.append(this.canvas, this.legend(), this.controls());
      this.listen();
      new ResizeObserver(() => this.draw()).observe(this.canvas);
      this.draw();
    }

    legend() {
      const list = document.createElement("p");
      list.className = "legend";
      for (const part of this.data.parts.filter((one) => one.label)) {
        const entry = document.createElement("span");
        // Where a label names a slider between two signs, its value is shown.
        const label = part.label.replace(/@(\w+)@/g, (_, name) => `<output data-slider="${name}"></output>`);
        entry.innerHTML = `<i class="swatch" style="background:${css(part.colour)}"></i>${label}`;
        list.append(entry);
      }
      this.live = [...list.querySelectorAll("output")];
      return list;
    }

    showValues() {
      for (const output of this.live) {
        const value = this.values[this.data.sliders.findIndex(({ name }) => name === output.dataset.slider)];
        output.textContent = String(Number(value.toPrecision(3))).replace("-", "−");
      }
    }

    controls() {
      const box = document.createElement("div");
      box.className = "sliders";
      this.inputs = this.data.sliders.map((slider, k) => {
        const row = document.createElement("label");
        const name = document.createElement("span"), input = document.createElement("input"), output = document.createElement("output");
        name.innerHTML = slider.label;
        Object.assign(input, { type: "range", min: slider.least, max: slider.greatest, step: slider.step, value: slider.start });
        const show = () => { output.textContent = Number(input.value).toPrecision(3); };
        input.addEventListener("input", () => { this.values[k] = Number(input.value); show(); this.draw(); });
        show();
        row.append(name, input, output);
        box.append(row);
        return { input, start: slider.start, show };
      });
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = "Put back";
      button.addEventListener("click", () => this.reset());
      box.append(button);
      return box;
    }

    reset() {
      Object.assign(this, TILT);
      this.inputs.forEach(({ input, start, show }, k) => { input.value = start; this.values[k] = start; show(); });
      this.draw();
    }

    listen() {
      const { canvas } = this;
      const turn = (yaw, pitch) => {
        this.yaw += yaw;
        this.pitch = Math.max(-1.57, Math.min(1.57, this.pitch + pitch));
        this.draw();
      };
      let held = null;
      if (this.data.dimension === 3) {
        canvas.classList.add("turns");
        canvas.addEventListener("pointerdown", (event) => { held = event; canvas.setPointerCapture(event.pointerId); });
        canvas.addEventListener("pointermove", (event) => {
          if (!held) return;
          turn((event.clientX - held.clientX) * 0.01, (event.clientY - held.clientY) * 0.01);
          held = event;
        });
        for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => { held = null; });
      }
      canvas.addEventListener("keydown", (event) => {
        const turns = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] };
        const scales = { "+": 1.1, "=": 1.1, "-": 1 / 1.1 };
        if (event.key in turns && this.data.dimension === 3) turn(...turns[event.key]);
        else if (event.key in scales) { this.zoom *= scales[event.key]; this.draw(); }
        else if (event.key === "Home") this.reset();
        else return;
        event.preventDefault();
      });
    }

    // Pixels to the right, pixels down, and height towards the eye of each point.
    project(points) {
      const { low, high } = this.box, { width, height } = this;
      const size = low.map((value, k) => high[k] - value);
      const middle = low.map((value, k) => value + size[k] / 2);
      const screen = [];
      if (this.data.dimension === 2) {
        const room = [width - 2 * MARGIN, height - 2 * MARGIN];
        let scale = room.map((length, k) => this.zoom * length / (size[k] || 1));
        const longest = Math.max(...size), shortest = Math.min(...size);
        if (longest < 6 * shortest) scale = scale.fill(Math.min(...scale));
        this.scale = scale;
        for (let k = 0; k < points.length; k += 2) {
          screen.push([width / 2 + (points[k] - middle[0]) * scale[0], height / 2 - (points[k + 1] - middle[1]) * scale[1], 0]);
        }
        return screen;
      }
      const scale = this.zoom * Math.min(width, height) * 1.2 / (Math.hypot(...size) || 1);
      const [cy, sy, cp, sp] = [Math.cos(this.yaw), Math.sin(this.yaw), Math.cos(this.pitch), Math.sin(this.pitch)];
      for (let k = 0; k < points.length; k += 3) {
        const [x, y, z] = [points[k] - middle[0], points[k + 1] - middle[1], points[k + 2] - middle[2]];
        const right = cy * x + sy * y, back = cy * y - sy * x;
        screen.push([width / 2 + right * scale, height / 2 - (z * cp + back * sp) * scale, (z * sp - back * cp) * scale]);
      }
      return screen;
    }

    // What a part is drawn with: things to paint, each with its height towards the eye.
    things(part) {
      const screen = this.project(combine(this.data, part, this.values));
      const things = [];
      const segment = (a, b, width, colour, lift) => things.push({
        near: (screen[a][2] + screen[b][2]) / 2 + lift,
        paint: (pen) => {
          pen.strokeStyle = colour;
          pen.lineWidth = width;
          pen.beginPath();
          pen.moveTo(screen[a][0], screen[a][1]);
          pen.lineTo(screen[b][0], screen[b][1]);
          pen.stroke();
        },
      });
      if (part.shape === "surface") {
        const { columns } = part, rows = screen.length / columns;
        for (let i = 0; i + 1 < rows; i += 1) {
          for (let j = 0; j + 1 < columns; j += 1) {
            const k = i * columns + j;
            things.push(this.quadrangle(part, [k, k + 1, k + columns + 1, k + columns].map((corner) => screen[corner])));
          }
        }
        const dark = css(mix(part.colour, [0, 0, 0], 0.45), 0.55);
        const every = (count) => Math.max(1, Math.round((count - 1) / 8));
        for (let i = 0; i < rows; i += 1) {
          for (let j = 0; j < columns; j += 1) {
            const k = i * columns + j;
            if (j + 1 < columns && (i % every(rows) === 0 || i + 1 === rows)) segment(k, k + 1, 0.8, dark, 1.5);
            if (i + 1 < rows && (j === 0 || j + 1 === columns)) segment(k, k + columns, 0.8, dark, 1.5);
          }
        }
        return things;
      }
      const [width, lift] = part.shape === "curve" ? [2.4, 12] : [1.3, 6];
      for (const [a, b] of segments(part, screen.length)) segment(a, b, width, css(part.colour), lift);
      if (part.shape !== "curve") {
        for (const [x, y, near] of screen) {
          things.push({
            near: near + 14,
            paint: (pen) => {
              pen.fillStyle = css(part.colour);
              pen.beginPath();
              pen.arc(x, y, 3.4, 0, 7);
              pen.fill();
            },
          });
        }
      }
      return things;
    }

    // Lit from above the reader's left shoulder; the back is paler than the front.
    quadrangle(part, corners) {
      const [p, q, r, s] = corners;
      const u = [r[0] - p[0], p[1] - r[1], r[2] - p[2]], v = [s[0] - q[0], q[1] - s[1], s[2] - q[2]];
      const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
      const length = Math.hypot(...normal) || 1, front = normal[2] <= 0;
      const facing = Math.abs((-0.35 * normal[0] + 0.45 * normal[1] + 0.82 * normal[2]) / length);
      const base = front ? part.colour : mix(part.colour, [205, 205, 205], 0.6);
      const lit = facing < 0.7 ? mix(mix(base, [0, 0, 0], 0.55), base, facing / 0.7) : mix(base, [255, 255, 255], (facing - 0.7) * 0.9);
      const colour = css(lit);
      return {
        near: (p[2] + q[2] + r[2] + s[2]) / 4,
        paint: (pen) => {
          pen.fillStyle = pen.strokeStyle = colour;
          pen.lineWidth = 0.7;
          pen.beginPath();
          corners.forEach(([x, y], k) => (k ? pen.lineTo(x, y) : pen.moveTo(x, y)));
          pen.closePath();
          pen.fill();
          pen.stroke();
        },
      };
    }

    // Axes of the plane with a few round numbers, or three short arrows in space.
    axes(pen, ink) {
      const { low, high } = this.box, { width, height } = this;
      pen.strokeStyle = pen.fillStyle = ink;
      pen.lineWidth = 1;
      pen.font = "12px system-ui, sans-serif";
      if (this.data.dimension === 3) {
        const [cy, sy, cp, sp] = [Math.cos(this.yaw), Math.sin(this.yaw), Math.cos(this.pitch), Math.sin(this.pitch)];
        const ends = { x: [cy, sy * sp], y: [sy, -cy * sp], z: [0, -cp] };
        for (const [name, [right, down]] of Object.entries(ends)) {
          pen.beginPath();
          pen.moveTo(MARGIN, height - MARGIN);
          pen.lineTo(MARGIN + 22 * right, height - MARGIN + 22 * down);
          pen.stroke();
          pen.fillText(name, MARGIN + 29 * right - 3, height - MARGIN + 29 * down + 4);
        }
        return;
      }
      const [sx, sy] = this.scale, middle = low.map((value, k) => (value + high[k]) / 2);
      const span = [width / sx, height / sy];
      span.forEach((length, axis) => {
        const step = 10 ** Math.floor(Math.log10(length / 3));
        const unit = [1, 2, 5, 10].map((factor) => factor * step).find((one) => length / one <= 6) || step;
        for (let k = Math.ceil((middle[axis] - length / 2) / unit); k * unit <= middle[axis] + length / 2; k += 1) {
          const value = k * unit, label = String(Number(value.toPrecision(6)));
          pen.globalAlpha = 0.18;
          pen.beginPath();
          if (axis === 0) {
            const x = width / 2 + (value - middle[0]) * sx;
            pen.moveTo(x, 0);
            pen.lineTo(x, height);
            pen.stroke();
            pen.globalAlpha = 1;
            pen.fillText(label, x + 3, height - 5);
          } else {
            const y = height / 2 - (value - middle[1]) * sy;
            pen.moveTo(0, y);
            pen.lineTo(width, y);
            pen.stroke();
            pen.globalAlpha = 1;
            pen.fillText(label, 4, y - 3);
          }
        }
      });
    }

    draw() {
      const { canvas } = this, density = devicePixelRatio || 1;
      this.width = canvas.clientWidth;
      this.height = canvas.clientHeight;
      if (!this.width) return;
      this.showValues();
      canvas.width = Math.round(this.width * density);
      canvas.height = Math.round(this.height * density);
      const pen = canvas.getContext("2d");
      pen.scale(density, density);
      pen.lineJoin = pen.lineCap = "round";
      const things = this.data.parts.flatMap((part) => this.things(part));
      if (this.data.dimension === 3) things.sort((a, b) => a.near - b.near);
      this.axes(pen, getComputedStyle(canvas).color);
      for (const thing of things) thing.paint(pen);
    }
  }

  document.addEventListener("toggle", ({ target }) => {
    if (target.open && target.matches("details.moving:not(.torse)") && !target.querySelector("canvas")) new Moving(target);
  }, true);
})();
