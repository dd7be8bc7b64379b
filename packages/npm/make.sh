# SPDX-License-Identifier: GPL-3.0-or-later
# The npm package. With TESTED it is the one that the tests of the binding have packed and installed.
product='the npm package'
log=$build/npm.log
need node npm python3
made_and_packed()
(
    sh "$top/bindings/web/build.sh" "$build" && cd "$build/web/package" && mkdir -p ../packed &&
        npm pack --silent --pack-destination ../packed
)
set -- made_and_packed
! has_tests || set -- sh "$top/bindings/web/test.sh" "$build"
"$@" >"$log" 2>&1 && status=0 || status=$?
case $status in
0) ;;
77) leave_out "$(tail -n 1 "$log")" ;;
*) tail -n 20 "$log"; exit 1 ;;
esac
python3 -B "$top/packages/sbom.py" "$version" "$epoch" "$build/web/sources" wasm32 gsl wasi-libc libclang-rt-dev-wasm32 \
    >"$packages/rwedge-$version-npm.spdx.json"
cp "$build/web/packed/rwedge-$version.tgz" "$packages/rwedge-$version-npm.tgz"
echo "tested: rwedge-$version-npm.tgz: installed in an empty folder, the binding's tests in Node $(node --version)" >>"$tested"
echo "not tested: rwedge-$version-npm.tgz: other versions of Node; browsers" >>"$tested"
