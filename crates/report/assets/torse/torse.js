// A developable with sliders: the sheet in space, its pattern beside, lengths, and files of both.
(() => {
  const TURN = 4, ZOOM = 1.1;
  const make = (tag, properties = {}, ...children) => {
    const element = Object.assign(document.createElement(tag), properties);
    element.append(...children);
    return element;
  };
  const shown = (value, digits = 4) => stage.shown(Number(value.toPrecision(digits)));

  class Torse {
    constructor(details) {
      this.name = details.dataset.name;
      this.step = details.dataset.step;
      this.title = details.dataset.alt;
      this.data = JSON.parse(details.querySelector("script").textContent);
      this.values = this.data.sliders.map(({ start }) => start);
      this.camera = this.firstCamera();
      const canvas = (label) => make("canvas", { tabIndex: 0, role: "img", ariaLabel: label });
      this.space = canvas(`${this.title} In space, with sliders; arrow keys turn it.`);
      this.sheet = canvas("The same sheet unrolled into the plane.");
      this.space.classList.add("turns");
      this.readout = make("p", { className: "readout" });
      this.readout.setAttribute("aria-live", "polite");
      details.append(make("div", { className: "panes" }, this.space, this.sheet), this.legend(), this.controls(), this.readout);
      this.listen();
      new ResizeObserver(() => this.draw()).observe(this.space);
      this.move();
    }

    firstCamera() {
      const [azimuth, elevation] = this.data.view;
      return { azimuth, elevation, zoom: 1 };
    }

    // The pieces with their rulings at other values of the sliders: of no effect on what is shown.
    state(values = this.values) { return scene.state(this.data, values); }

    // The flat image of the point at this share of a ruling.
    flat(station, share) {
      const [first, last] = station.spans;
      return develop.flat(station, first + (last - first) * share);
    }

    legend() {
      const entry = (colour, label) => {
        const swatch = make("i", { className: "swatch" });
        swatch.style.background = scene.css(colour);
        const text = make("span", { innerHTML: label });
        text.prepend(swatch);
        return text;
      };
      const { first, last, edge } = scene.MARKS;
      const pieces = this.data.pieces.filter(({ label }) => label).map(({ colour, label }) => entry(colour, label));
      this.live = make("span", { className: "live" });
      this.edge = entry(edge, "edge of regression");
      return make("p", { className: "legend" }, this.live, ...pieces, entry(first, "first ruling"), entry(last, "last ruling"), this.edge);
    }

    controls() {
      const box = make("div", { className: "sliders" });
      this.inputs = this.data.sliders.map((slider, k) => {
        const input = make("input", { type: "range", min: slider.least, max: slider.greatest, step: "any", value: slider.start });
        const output = make("output"), show = () => { output.textContent = shown(this.values[k], 3); };
        input.addEventListener("input", () => { this.values[k] = Number(input.value); show(); this.move(); });
        show();
        box.append(make("label", {}, make("span", { innerHTML: slider.label }), input, output));
        return { input, start: slider.start, show };
      });
      const button = (label, act) => {
        const made = make("button", { type: "button", textContent: label });
        made.addEventListener("click", act);
        return made;
      };
      // The library wrote a file of the state that the page opens with; it lies beside the page.
      const { step } = this;
      const file = step ? [make("a", { href: step, download: "", textContent: "STEP (initial shape)" })] : [];
      box.append(make("div", { className: "buttons" },
        button("Reset", () => this.reset()),
        button("SVG", () => save.give(`${this.name}.svg`, "image/svg+xml", this.svg())),
        button("DXF of the sheet", () => save.give(`${this.name}.dxf`, "image/vnd.dxf", save.dxf(this.pieces))), ...file));
      return box;
    }

    reset() {
      this.camera = this.firstCamera();
      this.boxes = null;
      this.inputs.forEach(({ input, start, show }, k) => { input.value = start; this.values[k] = start; show(); });
      this.move();
    }

    listen() {
      const turn = (across, up) => {
        this.camera.azimuth -= across;
        this.camera.elevation = Math.max(-90, Math.min(90, this.camera.elevation + up));
        this.draw();
      };
      let held = null;
      this.space.addEventListener("pointerdown", (event) => { held = event; this.space.setPointerCapture(event.pointerId); });
      this.space.addEventListener("pointermove", (event) => {
        if (!held) return;
        turn((event.clientX - held.clientX) * 0.5, (event.clientY - held.clientY) * 0.5);
        held = event;
      });
      for (const end of ["pointerup", "pointercancel"]) this.space.addEventListener(end, () => { held = null; });
      for (const canvas of [this.space, this.sheet]) {
        canvas.addEventListener("keydown", (event) => {
          const turns = { ArrowLeft: [-TURN, 0], ArrowRight: [TURN, 0], ArrowUp: [0, -TURN], ArrowDown: [0, TURN] };
          const scales = { "+": ZOOM, "=": ZOOM, "-": 1 / ZOOM };
          if (event.key in turns) turn(...turns[event.key]);
          else if (event.key in scales) { this.camera.zoom *= scales[event.key]; this.draw(); }
          else if (event.key === "Home") this.reset();
          else return;
          event.preventDefault();
        });
      }
    }

    // Other values: the rulings are worked out anew, and the frame fits them.
    move() {
      this.whole = this.state();
      this.pieces = scene.seen(this.whole);
      const points = scene.pointsOf(this.pieces), flat = scene.flatOf(this.pieces);
      if (points.length) {
        const boxes = [scene.boxOf(points), scene.boxOf(flat)];
        this.boxes = boxes.map((box, k) => scene.refitted(this.boxes && this.boxes[k], box));
      }
      this.tell();
      this.draw();
    }

    // What can be measured: lengths of the end rulings, and whether the sheet can be made.
    tell() {
      this.live.innerHTML = this.data.sliders.map(({ label }, k) => `${label} = ${shown(this.values[k], 3)}`).join(", ");
      this.edge.hidden = this.pieces.every(({ shown: near }) => !near.length);
      const several = this.pieces.length > 1;
      this.readout.textContent = this.whole.map(({ stations, crossed, limit }, k) => {
        const length = ({ spans }) => shown(Math.abs(spans[1] - spans[0]));
        const cut = limit && stations.some(({ spans }) => spans.some((span) => Math.abs(span) > limit));
        const name = several ? `${["First", "Second", "Third"][k] || k + 1} piece: first` : "First";
        return `${name} ruling ${length(stations[0])} long, last ruling ${length(stations[stations.length - 1])} long${crossed ? "; the edge of regression lies in the sheet" : ""}${cut ? `; shown to ${shown(limit)} from the middle` : ""}.`;
      }).join(" ");
    }

    paint(space, flat, ink) {
      if (!this.boxes) return;
      scene.drawSpace(space, this.pieces, this.camera, this.boxes[0], ink);
      scene.drawFlat(flat, this.pieces, this.boxes[1], ink, this.camera.zoom);
    }

    draw() {
      if (!this.space.clientWidth) return;
      const [red, green, blue] = getComputedStyle(this.space).color.match(/[\d.]+/g);
      this.paint(pens.canvasPen(this.space), pens.canvasPen(this.sheet), (alpha) => `rgb(${red} ${green} ${blue} / ${alpha})`);
    }

    svg() {
      const panes = [this.space, this.sheet].map((canvas) => pens.svgPen(canvas.clientWidth, canvas.clientHeight));
      // On white paper, without transparency, which not every program reads.
      const ink = (alpha) => scene.css([28, 28, 30].map((c) => Math.round(255 + (c - 255) * alpha)));
      this.paint(...panes, ink);
      return save.svg(this.title, panes);
    }
  }

  document.addEventListener("toggle", ({ target }) => {
    if (target.open && target.matches("details.torse") && !target.torse) target.torse = new Torse(target);
  }, true);
  const theme = document.getElementById("theme");
  if (theme) theme.addEventListener("click", () => { for (const details of document.querySelectorAll("details.torse")) if (details.torse) details.torse.draw(); });
})();
