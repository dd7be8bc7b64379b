# SPDX-License-Identifier: GPL-3.0-or-later
"""A series of tests, as the tool computes it: ``rwedge fretting --input`` is asked, so that both give the same bits."""
from __future__ import annotations

import csv
import json
import math
import os
import tempfile
import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Iterator, Mapping

import numpy as np

from ._files import _run, _words

_TEXTS = ("warnings", "error", "loads")


@dataclass(frozen=True)
class Tests:
    """A series of tests: its columns by name, ``tests["life"]``. Those of numbers are arrays of floats, NaN where a cell is empty, and
    infinite for a life that is predicted as a run-out; the others are arrays of texts.

    Attributes
    ----------
    columns : dict
        Those of the table, and behind them the results.
    is_run_out : array of bool
        Which tests were run-outs: their ``life_tested`` and ``tested_over_predicted`` are bounds.
    remarks : list of str
        What the tool says beside: of a fitted length the scatter there and at the surface.

    See Also
    --------
    series : computes one
    """

    columns: dict[str, Any]
    is_run_out: Any
    remarks: list[str]

    def __getitem__(self, name: str) -> Any:
        return self.columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.columns)

    def __len__(self) -> int:
        return len(self.is_run_out)

    @property
    def length(self) -> float:
        """The critical distance, given or fitted; NaN for none."""
        lengths = self.columns.get("length", np.array([math.nan]))
        known = lengths[~np.isnan(lengths)]
        return float(known[0]) if known.size > 0 else math.nan


def _is_blank(value: Any) -> bool:
    return value is None or (isinstance(value, float) and math.isnan(value))


def _write(tests: Mapping[str, Any], path: Path) -> None:
    columns = {str(name): list(values) for name, values in tests.items()}
    lengths = {name: len(values) for name, values in columns.items()}
    if len(set(lengths.values())) > 1:
        raise ValueError(f"columns of different lengths: {lengths}; allowed: one length")
    with path.open("w", encoding="utf-8", newline="") as out:
        table = csv.writer(out)
        table.writerow(columns)
        table.writerows(["" if _is_blank(value) else repr(float(value)) if isinstance(value, (float, np.floating)) else value
                         for value in row] for row in zip(*columns.values()))


def _path_of(table: str | os.PathLike[str] | Mapping[str, Any], folder: str) -> Path:
    """The file that is named, or one of these columns in the folder."""
    if isinstance(table, (str, os.PathLike)):
        return Path(table)
    path = Path(folder) / "table.csv"
    _write(table, path)
    return path


def _number(value: Any) -> float:
    """Of a run-out, ">1e7", its bound; of an empty cell NaN."""
    return math.nan if value is None or value == "" else float(str(value).lstrip("> ").replace("10^", "1e"))


def _column(name: str, values: list[Any]) -> Any:
    try:
        numbers = np.array([_number(value) for value in values])
    except ValueError:
        numbers = None
    if numbers is None or name in _TEXTS:
        return np.array(["" if value is None else str(value) for value in values], dtype=object)
    return numbers


def series(tests: str | os.PathLike[str] | Mapping[str, Any], **words: Any) -> Tests:
    """A table of tests, each a contact under a cycle of loads, perhaps with the life that was measured: what the criteria come to where
    each is worst, and what they say of the life, as ``rwedge fretting --input`` has it.

    Parameters
    ----------
    tests : path or mapping
        A file, or its columns by name, as a dict or a DataFrame has them: the inputs of a contact, P or p0, Q_max, Q_min, sigma_max,
        sigma_min, sigma_before, or loads, a file; constants of the material that differ; life_tested, ">1e7" for a run-out.
    **words
        The options of the tool with ``_`` for ``-``: E1=210e3, nu1=0.3, f=0.6, material="sae-1015-normalized" or a dict,
        criteria="swt,crossland", crossland_alpha=0.3, length=0.08 or fit_length=True, method="line", cycles=3, units="mm,N,MPa",
        column={"Q_max": "Q"}.

    Returns
    -------
    Tests

    Examples
    --------
    >>> tests = rwedge.series({"radius": [50, 50], "P": [300, 300], "Q_max": [100, 140], "life_tested": [88216, ">1e7"]}, f=0.6,
    ...                       material="sae-1015-normalized")                              # doctest: +SKIP
    >>> tests["tested_over_predicted"]                                                     # doctest: +SKIP
    """
    with tempfile.TemporaryDirectory() as folder:
        path = _path_of(tests, folder)
        options = [word for name, value in words.items() for word in _words(name, value)]
        written, said = _run("fretting", ["--input", os.fspath(path), *options, "--format", "json"])
    for remark in said:
        if not remark.startswith("length "):
            warnings.warn(remark, stacklevel=2)
    rows: list[dict[str, Any]] = json.loads(written)
    columns = {name: [row[name] for row in rows] for name in (rows[0] if rows else {})}
    tested = columns.get("life_tested", [None] * len(rows))
    return Tests(columns={name: _column(name, values) for name, values in columns.items()},
                 is_run_out=np.array([str(value).lstrip().startswith(">") for value in tested], dtype=bool), remarks=said)
