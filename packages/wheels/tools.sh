#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Writes FOLDER/TARGET-gcc, -ar, -gfortran and -nm, which are for ../dependencies.sh what a GNU toolchain has. zig compiles C. flang
# makes intermediate code of Fortran, once for all targets, in FOLDER/ir; zig compiles it; -nm tells what it calls.
#     tools.sh ZIG FLANG FOLDER TARGET
set -eu
zig=$1 flang=$2 target=$4
mkdir -p "$3/ir"
cd "$3"
folder=$PWD

# tool NAME - a script, from what comes in
tool()
{
    { echo '#!/bin/sh'; cat; } >"$target-$1"
    chmod +x "$target-$1"
}
tool gcc <<EOF
[ "\$1" != -dumpmachine ] || { echo $target; exit; }
exec '$zig' cc -target $target -fPIC "\$@"
EOF
tool ar <<EOF
exec '$zig' ar "\$@"
EOF
# ... -o OBJECT, last. What names the machine that flang took it for is left out.
tool gfortran <<EOF
set -e
for object; do :; done
ir='$folder/ir/'\$(basename "\$object" .o).ll
if [ ! -f "\$ir" ]; then
    '$flang' "\$@" -S -emit-llvm
    sed '/^target /d; s/^define /&hidden /; s/ = linkonce /&hidden /' "\$object" >"\$ir.new"
    mv "\$ir.new" "\$ir"
fi
exec '$zig' cc -target $target -fPIC -O2 -ffp-contract=off -Wno-override-module -c "\$ir" -o "\$object"
EOF
# -u OBJECTS
tool nm <<EOF
shift
for object; do
    sed -n 's/^declare .*@\([a-z][a-z0-9_]*_\)(.*/ U \1/p' '$folder/ir/'\$(basename "\$object" .o).ll
done
EOF
