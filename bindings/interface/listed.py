#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Names the functions of the header that lack a place where every function must have one. There it stands as `rwedge_NAME`, or
as `{"NAME"`, which begins a row of accuracy."""
import re
import sys
from pathlib import Path

from header import read

TOP = Path(__file__).resolve().parents[2]
PLACES = {  # of which a function needs the second, or where its error cannot be measured the first; and which files may have it
    "a claim": "tests/lib/*/*.c tests/proof/*.c tests/embedding/test_*.c",
    "a row of accuracy": "tests/proof/accuracy/rows/*.cpp",
}
# Without a number whose error could be measured; those of a cycle are sums over a path, which tests/lib/cycle/ compares with
# theory, with small steps and with the energy of the loop, as no reference in balls goes through a path of states. Slip, energies
# and yield factors have reference values in tests/data/. Cycles are
# counted, and damage has another plane in the last bits: tests/lib/measures/ compares them with other routes. No figure of a
# series is promised: tests/lib/stress/test_series.c holds it against the closed form.
WITHOUT_ACCURACY = {"version", "strerror", "contact_create", "contact_create_flat", "contact_create_profile",
                    # by the route of permanent_stick
                    "contact_permanent_stick", "contact_copy", "contact_destroy", "contact_load", "contact_memory",
                    "series_create", "series_fit", "series_destroy", "series_terms", "series_coefficient", "series_residual",
                    "series_pressure", "series_potential", "series_stress", "contact_apply", "contact_obstacle",
                    "contact_loads", "contact_set_strain", "contact_allow_error", "contact_error", "contact_zone_count", "contact_zones",
                    "contact_state_size", "contact_state", "contact_restore", "validity", "validity_text",
                    "rainflow", "smith_watson_topper_damage", "fatemi_socie_damage",
                    "contact_stress_history", "contact_cycle_friction", "contact_cycle_worst", "contact_cycle_below", "contact_displacement",
                    "contact_keep_cycle", "contact_dissipated_energy",
                    "contact_slip", "contact_yield_factor"}


def texts(patterns):
    files = [file for pattern in patterns.split() for file in sorted(TOP.glob(pattern))]
    return "\n".join(file.read_text(encoding="utf-8") for file in files)


def not_in_the_table():
    """Rows of accuracy whose figures lib/README.md does not show."""
    rows = re.findall(r'^    \{"([^"]+)"', texts(PLACES["a row of accuracy"]), re.MULTILINE)
    table = texts("lib/README.md").partition("## Accuracy")[2]
    return [f"the table of accuracy in lib/README.md lacks `{name}`" for name in rows if f"\n| `{name}` |" not in table]


def main():
    lacking = not_in_the_table()
    written = {place: texts(patterns) for place, patterns in PLACES.items()}
    for f in read(TOP / "include/rwedge.h").functions:
        if f.array_of or f.name.endswith("_field"):
            continue  # tests/embedding/test_arrays.c goes through all of them: they have the bits of single calls
        place = "a claim" if f.name in WITHOUT_ACCURACY else "a row of accuracy"
        if not re.search(rf'\brwedge_{f.name}\b|{{"{f.name}"', written[place]):
            lacking.append(f"rwedge_{f.name}() lacks {place} ({PLACES[place]})")
    for text in lacking:
        print(f"FAILED: {text}: see bindings/interface/README.md, How to add a function")
    sys.exit(bool(lacking))


main()
