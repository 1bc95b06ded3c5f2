"""Products of polynomials beside FLINT, on the same polynomials.

poly_s and poly_r are products of 500 by 500 terms in four variables, exponents 0 to 8, numerators of 63 bits. The
denominators of poly_s are 2^k 3^j 5^l, those of poly_r random odd numbers of 31 bits. Both programs make them from
the same stream of random numbers; their digests, and the values of the products, are compared before anything is
timed.
"""

import pathlib
import subprocess
import sys
import time

from table import optional

ROOT = pathlib.Path(__file__).resolve().parents[2]
SEEDS = (12345, 987654321)
# The digests that the generator of the benchmark asserts too.
DIGESTS = {
    "poly_s": (0xE9F7A4E9A441A924, 0x366C923BAF87D623),
    "poly_r": (0xE464F2BC572BF341, 0x36FE4C0BF08028AD),
}
# Products timed at once, so that a measurement is long against the clock.
COUNTS = {"poly_s": 5, "poly_r": 1}
WORD = (1 << 64) - 1


def numbers(state):
    """The xorshift generator of Marsaglia with shifts 13, 7, 17."""
    while True:
        state ^= state << 13 & WORD
        state ^= state >> 7
        state ^= state << 17 & WORD
        yield state


def rows(seed, rough):
    """The 500 terms of a factor by exponents: numerator and denominator."""
    stream = numbers(seed)
    terms = {}
    while len(terms) < 500:
        exponents = tuple((next(stream) >> 20) % 9 for _ in range(4))
        numerator = (next(stream) >> 1) - (1 << 62) | 1
        if rough:
            denominator = next(stream) >> 33 | 1
        else:
            two, three, five = ((next(stream) >> 9) % n for n in (11, 5, 2))
            denominator = 2**two * 3**three * 5**five
        terms[exponents] = (numerator, denominator)
    return sorted(terms.items())


def digest(terms):
    """The 64-bit FNV-1a digest of the terms, each written as a line of six numbers."""
    text = "".join(" ".join(map(str, (*e, *c))) + "\n" for e, c in terms)
    value = 0xCBF29CE484222325
    for byte in text.encode():
        value = (value ^ byte) * 0x100000001B3 & WORD
    return value


class Torse:
    """The program that multiplies on demand."""

    def __init__(self, program):
        self.process = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def ask(self, request):
        self.process.stdin.write(request + "\n")
        self.process.stdin.flush()
        answer = self.process.stdout.readline()
        if not answer:
            sys.exit(f"the program ended at {request!r}")
        return answer.split()

    def time(self, name):
        return int(self.ask(f"time {name} {COUNTS[name]}")[0]) / 1e9

    def value(self, name):
        terms, value = self.ask(f"value {name}")
        return int(terms), value


class Flint:
    """The same products by python-flint."""

    def __init__(self, flint, factors):
        context = flint.fmpq_mpoly_ctx.get(["x", "y", "z", "w"], flint.Ordering.lex)
        self.factors = {
            name: [context.from_dict({e: flint.fmpq(*c) for e, c in terms}) for terms in pair]
            for name, pair in factors.items()
        }

    def time(self, name):
        a, b = self.factors[name]
        start = time.perf_counter()
        for _ in range(COUNTS[name]):
            _ = a * b
        return (time.perf_counter() - start) / COUNTS[name]

    def value(self, name):
        a, b = self.factors[name]
        product = a * b
        return len(product), str(product(2, 3, 5, 7))


def built():
    """The program that multiplies, built."""
    build = ["cargo", "build", "--release", "-p", "torse-algebra", "--example", "products"]
    described = subprocess.run(
        [*build, "--message-format", "json-render-diagnostics"],
        cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True,
    )  # fmt: skip
    return next(
        line.split('"executable":"')[1].split('"')[0]
        for line in described.stdout.splitlines()
        if '"executable":"' in line
    )


def measured(rounds):
    """Seconds for each product by program."""
    factors = {name: [rows(seed, name == "poly_r") for seed in SEEDS] for name in DIGESTS}
    for name, pair in factors.items():
        if tuple(map(digest, pair)) != DIGESTS[name]:
            sys.exit(f"{name}: not the terms of the benchmark")
    flint = optional("flint", "python-flint")
    if flint is None:
        return {}
    peers = {"torse": Torse(built()), f"FLINT {flint.__FLINT_VERSION__}": Flint(flint, factors)}
    tasks = {}
    for name in DIGESTS:
        values = [peer.value(name) for peer in peers.values()]
        if len(set(values)) != 1:
            sys.exit(f"{name}: the products differ")
        tasks[name] = f"product {name}, {values[0][0]} terms"
    least = {task: dict.fromkeys(peers, float("inf")) for task in tasks.values()}
    for _ in range(rounds):
        for name, task in tasks.items():
            for label, peer in peers.items():
                least[task][label] = min(least[task][label], peer.time(name))
    return least
