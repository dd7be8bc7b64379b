# SPDX-License-Identifier: GPL-3.0-or-later
"""check.py BUILD WHEEL...: what each wheel says of itself is so."""
import base64
import hashlib
import struct
import sys
import zipfile

# what is at the beginning of a shared library, where, for the machines of a platform's name
MACHINES = {
    "linux_x86_64": [(0, b"\x7fELF\x02\x01"), (18, struct.pack("<H", 62))],
    "linux_aarch64": [(0, b"\x7fELF\x02\x01"), (18, struct.pack("<H", 183))],
    "win_amd64": [(0, b"MZ")],
    "macosx_x86_64": [(0, struct.pack("<II", 0xFEEDFACF, 0x01000007))],
    "macosx_arm64": [(0, struct.pack("<II", 0xFEEDFACF, 0x0100000C))],
}


def machine(platform):
    system = "linux" if "linux" in platform else platform.partition("_")[0]
    return next(name for name in MACHINES if name.startswith(system) and platform.endswith(name.partition("_")[2]))


def check(build, path):
    wheel = zipfile.ZipFile(path)
    files = {name: wheel.read(name) for name in wheel.namelist()}
    about = next(name for name in files if name.endswith(".dist-info/WHEEL")).rpartition("/")[0]
    platform = path.rpartition("-")[2].removesuffix(".whl")
    tags = [line[5:] for line in files[f"{about}/WHEEL"].decode().splitlines() if line.startswith("Tag: ")]
    assert tags == [f"py3-none-{tag}" for tag in platform.split(".")], tags
    for row in files[f"{about}/RECORD"].decode().splitlines():
        name, digest, size = row.rsplit(",", 2)
        content = files.pop(name)
        if name != f"{about}/RECORD":
            assert int(size) == len(content), name
            assert digest == "sha256=" + base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode(), name
            assert build.encode() not in content, f"{name} names {build}"
        if name.startswith("rwedge/_rwedge."):
            library = content
            assert name.endswith(".dll") == (platform == "win_amd64"), name
    assert not files, f"not in RECORD: {sorted(files)}"
    for place, expected in MACHINES[machine(platform)]:
        assert library[place:place + len(expected)] == expected, f"not a library for {platform}"
    names = set(wheel.namelist())
    wanted = ["METADATA", "licenses/LICENSE", "licenses/NOTICE", "licenses/gsl.txt", "sboms/rwedge.spdx.json"]
    wanted += [] if platform.startswith("macosx") else ["licenses/lapack.txt"]
    assert not {f"{about}/{name}" for name in wanted} - names, "a licence or the list of what is inside is missing"


for path in sys.argv[2:]:
    check(sys.argv[1], path)
    print("its parts fit:", path.rpartition("/")[2])
