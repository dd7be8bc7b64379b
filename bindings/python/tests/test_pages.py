# SPDX-License-Identifier: GPL-3.0-or-later
"""The calls that the pages of packages/docs/ show for Python work, and give as many results as the header says."""
import numpy as np
import pytest

import rwedge
from conftest import CLONE

pytestmark = pytest.mark.skipif(not (CLONE / "packages/docs/examples.py").is_file(), reason="the source distribution has no packages/")


def test_the_calls_on_the_pages_work(monkeypatch):
    for folder in ("packages/docs", "bindings/interface"):
        monkeypatch.syspath_prepend(str(CLONE / folder))
    import examples
    from header import read
    from languages import Python

    called = 0
    for f in read(CLONE / "include/rwedge.h").functions:
        call = Python().call(f, {p.name: examples.value_of(f, p) for p in f.inputs})
        if not call:
            continue  # something else is said to serve there
        contact = rwedge.Contact(0.01, 2, 1.82e-5, 0.3)
        if f.name not in examples.UNLOADED:
            contact.load([2000, 2000], [0, 300])
        names = {"rwedge": rwedge, "contact": contact, "series": rwedge.Series(0.25, 4), "state": contact.state()}
        result = eval(call.rpartition(" = ")[2], names)
        called += 1
        if len(f.outputs) > 1 and f.name != "series_potential":
            assert np.shape(result)[0] == len(f.outputs), call
    assert called > 60
