// The view: a parallel projection that fits its frame, light as in the printed figures, rear walls with ticks.
const stage = (() => {
  const RIGHT = 0, UP = 1, TOWARDS = 2;

  // Unit vectors that point right, up and towards the viewer, from angles in degrees.
  function axesOf({ azimuth, elevation }) {
    const [a, e] = [azimuth, elevation].map((degrees) => degrees * Math.PI / 180);
    const [ca, sa, ce, se] = [Math.cos(a), Math.sin(a), Math.cos(e), Math.sin(e)];
    return [[-sa, ca, 0], [-se * ca, -se * sa, ce], [ce * ca, ce * sa, se]];
  }

  const corners = (box) => Array.from({ length: 8 }, (_, n) => box.map((side, k) => side[(n >> k) & 1]));

  // The largest projection that shows the box in a frame with so much margin.
  function fitted(camera, box, width, height, margin) {
    const axes = axesOf(camera);
    const seen = (point) => axes.map((axis) => ruling.dot(axis, point));
    const all = corners(box).map(seen);
    const ends = [RIGHT, UP].map((k) => [Math.min(...all.map((p) => p[k])), Math.max(...all.map((p) => p[k]))]);
    const scale = camera.zoom * Math.min((width - 2 * margin) / (ends[0][1] - ends[0][0]), (height - 2 * margin) / (ends[1][1] - ends[1][0]));
    const middle = ends.map(([low, high]) => (low + high) / 2);
    const place = (point) => {
      const [right, up, towards] = seen(point);
      return [width / 2 + scale * (right - middle[RIGHT]), height / 2 - scale * (up - middle[UP]), scale * towards];
    };
    return { axes, place, scale };
  }

  // Two lamps and a bright sky, fixed to the viewer, on paint with a soft gloss.
  const LAMPS = [{ towards: [-0.48, 0.6, 0.64], strength: 0.62 }, { towards: [0.8, 0, 0.6], strength: 0.16 }];
  const linear = (byte) => (byte <= 10.31475 ? byte / 3294.6 : ((byte / 255 + 0.055) / 1.055) ** 2.4);
  const screen = (light) => {
    const x = Math.min(1, Math.max(0, light));
    return Math.round(255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055));
  };
  const PALE = [0xd9, 0xd2, 0xc5];

  // The colour of a face whose unit normal has these coordinates right, up, towards; paler from behind.
  function lit(colour, normal) {
    const behind = normal[TOWARDS] < 0, n = behind ? normal.map((c) => -c) : normal;
    const paint = colour.map(linear).map((c, k) => (behind ? c + (linear(PALE[k]) - c) * 0.55 : c));
    let light = 0.16 + 0.2 * (0.5 + 0.5 * n[UP]), gloss = 0;
    for (const { towards, strength } of LAMPS) {
      light += strength * Math.max(0, ruling.dot(n, towards));
      const half = ruling.unit([towards[0], towards[1], towards[2] + 1]);
      gloss += strength * Math.max(0, ruling.dot(n, half)) ** 36;
    }
    return `rgb(${paint.map((c) => screen(c * light + 0.1 * gloss)).join(",")})`;
  }

  // Round numbers in an interval, at most so many.
  function ticks(low, high, most) {
    const least = (high - low) / Math.max(1, most), power = 10 ** Math.floor(Math.log10(least));
    const step = [1, 2, 5, 10].map((factor) => factor * power).find((one) => one >= least * (1 - 1e-9));
    const list = [];
    for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k += 1) list.push(Number((k * step).toPrecision(10)));
    return list;
  }

  const shown = (value) => String(value).replace("-", "−");

  // The three rear walls with grid lines.
  function walls(pen, view, box, ink) {
    const far = view.axes[TOWARDS].map((c) => (c > 0 ? 0 : 1));
    const corner = (ends) => view.place(box.map((side, k) => side[ends[k]]));
    const marks = box.map(([low, high], k) => {
      const [a, b] = [low, high].map((value) => view.place(box.map((side, j) => (j === k ? value : side[0]))));
      const most = Math.min(6, Math.hypot(b[0] - a[0], b[1] - a[1]) / 40);
      // One tick alone tells no length.
      return [most, 3, 6].map((count) => ticks(low, high, count)).find((list) => list.length > 1) || [];
    });
    for (let wall = 0; wall < 3; wall += 1) {
      const [i, j] = [(wall + 1) % 3, (wall + 2) % 3];
      const round = [[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]].map(([a, b]) => {
        const ends = [...far];
        [ends[i], ends[j]] = [a, b];
        return corner(ends);
      });
      for (const [along, across] of [[i, j], [j, i]]) {
        for (const value of marks[along]) {
          const ends = [0, 1].map((end) => view.place(box.map((side, k) => (k === along ? value : side[k === across ? end : far[k]]))));
          pen.line(ends, ink(0.14), 0.7);
        }
      }
      pen.line(round, ink(0.32), 0.8);
    }
    return { far, marks };
  }

  // Ticks, labels and titles on the near edges of the walls.
  function rulers(pen, view, box, { far, marks }, ink) {
    const near = far.map((end) => 1 - end), centre = view.place(box.map(([low, high]) => (low + high) / 2));
    const edges = [[0, near[1], far[2]], [near[0], 0, far[2]], [near[0], far[1], 0]];
    const other = [far[0], near[1], 0];
    if (view.place(box.map((side, k) => side[other[k]]))[0] < view.place(box.map((side, k) => side[edges[2][k]]))[0]) edges[2] = other;
    edges.forEach((ends, axis) => {
      const at = (value) => view.place(box.map((side, k) => (k === axis ? value : side[ends[k]])));
      const [a, b] = box[axis].map(at), length = Math.hypot(b[0] - a[0], b[1] - a[1]);
      if (length < 24) return;
      let out = [(a[1] - b[1]) / length, (b[0] - a[0]) / length];
      const middle = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
      if (out[0] * (middle[0] - centre[0]) + out[1] * (middle[1] - centre[1]) < 0) out = out.map((c) => -c);
      const shift = (p, d) => [p[0] + d * out[0], p[1] + d * out[1]];
      pen.line([a, b], ink(0.9), 0.9);
      for (const value of marks[axis]) {
        pen.line([at(value), shift(at(value), 4)], ink(0.9), 0.9);
        pen.text(shift(at(value), 15), shown(value), ink(0.75));
      }
      pen.text(shift(middle, 33), "xyz"[axis], ink(0.95));
    });
  }

  return { axesOf, fitted, lit, ticks, shown, walls, rulers };
})();
