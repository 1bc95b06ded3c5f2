// The rulings of a developable: where each starts and ends, how the next one turns from it, and where both meet.
const ruling = (() => {
  const { vector } = series;
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const scaled = (a, factor) => a.map((value) => value * factor);
  const plus = (a, b) => a.map((value, k) => value + b[k]);
  const minus = (a, b) => a.map((value, k) => value - b[k]);
  const unit = (a) => scaled(a, 1 / Math.hypot(...a));

  // Planes p X + q Y + r Z = s and the lines and points in which neighbours meet.
  const line = (plane, slope) => {
    const [n, m] = [plane.slice(0, 3), slope.slice(0, 3)];
    const direction = series.cross(n, m);
    const moment = vector.minus(vector.times(n, slope[3]), vector.times(m, plane[3]));
    return { direction, foot: vector.over(series.cross(direction, moment), series.dot(direction, direction)) };
  };
  const meet = (h0, h1, h2) => {
    const [a, b, c] = [h0, h1, h2].map((plane) => plane.slice(0, 3));
    const bc = series.cross(b, c);
    const top = vector.plus(vector.plus(vector.times(bc, h0[3]), vector.times(series.cross(c, a), h1[3])), vector.times(series.cross(a, b), h2[3]));
    return vector.over(top, series.dot(a, bc));
  };

  // How many terms of the series of planes or points each kind needs, so that the slope of its base is known.
  const TERMS = { envelope: 3, tangent: 4, ruled: 2 };

  // How each kind of piece has its rulings: a curve `base` that crosses them, their direction, two ends, a normal.
  const KINDS = {
    // The planes envelop it; ends at multiples of the direction from the foot.
    envelope: ([plane], along) => {
      const { direction, foot } = line(plane, vector.derivative(plane));
      const ends = along.map((x1) => vector.plus(foot, vector.scaled(direction, x1)));
      return { base: foot, direction, ends, normal: vector.value(plane.slice(0, 3)) };
    },
    // The same surface from its edge of regression S; ends at multiples of S'. The direction is that of the planes,
    // which does not vanish where S has a cusp.
    tangent: ([plane], along) => {
      const slope = vector.derivative(plane);
      const base = meet(plane, slope, vector.derivative(slope)), speed = vector.derivative(base);
      const ends = along.map((x2) => vector.plus(base, vector.scaled(speed, x2)));
      return { base, direction: line(plane, slope).direction, ends, normal: vector.value(plane.slice(0, 3)) };
    },
    // Between two curves; ends at shares of the way from the first to the second.
    ruled: ([first, second], along) => {
      const direction = vector.minus(second, first);
      const ends = along.map((share) => vector.plus(first, vector.scaled(direction, share)));
      const normal = cross(vector.value(direction), plus(vector.slope(first), vector.slope(second)));
      return { base: first, direction, ends, normal };
    },
  };

  // A piece with values put in for the sliders. Each of its curves is a list of formulas: three of a point, four of a plane.
  const settled = (piece, values) => ({
    ...piece, settled: piece.curves.map((curve) => curve.map((one) => formula.settled(one, values))),
  });

  function at(piece, x) {
    const place = formula.place(x, TERMS[piece.kind]);
    const curves = piece.settled.map((curve) => curve.map((one) => formula.value(one, place)));
    const { base, direction, ends, normal } = KINDS[piece.kind](curves, piece.along);
    const [b, d, slope] = [vector.value(base), vector.value(direction), vector.slope(base)];
    const r = unit(d), n = unit(normal), t = cross(n, r);
    const points = ends.map(vector.value);
    const turning = dot(vector.slope(direction), t) / Math.hypot(...d), across = dot(slope, t);
    const reach = -across / turning;
    return {
      x, base: b, direction: r, normal: n, ends: points,
      // Along the ruling, from the base: the ends, and the edge of regression.
      spans: points.map((point) => dot(minus(point, b), r)), reach,
      edge: plus(b, scaled(r, reach)),
      // How the ruling moves in the tangent plane as x grows: it turns, glides along itself and goes across.
      turning, along: dot(slope, r), across,
    };
  }

  return { settled, at, dot, cross, plus, minus, scaled, unit };
})();
