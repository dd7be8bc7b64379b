# SPDX-License-Identifier: GPL-3.0-or-later
"""Answers the calls of tests/doors/calls.sh from standard input: each line back with the bits of its results, as 16
hexadecimal digits ("nan" for every NaN). Prints what tests/doors/door.c prints."""
import struct
import sys

import numpy as np

import rwedge

contact = None  # one at a time: contact_create begins the next


def create(*parameters):
    global contact
    contact = rwedge.Contact(*parameters)


CONTACT = {
    "create": create,
    "load": lambda P, Q: contact.load(P, Q),
    "half_width": lambda: contact.half_width,
    "stick_half_width": lambda: contact.stick_half_width,
    "dissipated_energy": lambda: contact.dissipated_energy,
    "tractions": lambda x: contact.tractions(x),
    "stresses": lambda x, y: contact.stresses(x, y),
    "slip": lambda x: contact.slip(x),
    "yield_factor": lambda nu, k: contact.yield_factor(nu, k),
}


def call(name, arguments):
    """The results, a tuple."""
    if name.startswith("contact_"):
        result = CONTACT[name.removeprefix("contact_")](*arguments)
    elif name == "coefficient":
        result = rwedge.coefficient(arguments[0], int(arguments[1]))
    else:
        result = getattr(rwedge, name)(*arguments)
    if result is None:
        return ()
    return result if isinstance(result, tuple) else (result,)


def bits(value):
    return "nan" if np.isnan(value) else struct.pack(">d", value).hex()


def main():
    with np.errstate(invalid="ignore"):  # outside the domain is among the calls
        for line in map(str.rstrip, sys.stdin):
            name, *arguments = line.split(",")
            print(line, *map(bits, call(name, [float(argument) for argument in arguments])), sep=",")


if __name__ == "__main__":
    main()
