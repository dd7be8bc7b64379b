# SPDX-License-Identifier: GPL-3.0-or-later
"""What an installed package says of itself."""
import importlib.metadata
import subprocess

import pytest

from conftest import PACKAGE


def test_the_metadata_names_authors_licences_and_purposes():
    about = importlib.metadata.metadata("rwedge")
    assert about["Author"] and about["License-Expression"] == "GPL-3.0-or-later"
    assert {"Typing :: Typed", "Programming Language :: C"} <= set(about.get_all("Classifier"))
    assert "test" in about.get_all("Provides-Extra")
    files = {file.name: file.read_text() for file in importlib.metadata.files("rwedge") if "licenses" in file.parts}
    assert "GNU GENERAL PUBLIC LICENSE" in files["LICENSE"]
    assert all(word in files["NOTICE"] for word in ("GSL", "University of Tennessee", "Redistribution and use"))


@pytest.mark.parametrize("missing", ["GSL_INCLUDE", "GSL_ARCHIVE", "LAPACK_ARCHIVE", "BLAS_ARCHIVE"])
def test_a_build_without_gsl_or_lapack_names_the_packages(missing, tmp_path):
    done = subprocess.run(["cmake", "-S", PACKAGE, "-B", tmp_path, f"-DRWEDGE_{missing}="], capture_output=True, text=True)
    message = " ".join(done.stderr.split())
    assert done.returncode != 0 and f"RWEDGE_{missing} was not found" in message
    assert "in the packages libgsl-dev, liblapack-dev and libblas-dev; elsewhere, build GSL with --enable-static" in message
