// Unrolling. In the plane a ruling turns, glides and goes across just as it does in the tangent plane of the sheet, so
// its angle and the place of its base point are integrals. Lobatto's rule of order six, as the Runge-Kutta method Lobatto
// IIIA (Hairer, Wanner, Solving ODEs II, IV.5), shares its outer nodes with the rulings that are drawn.
const develop = (() => {
  const R = Math.sqrt(5);
  const INNER = [0.5 - R / 10, 0.5 + R / 10];
  const WITHIN = [
    [0, 0, 0, 0],
    [11 + R, 25 - R, 25 - 13 * R, R - 1].map((part) => part / 120),
    [11 - R, 25 + 13 * R, 25 + R, -R - 1].map((part) => part / 120),
    [1 / 12, 5 / 12, 5 / 12, 1 / 12],
  ];
  const WEIGHTS = WITHIN[3];
  const sum = (weights, of) => weights.reduce((total, weight, k) => total + weight * of(k), 0);

  // The rulings at `count + 1` equal steps with their flat images: `angle` and `place` of the base point. With the last
  // ruling of the piece before, the first one is laid on it.
  function developed(piece, count, before) {
    const [low, high] = piece.over, step = (high - low) / count;
    const stations = Array.from({ length: count + 1 }, (_, k) => ruling.at(piece, low + k * step));
    let { angle, place, side } = start(stations, before);
    stations.forEach((station, k) => {
      Object.assign(station, { angle, place, side });
      if (k === count) return;
      const nodes = [station, ...INNER.map((node) => ruling.at(piece, station.x + node * step)), stations[k + 1]];
      const angles = WITHIN.map((row) => angle + side * step * sum(row, (j) => nodes[j].turning));
      const glide = (axis) => step * sum(WEIGHTS, (j) => {
        const [c, s] = [Math.cos(angles[j]), Math.sin(angles[j])];
        return axis === 0 ? nodes[j].along * c - side * nodes[j].across * s : nodes[j].along * s + side * nodes[j].across * c;
      });
      place = [place[0] + glide(0), place[1] + glide(1)];
      angle += side * step * sum(WEIGHTS, (j) => nodes[j].turning);
    });
    return stations;
  }

  // The first ruling lies along the first axis and the sheet goes on above it. That of a second piece lies on the last one
  // of the first, turned about if its direction is the opposite one, and is seen from the same side.
  function start([first, next], before) {
    if (!before) {
      const middle = ({ ends: [p, q] }) => ruling.scaled(ruling.plus(p, q), 0.5);
      const above = ruling.dot(ruling.minus(middle(next), middle(first)), ruling.cross(first.normal, first.direction));
      return { angle: 0, place: [0, 0], side: above < 0 ? -1 : 1 };
    }
    const sign = Math.sign(ruling.dot(first.direction, before.direction)) || 1;
    const side = before.side * (Math.sign(ruling.dot(first.normal, before.normal)) || 1);
    const shift = ruling.dot(ruling.minus(first.base, before.base), before.direction);
    return { angle: sign > 0 ? before.angle : before.angle + Math.PI, place: flat(before, shift), side };
  }

  // The flat image of the point at distance `span` from the base of a ruling.
  const flat = ({ place, angle }, span) => [place[0] + span * Math.cos(angle), place[1] + span * Math.sin(angle)];

  return { developed, flat };
})();
