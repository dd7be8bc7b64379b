#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs zig, a C compiler with headers and C library of every system, and writes the command FOLDER/zig:
#     FOLDER/zig cc -target aarch64-macos ...
# It comes from Python's package index, of one version and with one checksum, and needs Linux on x86-64. Quiet, unless it fails.
#     zig.sh FOLDER
set -eu
version=0.17.1
sum=ea6cc5d87b033cf0aedfbc8f9549a908cae6c50ac31f1698188fa48a74524b54
mkdir -p "$1"
cd "$1"
exec 9>lock # several packages may ask for it at a time
flock 9
[ "$(cat version 2>/dev/null)" != $version ] || exit 0
rm -rf venv
echo "ziglang==$version --hash=sha256:$sum" >requirements
if ! { python3 -m venv venv &&
    venv/bin/pip install --no-compile --disable-pip-version-check --require-hashes -r requirements; } >log 2>&1; then
    cat log >&2
    exit 1
fi
folder=$PWD
cat >zig <<END
#!/bin/sh
export ZIG_GLOBAL_CACHE_DIR='$folder/cache' ZIG_LOCAL_CACHE_DIR='$folder/cache'
exec '$(echo "$folder"/venv/lib/python3*/site-packages/ziglang/zig)' "\$@"
END
chmod +x zig
echo $version >version # last: it stands for all of it
