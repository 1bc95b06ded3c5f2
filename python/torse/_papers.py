"""Papers as tables."""

from . import _html, _torse

# A paper of the examples.
_EXAMPLE = {
    "paper.toml": """
[paper]
id = "mine"
title = "A paper"
authors = "A. Uthor"
venue = "nowhere"
claims = ["claims.toml"]
[symbols]
x = { in = "(-inf, inf)" }
""",
    "claims.toml": """
[[claim]]
id = "mine/1"
at = "eq. (1)"
kind = "identity"
printed = "(x + 1)(x - 1) = x² + 1"
states = "(x + 1)*(x - 1) == x^2 + 1"
""",
}


class Verification:
    """What was found of a paper: a row for each claim.

    >>> from torse import Paper
    >>> verified = Paper.read(_EXAMPLE).verify()
    >>> [(row["id"], row["verdict"], row["corrected"]) for row in verified.rows()]
    [('mine/1', 'misprint', '(x + 1)*(x - 1) == x^2 - 1')]
    """

    def __init__(self, found):
        self._found = found

    mistakes = property(lambda self: self._found.mistakes, doc="formulas that make no sense, as texts")

    def rows(self):
        """A dictionary for each claim: id, at, verdict, evidence, statement, corrected, conditions, replayed."""
        return self._found.rows()

    def to_pandas(self):
        """The same as a `pandas.DataFrame`, with the ids as its index."""
        from pandas import DataFrame

        return DataFrame(self.rows()).set_index("id")

    def json(self):
        """The verdicts as `torse verify --format json` writes them."""
        return self._found.json()

    def letter(self, sender=None, date=None):
        """The letter of corrections to the paper's authors; without a sender it is marked as a draft.

        >>> letter = Paper.read(_EXAMPLE).verify().letter(sender="A. Reader")
        >>> "eq. (1)" in letter.markdown and letter.latex.startswith("\\\\documentclass")
        True
        """
        return Letter(*self._found.letter(sender, date))

    def __len__(self):
        return len(self._found)

    def __repr__(self):
        return f"<Verification of {len(self)} claims>"

    def _repr_html_(self):
        groups = [[(row["id"], f"{row['verdict']}: {row['statement'] or row['at']}") for row in self.rows()]]
        return _html.table(groups)


class Letter:
    """The corrections of a paper, ready to be sent: `markdown` and `latex` are its texts."""

    def __init__(self, markdown, latex):
        self.markdown = markdown
        self.latex = latex

    def __repr__(self):
        return self.markdown

    def _repr_markdown_(self):
        return self.markdown


class Paper:
    """A paper: a folder of derivation files, that with a `paper.toml`.

    >>> from torse import Paper
    >>> Paper.read(_EXAMPLE)
    <Paper mine: 1 claims>
    >>> Paper.read(_EXAMPLE).explain("mine/1")["place"]
    'eq. (1)'
    >>> Paper("no/such/folder")
    Traceback (most recent call last):
    ...
    torse.TorseError: cannot read no/such/folder: ...
    """

    def __init__(self, folder):
        self._paper = _torse.Paper(folder) if not isinstance(folder, _torse.Paper) else folder

    @classmethod
    def read(cls, files):
        """A paper of texts: a dictionary from the names of files, `paper.toml` among them, to their texts."""
        return cls(_torse.Paper.read(files))

    id = property(lambda self: self._paper.id, doc="with which the ids of its claims begin")
    title = property(lambda self: self._paper.title, doc="the title")
    ids = property(lambda self: self._paper.ids, doc="the ids of its claims")

    def __len__(self):
        return len(self._paper)

    def __repr__(self):
        return f"<Paper {self.id}: {len(self)} claims>"

    def only(self, *names):
        """The same paper with just the claims that these names mean: ids, or beginnings of ids."""
        return Paper(self._paper.only(*names))

    def verify(self, progress=None, budget=None):
        """Decides all claims.

        `progress(what, done, total)` is called now and then; where it raises or returns False the work is ended. Ctrl-C ends
        it too.
        """
        return Verification(self._paper.verify(progress, budget))

    def explain(self, name):
        """One claim like a referee's note: what is printed, what is true, why, what rests on it."""
        return Explanation(self._paper.explain(name))


class Explanation:
    """Groups of labels and texts."""

    def __init__(self, groups):
        self.groups = groups

    def __getitem__(self, label):
        for group in self.groups:
            for own, text in group:
                if own == label:
                    return text
        raise KeyError(label)

    def __str__(self):
        return _html.text(self.groups)

    def __repr__(self):
        return str(self)

    def _repr_html_(self):
        return _html.table(self.groups)
