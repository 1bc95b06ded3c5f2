// Truncated Taylor series in one variable: arrays [f, f', f''/2, ...]. What two series do not both know is dropped,
// so a series grows shorter with each derivative and never pretends to know more than it does.
const series = (() => {
  const both = (a, b, of) => Array.from({ length: Math.min(a.length, b.length) }, (_, k) => of(k));

  const constant = (value, length) => Array.from({ length }, (_, k) => (k === 0 ? value : 0));
  const plus = (a, b) => both(a, b, (k) => a[k] + b[k]);
  const minus = (a, b) => both(a, b, (k) => a[k] - b[k]);
  const times = (a, b) => both(a, b, (k) => {
    let sum = 0;
    for (let j = 0; j <= k; j += 1) sum += a[j] * b[k - j];
    return sum;
  });
  const over = (a, b) => {
    const quotient = [];
    for (let k = 0; k < Math.min(a.length, b.length); k += 1) {
      let rest = a[k];
      for (let j = 1; j <= k; j += 1) rest -= b[j] * quotient[k - j];
      quotient.push(rest / b[0]);
    }
    return quotient;
  };
  const scaled = (a, factor) => a.map((value) => value * factor);
  const derivative = (a) => a.slice(1).map((value, k) => value * (k + 1));

  // The same for vectors, which are lists of series.
  const dot = (u, v) => u.map((a, k) => times(a, v[k])).reduce(plus);
  const cross = (u, v) => [0, 1, 2].map((k) => {
    const [i, j] = [(k + 1) % 3, (k + 2) % 3];
    return minus(times(u[i], v[j]), times(u[j], v[i]));
  });
  const vector = {
    plus: (u, v) => u.map((a, k) => plus(a, v[k])),
    minus: (u, v) => u.map((a, k) => minus(a, v[k])),
    times: (u, factor) => u.map((a) => times(a, factor)),
    over: (u, divisor) => u.map((a) => over(a, divisor)),
    scaled: (u, factor) => u.map((a) => scaled(a, factor)),
    derivative: (u) => u.map(derivative),
    // The numbers at the point, and their first derivatives.
    value: (u) => u.map((a) => a[0]),
    slope: (u) => u.map((a) => a[1]),
  };
  return { constant, plus, minus, times, over, scaled, derivative, dot, cross, vector };
})();
