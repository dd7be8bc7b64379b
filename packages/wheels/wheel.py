# SPDX-License-Identifier: GPL-3.0-or-later
"""wheel.py BASE LIBRARY PLATFORM SECONDS ADDED FOLDER: writes the wheel for a platform into the folder.

It is the wheel BASE with another shared library and other tags, and with the files of ADDED among those that tell about it. The
same bytes for the same content.
"""
import base64
import hashlib
import pathlib
import sys
import time
import zipfile

base, library, platform, seconds, added, folder = sys.argv[1:]
library, added, date = pathlib.Path(library), pathlib.Path(added), time.gmtime(max(int(seconds), 315532800))[:6]  # a zip begins in 1980
with zipfile.ZipFile(base) as archive:
    files = {name: archive.read(name) for name in archive.namelist() if not name.startswith("rwedge/_rwedge.")}
about = next(name for name in files if name.endswith(".dist-info/WHEEL")).rpartition("/")[0]
del files[f"{about}/RECORD"]
files[f"rwedge/{library.name}"] = library.read_bytes()
files.update({f"{about}/{path.relative_to(added).as_posix()}": path.read_bytes() for path in added.rglob("*") if path.is_file()})
kept = [line for line in files[f"{about}/WHEEL"].decode().splitlines() if line and not line.startswith("Tag:")]
files[f"{about}/WHEEL"] = "".join(line + "\n" for line in [*kept, *(f"Tag: py3-none-{tag}" for tag in platform.split("."))]).encode()


def row(name):
    digest = base64.urlsafe_b64encode(hashlib.sha256(files[name]).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(files[name])}\n"


names = sorted(files, key=lambda name: (name.startswith(about), name))  # the package, then what is said about it
files[f"{about}/RECORD"] = ("".join(map(row, names)) + f"{about}/RECORD,,\n").encode()
wheel = pathlib.Path(folder) / f"{about.removesuffix('.dist-info')}-py3-none-{platform}.whl"
with zipfile.ZipFile(wheel, "w") as archive:
    for name in [*names, f"{about}/RECORD"]:
        entry = zipfile.ZipInfo(name, date)
        entry.compress_type, entry.external_attr = zipfile.ZIP_DEFLATED, 0o644 << 16
        archive.writestr(entry, files[name], compresslevel=9)
print(wheel)
