# SPDX-License-Identifier: GPL-3.0-or-later
"""Packages that only some functions need."""
from __future__ import annotations

import importlib
from typing import Any


def need(name: str, user: str) -> Any:
    """The module of that name; or an error that says who needs its package, and how to get it."""
    package = name.partition(".")[0]
    try:
        importlib.import_module(package)
    except ModuleNotFoundError as error:
        if error.name != package:
            raise
        raise ModuleNotFoundError(f"{user} needs {package}, which is not installed: pip install {package}", name=package) from None
    return importlib.import_module(name)
