# SPDX-License-Identifier: GPL-3.0-or-later
"""A long run that is interrupted: a contact goes through loads, and its state is saved. Another process reads it and goes on, to
the bits of a run without interruption.                                                  restart.py PICTURE

So does a user element of a finite-element code: ``state()`` is a list of numbers, which fits its state variables, a file or a
message to another process. Between what is accepted and what is tried, ``copy()`` is faster.
"""
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import shown

import rwedge
from rwedge import plot

P, F = 60.0, 0.6
GO_ON = """
import sys
import numpy as np
import rwedge
saved = np.load(sys.argv[1])
contact = rwedge.Contact.restore(saved["state"])
stick, energy = [], []
for Q in saved["Q"]:
    contact.load(contact.P, Q)
    stick.append(contact.stick_half_width)
    energy.append(contact.dissipated_energy)
np.savez(sys.argv[2], state=contact.state(), stick=stick, energy=energy)
"""


def new_pad():
    """Of an aluminium alloy; N, mm."""
    A = rwedge.compliance(72e3, 0.33, 72e3, 0.33)
    contact = rwedge.Contact(0.005, rwedge.rounding(0.005, 20), A, F)
    contact.load(P)
    return contact


# Cycles whose amplitude fades, so that much is remembered.
TURNS = 0.95 * F * P * np.array([1, -1, 0.8, -0.8, 0.6, -0.6, 0.4, -0.4, 0.2])
STEPS = 8  # from one turn to the next


def history():
    return np.concatenate([np.linspace(start, end, STEPS + 1)[1:] for start, end in zip([0, *TURNS[:-1]], TURNS)])


def run(contact, loads):
    stick, energy = np.empty(len(loads)), np.empty(len(loads))
    for i, Q in enumerate(loads):
        contact.load(P, Q)
        stick[i], energy[i] = contact.stick_half_width, contact.dissipated_energy
    return stick, energy


def in_another_process(contact, loads):
    """Saves the contact, and lets a new process go on: what it found, and the state it ended in."""
    with tempfile.TemporaryDirectory() as folder:
        saved, ended = Path(folder, "saved.npz"), Path(folder, "ended.npz")
        np.savez(saved, state=contact.state(), Q=loads)
        print(f"saved {contact.state_size} numbers, {saved.stat().st_size} bytes, for {contact.memory} remembered points")
        subprocess.run([sys.executable, "-c", GO_ON, saved, ended], check=True)
        with np.load(ended) as found:
            return found["stick"], found["energy"], found["state"]


def main():
    picture = shown.arguments(__file__, __doc__).picture
    loads, stop = history(), 5 * STEPS + 4
    whole = new_pad()
    stick, energy = run(whole, loads)

    first = new_pad()
    before = run(first, loads[:stop])
    stick_after, energy_after, state = in_another_process(first, loads[stop:])
    differ = (np.concatenate([before[0], stick_after]) != stick) | (np.concatenate([before[1], energy_after]) != energy)
    print(f"{np.count_nonzero(differ)} of {len(loads)} results differ, {np.count_nonzero(state != whole.state())} numbers of the state")

    figure, (left, right) = shown.plt.subplots(1, 2, figsize=(9, 4))
    steps = np.arange(1, len(loads) + 1)
    for part, colour, name in ((slice(0, stop), plot.BLACK, "first process"), (slice(stop, None), plot.VERMILLION, "restarted")):
        left.plot(steps[part], stick[part] / whole.half_width, ".-", color=colour, label=name)
    left.set(xlabel="load", ylabel="stick zone $c/b$")
    left.legend()
    plot.loop(new_pad(), [*TURNS[:5], loads[stop - 1]], ax=right, color=plot.BLACK, linestyle="solid")
    plot.loop(first, TURNS[5:], ax=right, color=plot.VERMILLION, linestyle="solid")
    shown.save(figure, picture, load=steps, Q_N_per_mm=loads, stick_half_width_mm=stick, energy_N=energy)


if __name__ == "__main__":
    main()
