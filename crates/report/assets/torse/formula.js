// Formulas as data. A row [c, a, b, d, e, f, ...] is c x^a sin(pi x/2)^b cos(pi x/2)^d sin(x)^e cos(x)^f times powers
// of the sliders; a formula is a sum of rows over powers of sums of rows.
const formula = (() => {
  const ATOMS = 5;

  // The rows with values put in for the sliders: equal monomials in x are then added up.
  function settledRows(rows, values) {
    const sums = new Map();
    for (const row of rows) {
      let coefficient = row[0];
      values.forEach((value, k) => { coefficient *= value ** row[1 + ATOMS + k]; });
      const exponents = row.slice(1, 1 + ATOMS), key = exponents.join();
      const sum = sums.get(key);
      if (sum) sum.coefficient += coefficient;
      else sums.set(key, { key, exponents, coefficient });
    }
    return [...sums.values()];
  }

  const settled = ({ n, d }, values) => ({
    numerator: settledRows(n, values),
    denominator: (d || []).map(([rows, power]) => ({ rows: settledRows(rows, values), power })),
  });

  // The monomials of a place x as series there; each is worked out once.
  function place(x, length) {
    const quarter = Math.PI / 2;
    const turning = (angle, speed, from) => {
      // The derivatives of sine go round in a circle of four.
      const circle = [Math.sin(angle), Math.cos(angle), -Math.sin(angle), -Math.cos(angle)];
      let factor = 1;
      return Array.from({ length }, (_, k) => {
        if (k > 0) factor *= speed / k;
        return factor * circle[(k + from) % 4];
      });
    };
    const atoms = [
      Array.from({ length }, (_, k) => (k === 0 ? x : k === 1 ? 1 : 0)),
      turning(quarter * x, quarter, 0), turning(quarter * x, quarter, 1), turning(x, 1, 0), turning(x, 1, 1),
    ];
    const powers = atoms.map(() => [series.constant(1, length)]);
    const power = (atom, exponent) => {
      const known = powers[atom];
      while (known.length <= exponent) known.push(series.times(known[known.length - 1], atoms[atom]));
      return known[exponent];
    };
    const monomials = new Map();
    const monomial = ({ key, exponents }) => {
      if (!monomials.has(key)) {
        monomials.set(key, exponents.reduce((product, exponent, atom) => (
          exponent ? series.times(product, power(atom, exponent)) : product), series.constant(1, length)));
      }
      return monomials.get(key);
    };
    return { length, monomial };
  }

  const sum = (rows, at) => {
    const total = series.constant(0, at.length);
    for (const row of rows) {
      const monomial = at.monomial(row);
      for (let k = 0; k < total.length; k += 1) total[k] += row.coefficient * monomial[k];
    }
    return total;
  };

  function value({ numerator, denominator }, at) {
    let result = sum(numerator, at);
    for (const { rows, power } of denominator) {
      const divisor = sum(rows, at);
      for (let k = 0; k < power; k += 1) result = series.over(result, divisor);
    }
    return result;
  }

  return { settled, place, value };
})();
