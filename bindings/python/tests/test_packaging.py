# SPDX-License-Identifier: GPL-3.0-or-later
"""What an installed package says of itself."""
import importlib.metadata
import subprocess

from conftest import PACKAGE


def test_the_metadata_names_authors_licences_and_purposes():
    about = importlib.metadata.metadata("rwedge")
    assert about["Author"] and about["License-Expression"] == "GPL-3.0-or-later"
    assert {"Typing :: Typed", "Programming Language :: C"} <= set(about.get_all("Classifier"))
    assert "test" in about.get_all("Provides-Extra")
    files = {file.name: file.read_text() for file in importlib.metadata.files("rwedge") if "licenses" in file.parts}
    assert "GNU GENERAL PUBLIC LICENSE" in files["LICENSE"]
    assert all(word in files["NOTICE"] for word in ("GSL", "University of Tennessee", "Redistribution and use"))


def test_a_build_without_lapack_names_the_packages(tmp_path):
    done = subprocess.run(["cmake", "-S", PACKAGE, "-B", tmp_path, "-DRWEDGE_LAPACK_ARCHIVE="], capture_output=True, text=True)
    message = " ".join(done.stderr.split())
    assert done.returncode != 0 and "RWEDGE_LAPACK_ARCHIVE was not found" in message
    assert "in the packages libgsl-dev, liblapack-dev and libblas-dev; elsewhere, build GSL with --enable-static" in message
