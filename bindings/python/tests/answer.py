# SPDX-License-Identifier: GPL-3.0-or-later
"""Answers the calls of tests/answers/calls.py from standard input: each line back with the bits of its results, as 16
hexadecimal digits, "nan" for every NaN, "error" where it is refused. Prints what tests/answers/answer.c prints."""
import struct
import sys
from functools import partial

import numpy as np

import rwedge
from rwedge._header import FUNCTIONS

objects = {}  # one of a family at a time: what makes one begins the next
PADS = {"contact_create": rwedge.Contact, "contact_create_flat": rwedge.Contact.flat, "contact_create_profile": rwedge.Contact.profile}
MAKERS = {**{name: partial(maker, tolerance=0) for name, maker in PADS.items()}, "series_create": rwedge.Series, "series_fit": rwedge.Series.fit}
# What has another name here.
FORMS = {"elastic_limits": rwedge.elastic_limit, "series_coefficient": lambda k: objects["series"].coefficients[k],
         "smith_watson_topper_field": lambda *arguments: rwedge.smith_watson_topper(*arguments, axis=0),
         "fatemi_socie_field": lambda *arguments: rwedge.fatemi_socie(*arguments, axis=0)}


def made(name, family, arguments):
    """An object, by its class, a method of the class, or a method of another object."""
    if name in MAKERS:
        return MAKERS[name](*arguments)
    owner = objects[family] if "handle" in FUNCTIONS[name]["roles"] else {"contact": rwedge.Contact, "series": rwedge.Series}[family]
    return getattr(owner, name.removeprefix(family + "_"))(*arguments)


def call(name, arguments):
    """The results, a tuple."""
    about = FUNCTIONS[name]
    family = about["family"]
    if "created" in about["roles"]:
        objects[family] = made(name, family, arguments)
        return ()
    if name in FORMS:
        result = FORMS[name](*arguments)
    elif family:
        member = getattr(objects[family], name.removeprefix(family + "_"))
        result = member(*arguments) if callable(member) else member
    else:
        result = getattr(rwedge, name)(*arguments)
    if result is None:
        return ()
    if isinstance(result, str):
        return (len(result),)
    if np.iscomplexobj(result):
        return result.real, result.imag
    return result if isinstance(result, tuple) else (result,)


def argument(text, kind, before):
    if text == "@":
        return before
    values = [float(word) for word in text.replace(";", " ").split(" ")]
    if ";" in text:
        return np.array(values).reshape(text.count(";") + 1, -1)
    return np.array(values) if kind == "const double *" else int(values[0]) if kind == "int32_t" else values[0]


def bits(value):
    return "nan" if np.isnan(value) else struct.pack(">d", value).hex()


def main():
    before = np.array([])
    with np.errstate(all="ignore"):  # outside the domain is among the calls
        for line in map(str.rstrip, sys.stdin):
            name, *texts = line.split(",")
            name = name.split(":")[0]
            inputs = [kind for (kind, _), role in zip(FUNCTIONS[name]["parameters"], FUNCTIONS[name]["roles"])
                      if role in ("in", "in array")]
            try:
                results = call(name, [argument(text, kind, before) for text, kind in zip(texts, inputs)])
                before = np.concatenate([np.ravel(result) for result in results]) if results else np.array([])
                print(line, *map(bits, before), sep=",")
            except (rwedge.Error, IndexError):
                print(line, "error", sep=",")


if __name__ == "__main__":
    main()
