#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Tests the package: test.sh [--long] BUILD_FOLDER [PYTEST-ARGUMENTS...]
#     --long   also what takes long, what needs pandas, xarray, dask, mypy, zarr or jax, the source distribution, and an older NumPy
# Everything goes into BUILD_FOLDER/python. What comes from PyPI is kept there for the next time. Ends with 77 where there is no Python
# or no way to PyPI.
set -eu
source=$(cd "$(dirname "$0")" && pwd)
long=no
[ "${1:?usage: test.sh [--long] BUILD_FOLDER [PYTEST-ARGUMENTS...]}" != --long ] || { long=yes; shift; }
mkdir -p "$1"
build=$(cd "$1" && pwd)
shift
[ $long = yes ] || set -- -m 'not long' "$@"
folder=$build/python
[ ! -x "$build/cli/rwedge" ] || export RWEDGE_TOOL="$build/cli/rwedge" # reads files
export MPLCONFIGDIR="$folder/matplotlib" MYPY_CACHE_DIR="$folder/mypy"

# versions and checksums; bindings/python/README.md says how they are renewed
locked=$source/tests/packages
. "$source/../../tests/support/venv.sh"
venv "$locked/everyday.txt" "$folder/venv"
if [ $long = yes ]; then
    fetch "$locked/long.txt" "$folder/venv"
    fetch "$locked/gradients.txt" "$folder/venv"
fi

sh "$source/../../tests/answers/answers.sh" "$build"
SKBUILD_BUILD_DIR=$folder/package pip_in "$folder/venv" install --quiet --no-build-isolation --no-deps --no-index \
    --force-reinstall --config-settings=cmake.define.RWEDGE_INSTALLED="$build/private/prefix" "$source"

# pytest_of TESTS...
pytest_of()
{
    echo "== NumPy $("$folder/venv/bin/python" -c 'import numpy; print(numpy.__version__)')"
    RWEDGE_ANSWERS=$build/private/answers "$folder/venv/bin/python" -m pytest -c "$source/pyproject.toml" \
        --rootdir "$source" -p no:cacheprovider --quiet --no-header "$@"
}

cd "$folder"
export PATH="$folder/venv/bin:$PATH" PYTHONPYCACHEPREFIX="$folder/pycache"
pytest_of "$source/tests" "$@"
python -B "$source/../../packages/docs/pages.py" --answers

[ $long = yes ] || exit 0
command -v ccx >/dev/null 2>&1 || echo "SKIPPED: ccx is not installed: examples/calculix.py and crack_elements.py did not run"

# An editable install is found.
rm -rf editable
SKBUILD_BUILD_DIR=$folder/package pip_in "$folder/venv" install --quiet --no-build-isolation --no-deps --no-index --ignore-installed \
    --prefix "$folder/editable" -e "$source"
python -B -c "
import glob, site, sys
site.addsitedir(glob.glob('$folder/editable/lib/*/site-packages')[0])
import rwedge
assert rwedge.__file__ == '$source/src/rwedge/__init__.py', rwedge.__file__
print('editable:', rwedge.load(0.25))"

# The source distribution is whole: its own tests pass from it, with what it is built to. Its files have old dates: an earlier build
# would count as newer.
rm -rf sdist package_sdist
mkdir sdist
(cd "$source" && python -c "from scikit_build_core.build import build_sdist; build_sdist('$folder/sdist')" >/dev/null)
rm -r "$source/library" # what went into it
tar -xzf sdist/*.tar.gz -C sdist --strip-components=1
SKBUILD_BUILD_DIR=$folder/package_sdist pip_in "$folder/venv" install --quiet --no-build-isolation --no-deps --no-index --force-reinstall ./sdist
(source=$folder/sdist && pytest_of "$folder/sdist/tests" -k "not sweep and not finite_elements and not as_fast" "$@")

older=$folder/venv/older
[ -d "$older/numpy" ] || fetch "$locked/older.txt" "$folder/venv" --target "$older"
export PYTHONPATH="$older"
pytest_of "$source/tests/test_formulas.py" "$source/tests/test_contact.py" "$source/tests/test_stress_history.py" \
    "$source/tests/test_series.py" -m 'not long' "$@"
