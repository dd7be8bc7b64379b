# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the spreadsheet that computes, rounded-wedge.xlsx: plain formulas, and the tables in which they interpolate.

    workbook.py TOOL LIBRARY FILE     the tool "rwedge" and the shared library, whose numbers it shows

It needs XlsxWriter (Debian: python3-xlsxwriter)."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "book"))

import about  # noqa: E402
import batch  # noqa: E402
import materials  # noqa: E402
import pads  # noqa: E402
import reference  # noqa: E402
from book import Book  # noqa: E402
from calculator import Calculator  # noqa: E402
from cells import BATCH_EXAMPLES, EXAMPLE, RESULTS  # noqa: E402
from source import Source, YieldTable  # noqa: E402
from working import Working  # noqa: E402


def shown(source, case):
    """The inputs of an example and its results, until a spreadsheet computes: those of "rwedge solve", of its table of shakedown, and
    quotients of them."""
    columns = [cell.column for cell in RESULTS[:-2]] + ["yield_factor"]
    results = {name: value for name, value in source.solve(case).items() if name in columns}
    results["p_mean"] = case["P"] / (2 * results["b"])
    results["safety_strength"] = results["P_over_bk"] / results["load_over_bk"]
    passes = source.table("shakedown-limit", a_over_b=min(1, results["a_over_b"]), friction=case["f"], nu=case["nu1"])[0]
    results["P_over_bk_shakedown"] = passes["P_over_bk"]
    results["safety_strength_shakedown"] = passes["P_over_bk"] / results["load_over_bk"]
    return dict(results, **case)


def main(tool, library, path):
    source = Source(tool, library)
    book = Book(path, source.version)
    example = shown(source, EXAMPLE)
    working = Working(book.sheets["Working"], source, YieldTable(source), example)
    Calculator(book.sheets["Calculator"], working, example)
    batch.write(book.sheets["Batch"], [shown(source, case) for _, case in BATCH_EXAMPLES])
    pads.write(book.sheets["Pads"], source, EXAMPLE)
    materials.write(book.sheets["Materials"])
    reference.look_up(book.sheets["Look up"], source)
    reference.elastic_limit(book.sheets["Elastic limit"], source)
    reference.maximum_tension(book.sheets["Maximum tension"], source)
    reference.contact_law(book.sheets["Contact law"], source)
    reference.critical_friction(book.sheets["Critical friction"], source)
    about.write(book.sheets["About"])
    book.close()


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
