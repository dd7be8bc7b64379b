#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# libFuzzer ends with 77 after a finding. CTest would take 77 for a skip, so run.sh must fail with another status.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
printf '#!/bin/sh\nexit 77\n' >"$work/fuzz_nothing"
chmod +x "$work/fuzz_nothing"
status=0
sh "$here/run.sh" "$here/../.." "$work" nothing 1 || status=$?
[ $status -eq 1 ] || { echo "FAILED: run.sh ends with $status after a finding"; exit 1; }
