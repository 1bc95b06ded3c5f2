// What is seen of a developable: the sheet in space, painted from far to near, and its flat pattern.
const scene = (() => {
  // Strips of a piece along the sheet and cells along a ruling; every so many strips a ruling is drawn.
  const STRIPS = 72, CELLS = 6, EVERY = 6;
  // Colours of the first and the last ruling and of the edge of regression.
  const MARKS = { first: [201, 135, 0], last: [180, 80, 140], edge: [213, 94, 0] };
  const MARGIN = 46;

  const css = (colour) => `rgb(${colour.join(",")})`;
  const finite = (point) => point.every(Number.isFinite);
  const between = ([p, q], share) => p.map((c, k) => c + (q[k] - c) * share);
  const far = ([a, b]) => Math.hypot(...ruling.minus(b, a));

  // The pieces at these values of the sliders, each with its rulings, unrolled one after the other.
  function state(data, values) {
    let before = null;
    return data.pieces.map((piece) => {
      const stations = develop.developed(ruling.settled(piece, values), STRIPS, before);
      before = stations[stations.length - 1];
      return { ...piece, stations, ...edgeOf(stations) };
    });
  }

  // The pieces as they are shown: rulings to their limit.
  const seen = (pieces) => pieces.map((piece) => {
    if (!piece.limit) return piece;
    const near = (span) => Math.max(-piece.limit, Math.min(piece.limit, span));
    const stations = piece.stations.map((station) => {
      const spans = station.spans.map(near);
      return { ...station, spans, ends: spans.map((span) => ruling.plus(station.base, ruling.scaled(station.direction, span))) };
    });
    return { ...piece, stations, ...edgeOf(stations) };
  });

  // The first ruling of the first piece and the last one of the last piece are marked; joints are not.
  const mark = (pieces, piece, k) => {
    if (k === 0 && piece === pieces[0]) return css(MARKS.first);
    return k === piece.stations.length - 1 && piece === pieces[pieces.length - 1] ? css(MARKS.last) : null;
  };

  // Where the edge of regression is near enough to be shown: within twice the length of a ruling of the sheet. It is one
  // point, the summit, for a cone.
  function edgeOf(stations) {
    const lengths = stations.map(({ spans }) => Math.abs(spans[1] - spans[0])).filter(Number.isFinite).sort((a, b) => a - b);
    const usual = lengths[lengths.length >> 1] || 0;
    const away = ({ spans, reach }) => Math.max(Math.min(...spans) - reach, reach - Math.max(...spans));
    const shown = stations.filter((station) => finite(station.edge) && away(station) <= 2 * usual);
    const spread = shown.reduce((most, { edge }) => Math.max(most, far([edge, shown[0].edge])), 0);
    return { shown, summit: shown.length === stations.length && spread < 1e-6 * usual, crossed: stations.some((one) => finite(one.edge) && away(one) < 0) };
  }

  // The box around all that is shown, with some air; sides that have no extent get some.
  function boxOf(points) {
    const sides = points[0].map((_, k) => [Math.min(...points.map((p) => p[k])), Math.max(...points.map((p) => p[k]))]);
    const longest = Math.max(...sides.map(([low, high]) => high - low)) || 1;
    return sides.map(([low, high]) => {
      const air = Math.max(0.02 * longest, (0.12 * longest - (high - low)) / 2);
      return [low - air, high + air];
    });
  }

  const pointsOf = (pieces) => pieces.flatMap(({ stations, shown }) => [...stations.flatMap(({ ends }) => ends), ...shown.map(({ edge }) => edge)]).filter(finite);
  const flatOf = (pieces) => pieces.flatMap(({ stations, shown }) => [
    ...stations.flatMap((one) => one.spans.map((span) => develop.flat(one, span))), ...shown.map((one) => develop.flat(one, one.reach)),
  ]).filter(finite);

  // A box that was kept serves as long as it is neither left nor much too large: the picture then does not tremble.
  function refitted(kept, box) {
    const inside = kept && box.every(([low, high], k) => low >= kept[k][0] && high <= kept[k][1]);
    const large = inside && Math.max(...box.map(([low, high], k) => (high - low) / (kept[k][1] - kept[k][0]))) < 0.6;
    return inside && !large ? kept : box;
  }

  function drawSpace(pen, pieces, camera, box, ink) {
    const view = stage.fitted(camera, box, pen.width, pen.height, MARGIN);
    const marks = stage.walls(pen, view, box, ink);
    const things = [];
    const add = (lift, points, paint) => {
      const placed = points.map(view.place);
      if (placed.every(finite)) things.push({ near: placed.reduce((sum, p) => sum + p[2], 0) / placed.length + lift, paint: () => paint(placed) });
    };
    const line = (lift, points, colour, thick, dash) => add(lift, points, (placed) => pen.line(placed, colour, thick, dash));
    for (const piece of pieces) {
      const { stations, shown, summit } = piece, last = stations.length - 1, dark = css(piece.colour.map((c) => Math.round(0.42 * c)));
      for (let k = 0; k <= last; k += 1) {
        const here = stations[k], next = stations[k + 1];
        const end = mark(pieces, piece, k);
        for (let j = 0; j < CELLS; j += 1) {
          const [a, b] = [j / CELLS, (j + 1) / CELLS];
          if (next) {
            const normal = ruling.unit(ruling.plus(here.normal, next.normal)), seen = view.axes.map((axis) => ruling.dot(axis, normal));
            const colour = stage.lit(piece.colour, seen);
            add(0, [between(here.ends, a), between(next.ends, a), between(next.ends, b), between(here.ends, b)], (placed) => pen.face(placed, colour, 0.8));
          }
          if (end) line(3, [between(here.ends, a), between(here.ends, b)], end, 3);
          else if (k % EVERY === 0) line(1.5, [between(here.ends, a), between(here.ends, b)], dark, k % last ? 0.7 : 1.4);
        }
        if (next) for (const side of [0, 1]) line(1.5, [here.ends[side], next.ends[side]], dark, 1.1);
        if (summit && k % EVERY === 0) line(0, [here.edge, here.ends[Math.abs(here.reach - here.spans[0]) < Math.abs(here.reach - here.spans[1]) ? 0 : 1]], ink(0.5), 0.7);
      }
      if (summit) add(4, [shown[0].edge], ([p]) => pen.dot(p, css(MARKS.edge), 4));
      else for (const chain of chains(shown, stations)) for (let k = 0; k + 1 < chain.length; k += 1) line(3, [chain[k].edge, chain[k + 1].edge], css(MARKS.edge), 2.2);
    }
    things.sort((a, b) => a.near - b.near);
    for (const thing of things) thing.paint();
    stage.rulers(pen, view, box, marks, ink);
  }

  // Runs of stations that follow each other.
  function chains(shown, stations) {
    const runs = [], kept = new Set(shown);
    let run = [];
    for (const station of stations) {
      if (kept.has(station)) run.push(station);
      else if (run.length) { runs.push(run); run = []; }
    }
    if (run.length) runs.push(run);
    return runs;
  }

  function drawFlat(pen, pieces, box, ink, zoom) {
    const size = box.map(([low, high]) => high - low), middle = box.map(([low, high]) => (low + high) / 2);
    const scale = zoom * Math.min((pen.width - 1.6 * MARGIN) / size[0], (pen.height - 1.6 * MARGIN) / size[1]);
    const place = ([x, y]) => [pen.width / 2 + MARGIN / 4 + scale * (x - middle[0]), pen.height / 2 - MARGIN / 4 - scale * (y - middle[1])];
    [0, 1].forEach((axis) => {
      const room = (axis ? pen.height : pen.width) / scale / 2;
      for (const value of stage.ticks(middle[axis] - room, middle[axis] + room, 6)) {
        const at = axis ? place([0, value])[1] : place([value, 0])[0];
        pen.line(axis ? [[0, at], [pen.width, at]] : [[at, 0], [at, pen.height]], ink(0.12), 0.7);
        if (axis) pen.text([4, at - 7], stage.shown(value), ink(0.75), "left");
        else pen.text([at + 3, pen.height - 9], stage.shown(value), ink(0.75), "left");
      }
    });
    for (const piece of pieces) {
      const { colour, stations, shown, summit } = piece, last = stations.length - 1, flat = (station, share) => place(develop.flat(station, between(station.spans.map((span) => [span]), share)[0]));
      const pale = css(colour.map((c) => Math.round(c + (238 - c) * 0.62))), dark = css(colour.map((c) => Math.round(0.5 * c)));
      for (let k = 0; k < last; k += 1) {
        for (let j = 0; j < CELLS; j += 1) {
          const [a, b] = [j / CELLS, (j + 1) / CELLS];
          const cell = [flat(stations[k], a), flat(stations[k + 1], a), flat(stations[k + 1], b), flat(stations[k], b)];
          if (cell.every(finite)) pen.face(cell, pale, 0.8);
        }
      }
      const straight = (station, ink1, thick) => {
        const ends = [flat(station, 0), flat(station, 1)];
        if (ends.every(finite)) pen.line(ends, ink1, thick);
      };
      stations.forEach((station, k) => { if (k % EVERY === 0 && k && k < last) straight(station, dark, 0.6); });
      for (const share of [0, 1]) pen.line(stations.map((station) => flat(station, share)).filter(finite), dark, 1.4);
      for (const k of [0, last]) straight(stations[k], mark(pieces, piece, k) || dark, mark(pieces, piece, k) ? 3 : 1.4);
      if (summit) pen.dot(place(develop.flat(shown[0], shown[0].reach)), css(MARKS.edge), 4);
      else for (const chain of chains(shown, stations)) pen.line(chain.map((one) => place(develop.flat(one, one.reach))).filter(finite), css(MARKS.edge), 2.2);
    }
  }

  return { state, seen, boxOf, pointsOf, flatOf, refitted, drawSpace, drawFlat, MARKS, css };
})();
