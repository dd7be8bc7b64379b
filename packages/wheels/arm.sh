#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The distribution's Python for ARM, NumPy, and musl, unpacked below FOLDER; the command FOLDER/python runs it through qemu-aarch64, and
# FOLDER/musl-gcc is this machine's compiler for ARM with musl. This machine's settings stay as they are.
#     arm.sh FOLDER
set -eu
mkdir -p "$1"
cd "$1"
folder=$PWD
[ ! -x musl-gcc ] || exit 0
rm -rf root numpy
mkdir -p lists/partial cache/archives/partial root/usr/lib numpy
ln -s usr/lib root/lib # as in an installed system: packages have files in both
: >status
apt()
{
    apt-get -qq -o APT::Architecture=arm64 -o APT::Architectures=arm64 -o Dir::State::Lists="$folder/lists" \
        -o Dir::State::status="$folder/status" -o Dir::Cache="$folder/cache" -o APT::Sandbox::User=root -o Debug::NoLocking=1 "$@"
}
apt update
apt install -y --no-install-recommends --download-only python3 libstdc++6
(cd cache/archives && apt download musl musl-dev) # without the compiler for ARM, on ARM, that the second asks for
for package in cache/archives/*.deb; do
    dpkg-deb --fsys-tarfile "$package" | tar -x --keep-directory-symlink -C root
done
version=$(cd root/usr/bin && echo python3.*[0-9])
python3 -m pip download --quiet --disable-pip-version-check --no-deps --only-binary=:all: --platform manylinux_2_28_aarch64 \
    --platform manylinux_2_27_aarch64 --platform manylinux2014_aarch64 --python-version "${version#python}" --dest . numpy
python3 -m zipfile -e numpy-*.whl numpy
cat >python <<END
#!/bin/sh
exec qemu-aarch64 -L '$folder/root' -E PYTHONPATH="\$PYTHONPATH:$folder/numpy" '$folder/root/usr/bin/python3' "\$@"
END
sed "s| /usr/| $folder/root/usr/|g; s|-L/usr/|-L$folder/root/usr/|g" root/usr/lib/aarch64-linux-musl/musl-gcc.specs >musl-gcc.specs
cat >musl-gcc <<END
#!/bin/sh
exec aarch64-linux-gnu-gcc "\$@" -specs '$folder/musl-gcc.specs'
END
chmod +x python musl-gcc # last: it stands for all of it
