# SPDX-License-Identifier: GPL-3.0-or-later
"""macho.py LIBRARY: what a shared library for macOS needs, from which version of macOS on, and the names that it offers."""
import pathlib
import struct
import sys

SYMBOLS, NEEDED, OLD_MINIMUM, MINIMUM = 0x2, 0xC, 0x24, 0x32  # the load commands that are read here
content = pathlib.Path(sys.argv[1]).read_bytes()


def text(place):
    return content[place:content.index(b"\0", place)].decode()


def minimum(place):
    version = struct.unpack_from("<I", content, place)[0]
    print(f"from macOS {version >> 16}.{version >> 8 & 255}")


def offered(table, count, names):
    for place in range(table, table + 16 * count, 16):
        name, kind = struct.unpack_from("<IB", content, place)
        if kind & 0x1 and kind & 0xE:  # external, and defined
            yield text(names + name).removeprefix("_")


place = 32
for _ in range(struct.unpack_from("<I", content, 16)[0]):
    command, size = struct.unpack_from("<II", content, place)
    if command == NEEDED:
        print("needs", text(place + struct.unpack_from("<I", content, place + 8)[0]))
    elif command in (OLD_MINIMUM, MINIMUM):
        minimum(place + (8 if command == OLD_MINIMUM else 12))
    elif command == SYMBOLS:
        names = sorted(offered(*struct.unpack_from("<III", content, place + 8)))
    place += size
print(*("offers " + name for name in names), sep="\n")
