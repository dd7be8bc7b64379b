#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Every file says whose it is and under which terms, as the REUSE specification wants.
#     reuse.sh SOURCE BUILD
set -eu
top=$(cd "$1" && pwd)
tools=$(cd "$2" && pwd)/reuse
. "$top/tests/support/venv.sh"
venv "$top/tests/repository/packages/reuse.txt" "$tools"
git -C "$top" rev-parse HEAD >/dev/null 2>&1 || { echo 'SKIPPED: these files are no clone: what is built cannot be told apart'; exit 77; }
cmp "$top/LICENSE" "$top/LICENSES/GPL-3.0-or-later.txt"

"$tools/bin/reuse" --root "$top" lint --quiet || { "$tools/bin/reuse" --root "$top" lint; exit 1; }

echo "ok: $("$tools/bin/reuse" --root "$top" lint | sed -n 's/^\* Files with license information: //p') files"
