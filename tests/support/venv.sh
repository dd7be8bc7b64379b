# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by tests that need programs from PyPI.

# venv LIST FOLDER - a Python in FOLDER with what LIST names, by version and checksum. It is made once; then it is kept until the
# list changes. Where it cannot be had the test ends with 77.
venv()
{
    command -v python3 >/dev/null 2>&1 || { echo 'SKIPPED: no python3'; exit 77; }
    wanted="$(python3 --version) $(cksum <"$1")"
    [ "$(cat "$2/fetched" 2>/dev/null)" != "$wanted" ] || return 0
    rm -rf "$2"
    mkdir -p "$2"
    python3 -m venv "$2" >"$2/log" 2>&1 || { echo 'SKIPPED: python3 -m venv fails (Debian: python3-venv)'; exit 77; }
    "$2/bin/pip" install --quiet --disable-pip-version-check --no-compile --require-hashes -r "$1" >"$2/log" 2>&1 || {
        echo "SKIPPED: pip cannot fetch what $1 names: $(tail -n 1 "$2/log")"
        exit 77
    }
    echo "$wanted" >"$2/fetched"
}
