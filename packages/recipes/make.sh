# SPDX-License-Identifier: GPL-3.0-or-later
# The recipes for others' package managers, filled in with the version, the place and the checksum of the source archive.
product='the recipes'
archive=rwedge-$version.tar.gz
who() { python3 -B "$top/packages/who.py" "$1"; }
need python3
[ -e "$packages/$archive" ] || leave_out "$archive is not here"

# fill FOLDER PLACE - the recipes into FOLDER, with the archive at PLACE
fill()
{
    mkdir -p "$1"
    (cd "$here" && find conan conda -type f) | while read -r file; do
        mkdir -p "$1/$(dirname "$file")"
        sed -e "s|@VERSION@|$version|; s|@ARCHIVE@|$2|; s|@URL@|$url|; s|@NAME@|$(who name)|" \
            -e "s|@SHA256@|$(sha256sum <"$packages/$archive" | cut -d ' ' -f 1)|" "$here/$file" >"$1/${file%.in}"
    done
}
url=$(who url)
url=${url:-https://example.invalid}
fill "$packages/recipes" "$url/releases/$archive"
has_tests || exit 0

. "$top/tests/support/venv.sh"
if ! reason=$(venv "$here/requirements.txt" "$build/conan"); then
    echo "not tested: recipes/: $reason" | tee -a "$tested"
    exit 77
fi
"$build/conan/bin/python" - "$packages/recipes/conda/recipe.yaml" <<'END'
import sys
from rattler_build import Stage0Recipe, VariantConfig
Stage0Recipe.from_file(sys.argv[1]).render(VariantConfig.from_yaml("c_compiler: [gcc]\nc_stdlib: [sysroot]"))
END
echo "tested: recipes/conda: rattler-build reads it and fills it in" >>"$tested"
echo "not tested: recipes/: conda as it builds, as its collection is not here" >>"$tested"
export CONAN_HOME="$build/conan/home"
rm -rf "$CONAN_HOME" "$build/recipes"
fill "$build/recipes" "file://$packages/$archive"
conan=$build/conan/bin/conan log=$build/conan/log
"$conan" profile detect >"$log" 2>&1
for shared in True False; do
    "$conan" create "$build/recipes/conan" -o "rwedge/*:shared=$shared" --no-remote >"$log" 2>&1 ||
        { tail -n 30 "$log"; echo "FAILED: recipes/conan, shared=$shared"; exit 1; }
done
echo "tested: recipes/conan: made with the shared and the static library, its test package runs" >>"$tested"
