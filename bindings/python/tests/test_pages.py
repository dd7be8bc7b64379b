# SPDX-License-Identifier: GPL-3.0-or-later
"""The calls that the pages of packages/docs/ show for Python work, and give as many results as the header says."""
import pytest

from conftest import CLONE

pytestmark = pytest.mark.skipif(not (CLONE / "packages/docs/answers.py").is_file(), reason="the source distribution has no packages/")


def test_the_calls_on_the_pages_work(monkeypatch):
    for folder in ("packages/docs", "bindings/interface"):
        monkeypatch.syspath_prepend(str(CLONE / folder))
    from answers import answers
    from header import read

    results = [(f, answers(f)) for f in read(CLONE / "include/rwedge.h").functions if f.name != "contact_state"]
    assert sum(bool(numbers) for _, numbers in results) > 60
    for f, numbers in results:
        assert not numbers or len(numbers) == max(1, len(f.outputs)), f.name
