# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by scripts that need programs from PyPI. Where these cannot be had the script ends with 77.
host_python=$(python3 -c 'import sys; print(sys.executable)') || { echo 'SKIPPED: no python3'; exit 77; }
export PIP_DISABLE_PIP_VERSION_CHECK=1

# venv LIST FOLDER - a Python in FOLDER with what LIST names. It is made once; then it is kept until the list changes.
venv()
{
    wanted="$("$host_python" --version) $(cksum <"$1")"
    [ "$(cat "$2/fetched" 2>/dev/null)" != "$wanted" ] || return 0
    rm -rf "$2"
    mkdir -p "$2"
    # a pip of its own would take as long as all of the list
    own=''
    "$host_python" -c 'import pip; assert int(pip.__version__.split(".")[0]) > 22' 2>/dev/null && own=--without-pip
    "$host_python" -m venv $own "$2" >"$2/log" 2>&1 || { echo 'SKIPPED: python3 -m venv fails (Debian: python3-venv)'; exit 77; }
    fetch "$1" "$2"
    echo "$wanted" >"$2/fetched"
}

# fetch LIST FOLDER PIP-ARGUMENTS... - what LIST names, by version and checksum, for the Python in FOLDER. It compiles nothing: little
# of it is ever imported.
fetch()
{
    list=$1 place=$2
    shift 2
    pip_in "$place" install --quiet --no-compile --no-deps --require-hashes -r "$list" "$@" >"$place/log" 2>&1 && return
    echo "SKIPPED: pip cannot fetch what $list names: $(tail -n 1 "$place/log")"
    exit 77
}

# pip_in FOLDER PIP-ARGUMENTS... - for the Python in FOLDER, its own pip or that of the machine
pip_in()
{
    python=$1/bin/python
    shift
    if [ -x "${python%python}pip" ]; then "$python" -m pip "$@"; else "$host_python" -m pip --python "$python" "$@"; fi
}
