# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by tables/generate.sh and tests/run.sh. It finds or installs what they need.

# accept_path PATH - ends with status 2 where the path has a character that CMake, or the make that it writes for, does not take.
accept_path()
{
    accepted=$(printf '%s' "$1" | tr -d '#;$\\":[],|\n\t')
    [ "$accepted" = "$1" ] && return
    printf '%s: CMake does not take this path: no # ; $ \\ " : , | [ ], newline or tab, please.\n' "$1" >&2
    exit 2
}

# have KIND:NAME - is it there: a command on the path, a library that pkg-config knows, a header where the compiler looks, a module of
# one of the Pythons?
have()
{
    case $1 in
    python:*) python3 -c "import ${1#python:}" >/dev/null 2>&1 ;;
    module:*) python_with "${1#module:}" >/dev/null ;;
    command:*) command -v "${1#command:}" >/dev/null 2>&1 ;;
    library:*) pkg-config --exists "${1#library:}" 2>/dev/null ;;
    file:*) ls ${1#file:} >/dev/null 2>&1 ;; # a pattern
    header:*) echo "#include <${1#header:}>" | cc -E - >/dev/null 2>&1 ;;
    esac
}

# python_with MODULE - prints the Python that has the module: the one on the path, or that of the distribution.
python_with()
{
    for each in python3 /usr/bin/python3; do
        "$each" -c "import $1" >/dev/null 2>&1 && echo "$each" && return
    done
    return 1
}

# install_packages PACKAGES... - the Debian packages, as root or by sudo. Elsewhere, or without the right to, it says what to install and
# fails: with status 1, or 2 where the distribution does not have them.
install_packages()
{
    if ! command -v apt-get >/dev/null 2>&1; then
        echo "Please install:$missing (on Debian or Ubuntu the packages are $*)." >&2
        return 1
    fi
    if [ "$(id -u)" -eq 0 ]; then
        as_root=''
    elif command -v sudo >/dev/null 2>&1 && sudo -n true 2>/dev/null; then
        as_root=sudo
    else
        echo "Missing:$missing. As root, please run: apt-get install $*" >&2
        return 1
    fi
    echo "Installing $* ..." >&2
    log=$(mktemp) done=no
    if $as_root apt-get update >"$log" 2>&1; then
        if ! apt-get install --simulate --no-install-recommends "$@" >"$log" 2>&1; then
            done=never
        elif $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "$@" >"$log" 2>&1; then
            done=yes
        fi
    fi
    [ $done = yes ] || { tail -n 20 "$log"; echo "The packages could not be installed: $*"; } >&2
    rm -f "$log"
    case $done in yes) return 0 ;; no) return 1 ;; never) return 2 ;; esac
}

# require KIND:NAME=PACKAGE[,PACKAGE...] ... - installs the packages of what is missing, or fails as install_packages() does.
require()
{
    missing='' packages=''
    for need; do
        have "${need%%=*}" && continue
        missing="$missing ${need%%=*}"
        packages="$packages $(echo "${need#*=}" | tr , ' ')"
    done
    # shellcheck disable=SC2086
    [ -z "$missing" ] || install_packages $packages
}

# wish KIND:NAME=PACKAGE ... - the same, but nothing fails for want of it. What this distribution does not have is added to the
# list $not_in_distribution.
not_in_distribution=''
wish()
{
    require "$@" && return
    for need; do
        require "$need" 2>/dev/null && continue
        [ $? = 2 ] && not_in_distribution="$not_in_distribution ${need%%=*}"
        echo "Without ${need%%=*} what needs it is left out." >&2
    done
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
