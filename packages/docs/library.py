# SPDX-License-Identifier: GPL-3.0-or-later
"""Calls any function of the library by its description: what the examples give."""
from __future__ import annotations

import ctypes
import math

from examples import UNLOADED
from header import Function, Interface

KINDS = {"double": ctypes.c_double, "int32_t": ctypes.c_int32, "size_t": ctypes.c_size_t, "const char *": ctypes.c_char_p, "void": None}


def sizes(f: Function, given: dict) -> dict[str, int]:
    counts = {}
    for p in f.of("in array"):
        counts[p.size[0]] = len(given[p.name])
        if len(p.size) == 2:
            counts[p.size[1]] = len(given[p.name][0])
    return counts


class Library:
    def __init__(self, path: str, interface: Interface, objects: dict) -> None:
        self.library, self.interface, self.made = ctypes.CDLL(path), interface, objects
        self.handles: dict[str, ctypes.c_void_p] = {}

    def example(self, f: Function, given: dict) -> dict[str, object]:
        """The results by name, after the calls that make the object."""
        calls = self.made.get(f.family, [])
        for name, values in calls[:1] if f.name in UNLOADED else calls:
            maker = self.interface[name]
            self.call(maker, dict(zip([p.name for p in maker.inputs], values)))
        return self.call(f, given)

    def call(self, f: Function, given: dict) -> dict[str, object]:
        counts, passed, results = sizes(f, given), [], {}
        counts.update({p.name: self.call(self.interface[p.given_by], {})["value"] for p in f.parameters if p.given_by})
        for p in f.parameters:
            if p.role in ("handle", "changed"):
                passed.append(self.handles[p.kind])
            elif p.role == "created":
                self.handles[p.kind] = ctypes.c_void_p()
                passed.append(ctypes.byref(self.handles[p.kind]))
            elif p.role == "size":
                passed.append(KINDS[p.kind](counts[p.name]))
            elif p.role == "in":
                passed.append(KINDS[p.kind](given[p.name]))
            elif p.role == "in array":
                numbers = [v for row in given[p.name] for v in (row if isinstance(row, list) else [row])]
                passed.append((ctypes.c_double * len(numbers))(*numbers))
            else:
                results[p.name] = (ctypes.c_double * math.prod(counts[n] for n in p.size))()
                passed.append(results[p.name])
        function = getattr(self.library, "rwedge_" + f.name)
        function.restype = KINDS[f.returns]
        value = function(*passed)
        if f.result == "status" and value != 0:
            raise ValueError(f"the example of rwedge_{f.name}() is refused with the status {value}: change packages/docs/examples.py")
        return {"value": value} if f.result in ("value", "text") else {n: list(v) for n, v in results.items()}
