"""Judges the enclosures: mpmath's values, with many more digits, lie inside.

    python3 tests/judges/enclosures.py < lines    each line is an operation with the intervals of its arguments and its value

`cargo test -p torse-tests --test judges` runs it.
"""

import json
import random
import sys
from fractions import Fraction

import mpmath

# What the crate promises of the width for exact arguments, in units of the last place.
WIDTHS = {"pi": 1, "sum": 0, "difference": 0, "product": 2, "quotient": 1, "root": 1, "sine": 3, "cosine": 3,
          "exponential": 2, "logarithm": 2, "arc tangent": 2, "arc sine": 2, "quarter": 2}


def value(operation, x, y, exponent):
    match operation:
        case "pi":
            return mpmath.pi * 1
        case "sum":
            return x + y
        case "difference":
            return x - y
        case "product":
            return x * y
        case "quotient":
            return x / y
        case "power":
            return x ** exponent
        case "root":
            return mpmath.sqrt(x)
        case "sine":
            return mpmath.sin(x)
        case "cosine":
            return mpmath.cos(x)
        case "exponential":
            return mpmath.exp(x)
        case "logarithm":
            return mpmath.log(x)
        case "arc tangent":
            return mpmath.atan(x)
        case "arc sine":
            return mpmath.asin(x)
        case "quarter":
            return mpmath.sinpi(x / 2)


def number(q):
    return mpmath.mpf(q.numerator) / q.denominator


def complaint(line, stream):
    """What is wrong with a line."""
    operation, bits = line["operation"], line["bits"]
    if line["value"] is None:
        # Refused: only what has no value somewhere, or is too large to be written.
        (a, b), (c, d) = [[Fraction(t) for t in pair] for pair in line["arguments"]]
        fine = {"quotient": c <= 0 <= d, "root": a < 0, "exponential": b > 2 ** 14, "logarithm": a <= 0,
                "arc sine": a < -1 or b > 1}.get(operation, False)
        return None if fine else "refused without need"
    low, high = map(Fraction, line["value"])
    if line["exact"] and operation in WIDTHS and (high - low) * 2 ** bits > WIDTHS[operation]:
        return "wider than promised"
    size = max(abs(Fraction(t)) for pair in line["arguments"] for t in pair)
    large = min(size, 2 ** 14) if operation == "exponential" and Fraction(line["arguments"][0][1]) > 0 else 0
    wanted = 2 * bits + 200 + int(2 * large)
    # A few precisions only: constants are worked out once for each.
    mpmath.mp.prec = 2 ** wanted.bit_length()
    error = Fraction(1, 2 ** (bits + 60))
    pairs = [[Fraction(t) for t in pair] for pair in line["arguments"]]
    for round in range(4):
        x, y = (low_end if round == 0 else high_end if round == 1 else
                low_end + (high_end - low_end) * Fraction(stream.randint(0, 1000), 1000) for low_end, high_end in pairs)
        if operation == "quotient" and y == 0 or operation == "root" and x < 0 or operation == "logarithm" and x <= 0 \
                or operation == "arc sine" and abs(x) > 1:
            return "it has no value"
        sign, mantissa, exponent, _ = value(operation, number(x), number(y), line["exponent"])._mpf_
        found = (-1) ** sign * Fraction(int(mantissa)) * Fraction(2) ** exponent
        if not low - error <= found <= high + error:
            return f"{float(found)} at {float(x)}, {float(y)} is outside"
    return None


def main():
    stream, wrong, counts = random.Random(1), [], {}
    for text in sys.stdin:
        line = json.loads(text)
        counts[line["operation"]] = counts.get(line["operation"], 0) + 1
        if found := complaint(line, stream):
            wrong.append(f"{found}: {text.strip()[:600]}")
    print(json.dumps(counts))
    print("\n".join(wrong[:10]))
    return len(wrong)


if __name__ == "__main__":
    sys.exit(main() > 0)
