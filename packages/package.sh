#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the package of a folder by its make.sh, and tests it as it is installed: by the end of that, or by the folder's test.sh. Both
# are sourced here. What was tested and what was not is added to the file TESTED. Without it nothing is tested.
#     package.sh FOLDER BUILD PACKAGES [TESTED]
set -eu
here=$(cd "$(dirname "$0")/$1" && pwd)
top=$(cd "$here/../.." && pwd)
build=$2 packages=$3 tested=${4-/dev/null}
version=$(sed -n 's/^project(rwedge VERSION \([0-9.]*\).*/\1/p' "$top/CMakeLists.txt")
epoch=$(git -C "$top" log -1 --format=%ct 2>/dev/null || stat -c %Y "$top/CHANGELOG.md")

# leave_out REASON - of $product, which make.sh names
leave_out() { echo "not made: $product: $*" | tee -a "$tested"; exit 77; }
fail() { echo "FAILED: $product: $*"; exit 1; }
has_tests() { [ "$tested" != /dev/null ]; }

# need COMMAND...
need()
{
    for command; do
        command -v "$command" >/dev/null || leave_out "$command is not here"
    done
}

. "$here/make.sh"
if has_tests && [ -f "$here/test.sh" ]; then
    . "$here/test.sh"
fi
