# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests share."""
import os
import subprocess
import sys
from pathlib import Path

import pytest

import rwedge

PACKAGE = Path(__file__).resolve().parents[1]
CLONE = PACKAGE.parents[1]
TOP = CLONE if (CLONE / "include").is_dir() else PACKAGE / "library"  # which a source distribution has


@pytest.fixture(scope="session")
def run():
    """run(arguments..., **environment): what a Python process with these arguments prints."""

    def run_it(*arguments, input=None, **environment):
        done = subprocess.run([sys.executable, *map(str, arguments)], input=input, capture_output=True, text=True,
                              env={**os.environ, **environment})
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    return run_it


@pytest.fixture
def contact():
    """A contact in partial slip after a reversal."""
    loaded = rwedge.Contact(0.01, 0.5, 1.8e-5, 0.6)
    loaded.load(2000, 300)
    loaded.load(2000, -600)
    return loaded
