// Unrolling. In the plane a ruling turns, glides and goes across just as it does in the tangent plane of the sheet, so
// its angle and the place of its base point are integrals. Gauss's rule with three nodes, applied as a Runge-Kutta
// method (Hairer, Norsett, Wanner, Solving ODEs I, II.7), has order six.
const develop = (() => {
  const ROOT = Math.sqrt(15);
  const NODES = [0.5 - ROOT / 10, 0.5, 0.5 + ROOT / 10];
  const WITHIN = [
    [5 / 36, 2 / 9 - ROOT / 15, 5 / 36 - ROOT / 30],
    [5 / 36 + ROOT / 24, 2 / 9, 5 / 36 - ROOT / 24],
    [5 / 36 + ROOT / 30, 2 / 9 + ROOT / 15, 5 / 36],
  ];
  const WEIGHTS = [5 / 18, 4 / 9, 5 / 18];
  const sum = (weights, of) => weights.reduce((total, weight, k) => total + weight * of(k), 0);

  // The rulings at `count + 1` equal steps with their flat images: `angle` and `place` of the base point. With the last
  // ruling of the piece before, the first one is laid on it.
  function developed(piece, count, before) {
    const [low, high] = piece.over, step = (high - low) / count;
    const stations = Array.from({ length: count + 1 }, (_, k) => ruling.at(piece, low + k * step));
    let { angle, place, side } = start(stations[0], before);
    stations.forEach((station, k) => {
      Object.assign(station, { angle, place, side });
      if (k === count) return;
      const nodes = NODES.map((node) => ruling.at(piece, station.x + node * step));
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

  // The first ruling lies along the first axis; that of a second piece on the last one of the first, turned about if its
  // direction is the opposite one, and seen from the same side.
  function start(first, before) {
    if (!before) return { angle: 0, place: [0, 0], side: 1 };
    const sign = Math.sign(ruling.dot(first.direction, before.direction)) || 1;
    const side = before.side * (Math.sign(ruling.dot(first.normal, before.normal)) || 1);
    const shift = ruling.dot(ruling.minus(first.base, before.base), before.direction);
    return { angle: sign > 0 ? before.angle : before.angle + Math.PI, place: flat(before, shift), side };
  }

  // The flat image of the point at distance `span` from the base of a ruling.
  const flat = ({ place, angle }, span) => [place[0] + span * Math.cos(angle), place[1] + span * Math.sin(angle)];

  return { developed, flat };
})();
