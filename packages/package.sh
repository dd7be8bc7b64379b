# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by each make.sh: its folder is $here, its arguments are BUILD PACKAGES [TESTED], it makes $product.
top=$(cd "$here/../.." && pwd)
build=$1 packages=$2 tested=${3-/dev/null}
version=$(sed -n 's/^project(rwedge VERSION \([0-9.]*\).*/\1/p' "$top/CMakeLists.txt")
epoch=$(git -C "$top" log -1 --format=%ct 2>/dev/null || stat -c %Y "$top/CHANGELOG.md")

# leave_out REASON
leave_out() { echo "not made: $product: $*" | tee -a "$tested"; exit 77; }

# need COMMAND...
need()
{
    for command; do
        command -v "$command" >/dev/null || leave_out "$command is not here"
    done
}
