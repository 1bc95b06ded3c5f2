import signal
import threading
import time

import pytest
import torse

HEAD = """
[paper]
id = "mine"
title = "A paper"
authors = "A. Uthor"
venue = "nowhere"
claims = ["claims.toml"]
[symbols]
x = { in = "(-inf, inf)" }
"""
CLAIM = """
[[claim]]
id = "mine/{name}"
at = "eq. ({name})"
kind = "identity"
printed = ""
states = "{states}"
"""


def paper(*statements):
    claims = "".join(CLAIM.format(name=i + 1, states=states) for i, states in enumerate(statements))
    return torse.Paper.read({"paper.toml": HEAD, "claims.toml": claims})


def test_a_paper_is_a_table():
    verified = paper("x + x == 2*x", "(x + 1)*(x - 1) == x^2 + 1").verify()
    first, second = verified.rows()
    assert (first["id"], first["verdict"], first["evidence"]) == ("mine/1", "holds", "identity")
    assert (second["verdict"], second["corrected"]) == ("misprint", "(x + 1)*(x - 1) == x^2 - 1")
    assert '"verdict": "misprint"' in verified.json()


def test_a_paper_is_a_data_frame():
    pytest.importorskip("pandas")
    frame = paper("x + x == 2*x").verify().to_pandas()
    assert frame.loc["mine/1", "verdict"] == "holds"


def test_claims_are_chosen_and_explained():
    own = paper("x + x == 2*x", "(x + 1)*(x - 1) == x^2 + 1")
    assert own.ids == ["mine/1", "mine/2"]
    assert len(own.only("mine/2").verify()) == 1
    note = own.explain("mine/2")
    assert note["verdict"].startswith("misprint") and note["place"] == "eq. (2)"
    with pytest.raises(torse.TorseError, match="mine/1"):
        own.explain("mine")


def test_a_mistake_of_a_file_has_its_place():
    with pytest.raises(torse.TorseError) as raised:
        torse.Paper.read({"paper.toml": HEAD, "claims.toml": CLAIM.format(name=1, states="x ==")})
    assert raised.value.file == "claims.toml" and raised.value.line == 7


def test_a_folder_that_is_none_is_refused(tmp_path):
    with pytest.raises(torse.TorseError):
        torse.Paper(tmp_path)


def test_progress_is_told_and_ends_the_work():
    hard = paper(*[f"product(i, 1, 40, x + i) == product(i, 1, 40, x + i) + {n}" for n in range(40)])
    seen = []

    def watch(what, done, total):
        seen.append((what, done, total))
        return False

    try:
        hard.verify(progress=watch)
    except torse.TorseError as error:
        assert "cancelled" in str(error)
        assert seen and seen[-1][2] <= 40
    else:
        pytest.fail("nothing was ended")


def test_an_exception_of_the_callback_comes_out():
    def watch(*_):
        raise KeyError("mine")

    with pytest.raises(KeyError):
        paper("x + x == 2*x").verify(progress=watch)


def test_other_threads_go_on():
    count = 0
    ended = threading.Event()

    def work():
        nonlocal count
        while not ended.is_set():
            count += 1
            time.sleep(0.001)

    thread = threading.Thread(target=work)
    thread.start()
    paper(*[f"(x + {n})^30 == (x + {n})^30 + 1" for n in range(20)]).verify()
    ended.set()
    thread.join()
    assert count > 0


# Takes many seconds if it is not ended.
POWER = "product(i, 1, 8, x + x^3 + x^5 + x^7 + i + {0})^12"
LONG = " and ".join(f"{POWER} == {POWER}".format(k) for k in range(200))


@pytest.mark.parametrize(
    "work",
    [
        lambda: paper(*[f"(x + {n})^60 == (x + {n})^60 + x" for n in range(4000)]).verify(),
        lambda: paper(LONG).verify(budget=10**15),
        lambda: torse.decide(LONG, budget=10**15),
    ],
    ids=["many claims", "a long claim", "a long decision"],
)
def test_ctrl_c_ends_the_work_soon(work):
    sent = []

    def send():
        sent.append(time.monotonic())
        signal.raise_signal(signal.SIGINT)

    timer = threading.Timer(0.5, send)
    timer.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            work()
        assert time.monotonic() - sent[0] < 5
    finally:
        timer.cancel()
