#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Compares the library with a program of others, which is fetched into BUILD/others/.
#     test.sh BUILD LIBRARY contact_mechanics | tamaas | pylife
set -eu
here=$(cd "$(dirname "$0")" && pwd)
tools=$(cd "$1" && pwd)/others/$3
library=$2
. "$here/../support/venv.sh"
venv "$here/packages/$3.txt" "$tools"
export PYTHONDONTWRITEBYTECODE=1
exec "$tools/bin/python" "$here/published.py" "$library" "$3"
