# SPDX-License-Identifier: GPL-3.0-or-later
"""What the calls of the examples give: those of Python, carried out."""
from __future__ import annotations

import warnings

import numpy as np
import rwedge

import examples
from header import Function
from languages import Python


def objects(f: Function) -> dict[str, object]:
    """What stands for the names in a call."""
    contact = rwedge.Contact(0.01, 2, 1.82e-5, 0.3, tolerance=0)
    if f.name not in examples.UNLOADED:
        contact.load([2000, 2000], [0, 600 if f.name in examples.SLIDING else 300])
    if f.name in examples.HELD:
        contact.set_rotation(1)
    return {"rwedge": rwedge, "contact": contact, "cycle": rwedge.Cycle(contact, {"P": 2000, "Q": [-300, 300]}), "series": rwedge.Series(0.25, 4), "state": contact.state()}


def answers(f: Function) -> dict[str, object]:
    """The results by their names in the header; nothing where something else serves in Python."""
    if f.name == "strerror":  # which is the message of an error there
        return {"value": rwedge._library._strerror(examples.NUMBERS["status"]).decode()}
    call = Python().call(f, {p.name: examples.value_of(f, p) for p in f.inputs})
    if not call:
        return {}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of examples that show what is doubtful
        result = eval(call.rpartition(" = ")[2], objects(f))
    names = f.results
    is_complex = not isinstance(result, tuple) and np.iscomplexobj(result)
    results = (result.real, result.imag) if is_complex else result if len(names) > 1 else [result]
    return {name: value if isinstance(value, str) else np.ravel(value).tolist() for name, value in zip(names, results)}
