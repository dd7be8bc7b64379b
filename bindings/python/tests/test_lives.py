# SPDX-License-Identifier: GPL-3.0-or-later
"""When an object lives and when it is gone; interrupts, forks, subclasses."""
import copy
import os
import pickle
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import rwedge

MADE = "import gc, rwedge; c = rwedge.Contact(0.01, 2., 1.82e-5, .3); c.load(2000); c.load(2000, 300)\n"
# at exit, in a global's __del__, in that of a cycle, in a generator of a cycle
LATE = [
    "import atexit; atexit.register(lambda: print(c.half_width))",
    """
class Last:
    def __init__(self, c): self.c = c
    def __del__(self): print(self.c.half_width)
last = Last(c)""",
    """
class Ring:
    def __init__(self, c): self.c, self.me = c, self
    def __del__(self):
        try: print(self.c.half_width)
        except rwedge.Error as error: print(error)
Ring(rwedge.Contact(0.01, 2., 1.82e-5, .3)); gc.collect()""",
    """
def reader(c, ring):
    try: yield
    finally:
        try: print(c.half_width)
        except rwedge.Error as error: print(error)
ring = []
ring.append(reader(rwedge.Contact(0.01, 2., 1.82e-5, .3), ring)); next(ring[0]); del ring; gc.collect()"""]


def test_late_use_is_an_answer_or_an_error_and_no_crash(run):
    assert len(run("-c", MADE + "\n".join(LATE)).splitlines()) == len(LATE)


def test_an_object_that_was_freed_says_so():
    contact = rwedge.Contact(0.01, 2.0, 1.82e-5, 0.3)
    contact._cell[0] = None  # what the finalizer leaves; the memory is lost to this test
    with pytest.raises(rwedge.Error, match="this Contact has been freed"):
        contact.tractions(0.1)
    with pytest.raises(rwedge.Error, match="this Contact has been freed"):
        contact.copy()


# An interrupt within a finalizer of Python's own is swallowed, with this warning, and comes again.
@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="no timer that interrupts")
def test_an_interrupted_load_reports_the_loads_that_the_contact_has():
    contact, wrong, interrupted = rwedge.Contact(0.01, 2.0, 1.82e-5, 0.3), 0, 0
    contact.load(1000)

    def stop(*_):
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, stop)
    try:
        for i in range(400):
            try:
                signal.setitimer(signal.ITIMER_REAL, 1e-5 * (1 + i % 40), 5)
                while True:
                    contact.load(3000 - contact.P)
            except KeyboardInterrupt:
                interrupted += 1
            wrong += contact.half_width != rwedge.half_width(0.01, 2.0, 1.82e-5, contact.P)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert interrupted == 400 and wrong == 0


FORK = """
import os, threading, rwedge
c = rwedge.Contact(0.01, 2.0, 1.82e-5, 0.3)
c.load(2000)
going = True
def busy():
    while going: c.yield_factor(0.3, 1e6)
def refused():
    while going:
        try: c.load([2000.] * 50, [10.] * 49 + [700.])
        except rwedge.SlidingError: pass
worker = threading.Thread(target=%s); worker.start()
for _ in range(8):
    child = os.fork()
    if child == 0: os._exit(0 if c.half_width > 0 else 1)
    assert os.waitpid(child, 0)[1] == 0
going = False; worker.join()
"""


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")
@pytest.mark.parametrize("beside", ["busy", "refused"])
def test_a_child_of_fork_can_use_what_another_thread_was_using(beside):
    subprocess.run([sys.executable, "-W", "ignore", "-c", FORK % beside], timeout=60, check=True)


def cycle_of(contact, loads):
    return contact.stresses_after({"P": 2000, "Q": np.resize([300.0, -300.0], loads)}, np.linspace(-1, 1, 20_000), 0.1)


MANY = np.linspace(0.1, 0.9, 4_000_000)
LONG_CALLS = {  # each takes more than five seconds
    "formula": lambda contact: rwedge.elastic_limit(MANY, 0.1, 0.3),
    "grid": lambda contact: rwedge.elastic_limit(MANY[:2000, None], np.linspace(0, 0.5, 2000), nu=0.3),
    "of a cycle": lambda contact: rwedge.smith_watson_topper(*np.broadcast_to([[[1.0]], [[-2.0]], [[3.0]]], (3, 60, 500_000)), 200e3, 0.3, axis=0),
    "cycle": lambda contact: cycle_of(contact, 4000),
    "fit": lambda contact: rwedge.Series.fit(MANY[:40_000], -MANY[:40_000], 400)}


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="no timer that interrupts")
@pytest.mark.parametrize("name", [name if "cycle" in name else pytest.param(name, marks=pytest.mark.long) for name in LONG_CALLS])
def test_ctrl_c_is_heard_within_a_second_or_two(name):
    contact = rwedge.Contact(0.01, 2.0, 1.82e-5, 0.3)
    contact.load(2000)
    before, state = signal.signal(signal.SIGALRM, lambda *_: signal.raise_signal(signal.SIGINT)), contact.state()
    signal.setitimer(signal.ITIMER_REAL, 0.1)
    started = time.monotonic()
    try:
        with pytest.raises(KeyboardInterrupt):
            LONG_CALLS[name](contact)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert time.monotonic() - started < 4 and (contact.state() == state).all()


def test_a_long_formula_has_the_bits_of_its_points():
    alpha, x = np.linspace(0.1, 2, 9)[:, None, None], np.linspace(-1, 1, 6000)
    for name in ("pressure", "shear"):
        formula = getattr(rwedge, name)
        arguments = (alpha, x) if name == "pressure" else (alpha, np.array([[0.2], [0.5]]), x)
        assert (formula(*arguments) == formula.ufunc(*arguments)).all()


class Pad(rwedge.Contact):
    """A subclass with something of its own."""

    def __init__(self, name, notes):
        super().__init__(0.01, 2.0, 1.82e-5, 0.3)
        self.name, self.notes = name, notes


class Slotted(Pad):
    """The same, without a dictionary for some of it."""

    __slots__ = ("place",)


@pytest.mark.parametrize("twin_of", [lambda pad: pickle.loads(pickle.dumps(pad)), copy.copy, copy.deepcopy, rwedge.Contact.copy])
@pytest.mark.parametrize("kind", [Pad, Slotted])
def test_a_pickled_or_copied_subclass_has_its_attributes(kind, twin_of):
    pad = kind("left", ["new"])
    pad.place = pad.notes
    pad.load(2000)
    pad.load(2000, 300)
    twin = twin_of(pad)
    assert type(twin) is kind and (twin.name, twin.notes, twin.loads) == ("left", ["new"], pad.loads)
    assert twin.place is twin.notes and (twin.notes is pad.notes) == (twin_of in (copy.copy, rwedge.Contact.copy))
    for contact in (pad, twin):
        contact.load(1500, -100)
    assert twin.slip(0.9 * twin.half_width) == pad.slip(0.9 * pad.half_width)


def test_a_contact_in_its_own_attributes_is_copied_once():
    pad = Pad("left", [])
    pad.notes.append(pad)
    twin = copy.deepcopy(pad)
    assert twin.notes[0] is twin
