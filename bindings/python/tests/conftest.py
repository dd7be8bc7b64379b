# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests share. test.sh says in the environment where the private build of the library is."""
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
def private(tmp_path_factory):
    """Where the library's private build is installed."""
    if "RWEDGE_PRIVATE_PREFIX" in os.environ:
        return Path(os.environ["RWEDGE_PRIVATE_PREFIX"])
    build = tmp_path_factory.mktemp("private")
    for step in (["-S", TOP, "-B", build, "-DRWEDGE_PRIVATE_DEPS=ON", "-DCMAKE_BUILD_TYPE=Release", "-DRWEDGE_BUILD_CLI=OFF",
                  "-DRWEDGE_BUILD_TESTS=OFF", "-DCMAKE_INSTALL_LIBDIR=lib"],
                 ["--build", build], ["--install", build, "--prefix", build / "prefix"]):
        subprocess.run(["cmake", *step], check=True, capture_output=True)
    return build / "prefix"


@pytest.fixture(scope="session")
def compiled(tmp_path_factory):
    """compiled(name, source, arguments...): what cc makes of a C source."""
    folder = tmp_path_factory.mktemp("compiled")

    def compile_it(name, source, *arguments):
        subprocess.run(["cc", "-std=c99", "-O2", "-o", folder / name, source, *arguments], check=True)
        return folder / name

    return compile_it


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
