// Figures with sliders. A part's points are sums over monomials of slider values times nets, so no formula of any
// basis is needed here. Surfaces are drawn by the painter's algorithm: quadrangles, far ones first, on the stage that the
// developables have: light, walls and ticks are the same.
(() => {
  const MARGIN = 46;

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
      this.camera = this.firstCamera();
      this.canvas = document.createElement("canvas");
      this.canvas.tabIndex = 0;
      this.canvas.setAttribute("role", "img");
      this.canvas.setAttribute("aria-label", `${details.dataset.alt} With sliders; arrow keys turn it.`);
      details.append(this.canvas, this.legend(), this.controls());
      this.listen();
      new ResizeObserver(() => this.draw()).observe(this.canvas);
      this.draw();
    }

    firstCamera() {
      const [azimuth, elevation] = this.data.view;
      return { azimuth, elevation, zoom: 1 };
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
      button.textContent = "Reset";
      button.addEventListener("click", () => this.reset());
      box.append(button);
      return box;
    }

    reset() {
      this.camera = this.firstCamera();
      this.inputs.forEach(({ input, start, show }, k) => { input.value = start; this.values[k] = start; show(); });
      this.draw();
    }

    listen() {
      const { canvas } = this;
      const turn = (across, up) => {
        this.camera.azimuth -= across;
        this.camera.elevation = Math.max(-90, Math.min(90, this.camera.elevation + up));
        this.draw();
      };
      let held = null;
      if (this.data.dimension === 3) {
        canvas.classList.add("turns");
        canvas.addEventListener("pointerdown", (event) => { held = event; canvas.setPointerCapture(event.pointerId); });
        canvas.addEventListener("pointermove", (event) => {
          if (!held) return;
          turn((event.clientX - held.clientX) * 0.5, (event.clientY - held.clientY) * 0.5);
          held = event;
        });
        for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => { held = null; });
      }
      canvas.addEventListener("keydown", (event) => {
        const turns = { ArrowLeft: [-6, 0], ArrowRight: [6, 0], ArrowUp: [0, -6], ArrowDown: [0, 6] };
        const scales = { "+": 1.1, "=": 1.1, "-": 1 / 1.1 };
        if (event.key in turns && this.data.dimension === 3) turn(...turns[event.key]);
        else if (event.key in scales) { this.camera.zoom *= scales[event.key]; this.draw(); }
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
        let scale = room.map((length, k) => this.camera.zoom * length / (size[k] || 1));
        const longest = Math.max(...size), shortest = Math.min(...size);
        if (longest < 6 * shortest) scale = scale.fill(Math.min(...scale));
        this.scale = scale;
        for (let k = 0; k < points.length; k += 2) {
          screen.push([width / 2 + (points[k] - middle[0]) * scale[0], height / 2 - (points[k + 1] - middle[1]) * scale[1], 0]);
        }
        return screen;
      }
      for (let k = 0; k < points.length; k += 3) screen.push(this.view.place(points.slice(k, k + 3)));
      return screen;
    }

    // What a part is drawn with: things to paint, each with its height towards the eye.
    things(part) {
      const screen = this.project(combine(this.data, part, this.values));
      const things = [];
      const segment = (a, b, width, colour, lift) => things.push({
        near: (screen[a][2] + screen[b][2]) / 2 + lift,
        paint: (pen) => pen.line([screen[a], screen[b]], colour, width),
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
        for (const place of screen) things.push({ near: place[2] + 14, paint: (pen) => pen.dot(place, css(part.colour), 3.4) });
      }
      return things;
    }

    // The normal of the projected corners, right, up and towards the viewer; the back is paler than the front.
    quadrangle(part, corners) {
      const [p, q, r, s] = corners;
      const u = [r[0] - p[0], p[1] - r[1], r[2] - p[2]], v = [s[0] - q[0], q[1] - s[1], s[2] - q[2]];
      const normal = ruling.cross(u, v), size = Math.hypot(...normal) || 1;
      const colour = stage.lit(part.colour, normal.map((c) => -c / size));
      return { near: (p[2] + q[2] + r[2] + s[2]) / 4, paint: (pen) => pen.face(corners, colour, 0.8) };
    }

    // Lines of round numbers in the plane.
    grid(pen, ink) {
      const { low, high } = this.box;
      [0, 1].forEach((axis) => {
        const scale = this.scale[axis], middle = (low[axis] + high[axis]) / 2, room = (axis ? pen.height : pen.width) / scale / 2;
        for (const value of stage.ticks(middle - room, middle + room, 6)) {
          const at = axis ? pen.height / 2 - (value - middle) * scale : pen.width / 2 + (value - middle) * scale;
          pen.line(axis ? [[0, at], [pen.width, at]] : [[at, 0], [at, pen.height]], ink(0.18), 1);
          if (axis) pen.text([4, at - 8], stage.shown(value), ink(0.8), "left");
          else pen.text([at + 3, pen.height - 9], stage.shown(value), ink(0.8), "left");
        }
      });
    }

    draw() {
      const { canvas } = this;
      if (!canvas.clientWidth) return;
      this.showValues();
      const pen = pens.canvasPen(canvas), [red, green, blue] = getComputedStyle(canvas).color.match(/[\d.]+/g);
      const ink = (alpha) => `rgb(${red} ${green} ${blue} / ${alpha})`;
      Object.assign(this, { width: pen.width, height: pen.height });
      const sides = this.box.low.map((value, k) => [value, this.box.high[k]]);
      // The projection fits its frame after every turn.
      if (this.data.dimension === 3) this.view = stage.fitted(this.camera, air(sides), pen.width, pen.height, MARGIN);
      const things = this.data.parts.flatMap((part) => this.things(part));
      if (this.data.dimension === 2) {
        this.grid(pen, ink);
        for (const thing of things) thing.paint(pen);
        return;
      }
      const box = air(sides), marks = stage.walls(pen, this.view, box, ink);
      things.sort((a, b) => a.near - b.near);
      for (const thing of things) thing.paint(pen);
      stage.rulers(pen, this.view, box, marks, ink);
    }
  }

  // A box whose flat sides have some extent.
  function air(box) {
    const longest = Math.max(...box.map(([low, high]) => high - low)) || 1;
    return box.map(([low, high]) => {
      const more = Math.max(0.02 * longest, (0.12 * longest - (high - low)) / 2);
      return [low - more, high + more];
    });
  }

  document.addEventListener("toggle", ({ target }) => {
    if (target.open && target.matches("details.moving:not(.torse)") && !target.querySelector("canvas")) new Moving(target);
  }, true);
})();
