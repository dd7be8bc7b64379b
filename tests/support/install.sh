# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by tables/generate.sh and tests/run.sh: what they need, found or installed.

# have KIND:NAME - is the command on the path, the library known to pkg-config, the header where the compiler looks?
have()
{
    case $1 in
    python:*) python3 -c "import ${1#python:}" >/dev/null 2>&1 ;;
    command:*) command -v "${1#command:}" >/dev/null 2>&1 ;;
    library:*) pkg-config --exists "${1#library:}" 2>/dev/null ;;
    file:*) ls ${1#file:} >/dev/null 2>&1 ;; # a pattern
    header:*) echo "#include <${1#header:}>" | cc -E - >/dev/null 2>&1 ;;
    esac
}

# require KIND:NAME=PACKAGE ... - installs the Debian packages of what is missing as root or by sudo; elsewhere, or without
# the right to, says what to install and fails.
require()
{
    missing='' packages=''
    for need; do
        have "${need%=*}" && continue
        missing="$missing ${need%=*}"
        packages="$packages ${need#*=}"
    done
    [ -z "$missing" ] && return 0
    if ! command -v apt-get >/dev/null 2>&1; then
        echo "Please install:$missing (on Debian or Ubuntu the packages are$packages)." >&2
        return 1
    fi
    if [ "$(id -u)" -eq 0 ]; then
        as_root=''
    elif command -v sudo >/dev/null 2>&1 && sudo -n true 2>/dev/null; then
        as_root=sudo
    else
        echo "Missing:$missing. As root, please run: apt-get install$packages" >&2
        return 1
    fi
    echo "Installing$packages ..." >&2
    log=$(mktemp)
    # shellcheck disable=SC2086
    if ! { $as_root apt-get update && $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends \
            $packages; } >"$log" 2>&1; then
        tail -n 20 "$log" >&2
        echo "The packages could not be installed:$packages" >&2
        rm -f "$log"
        return 1
    fi
    rm -f "$log"
}

# wish KIND:NAME=PACKAGE ... - the same, but nothing fails for want of it: the tests that need it are skipped.
wish()
{
    require "$@" || echo "The tests go on without, and skip what needs it." >&2
}

# What the library and the tool are built with.
require_build_tools()
{
    require command:cc=gcc command:cmake=cmake command:make=make command:pkg-config=pkg-config &&
        require library:gsl=libgsl-dev library:lapack=liblapack-dev library:popt=libpopt-dev library:jansson=libjansson-dev \
            header:csv.h=libcsv-dev
}

# The processors of this machine.
processors()
{
    getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1
}
