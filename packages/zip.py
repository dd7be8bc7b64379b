# SPDX-License-Identifier: GPL-3.0-or-later
"""zip.py ZIP SECONDS FOLDER: the folder as a zip, with that time on each file: the same bytes for the same content."""
import pathlib
import sys
import time
import zipfile

target, seconds, folder = sys.argv[1], int(sys.argv[2]), pathlib.Path(sys.argv[3])
date = time.gmtime(max(seconds, 315532800))[:6]  # a zip begins in 1980
with zipfile.ZipFile(target, "w") as archive:
    for path in sorted(path for path in folder.rglob("*") if path.is_file()):
        entry = zipfile.ZipInfo(path.relative_to(folder.parent).as_posix(), date)
        entry.compress_type = zipfile.ZIP_DEFLATED
        entry.create_system = 0  # Windows', whatever system makes it
        archive.writestr(entry, path.read_bytes(), compresslevel=9)
