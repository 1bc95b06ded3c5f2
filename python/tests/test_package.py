import doctest
import inspect
from pathlib import Path

import torse
from torse import _designs, _papers, _statements, _sympy


def test_examples_of_the_documentation_run():
    for module in (torse, _designs, _papers, _statements, _sympy):
        failed, tried = doctest.testmod(module, optionflags=doctest.ELLIPSIS)
        assert tried > 0 and failed == 0, module.__name__


def test_stubs_have_what_the_package_has():
    stubs = (Path(torse.__file__).parent / "__init__.pyi").read_text()
    for name in torse.__all__:
        assert name in stubs, name
        value = getattr(torse, name)
        if inspect.isclass(value) and value.__module__.startswith("torse._"):
            own = [own for own in vars(value) if not own.startswith("_")]
            missing = [own for own in own if f"def {own}(" not in stubs and f"    {own}:" not in stubs]
            assert not missing, (name, missing)
