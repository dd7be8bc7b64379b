#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The distribution's Python for ARM, and NumPy, unpacked below FOLDER; the command FOLDER/python runs it through qemu-aarch64. This
# machine's settings stay as they are.
#     arm.sh FOLDER
set -eu
mkdir -p "$1"
cd "$1"
[ ! -f ready ] || exit 0
rm -rf root numpy
mkdir -p lists/partial cache/archives/partial root numpy
: >status
apt()
{
    apt-get -qq -o APT::Architecture=arm64 -o APT::Architectures=arm64 -o Dir::State::Lists="$PWD/lists" \
        -o Dir::State::status="$PWD/status" -o Dir::Cache="$PWD/cache" -o APT::Sandbox::User=root -o Debug::NoLocking=1 "$@"
}
apt update
apt install -y --no-install-recommends --download-only python3 libstdc++6
for package in cache/archives/*.deb; do
    dpkg-deb -x "$package" root
done
version=$(cd root/usr/bin && echo python3.*[0-9])
python3 -m pip download --quiet --disable-pip-version-check --no-deps --only-binary=:all: --platform manylinux_2_28_aarch64 \
    --platform manylinux_2_27_aarch64 --platform manylinux2014_aarch64 --python-version "${version#python}" --dest . numpy
python3 -m zipfile -e numpy-*.whl numpy
cat >python <<END
#!/bin/sh
exec qemu-aarch64 -L '$PWD/root' -E PYTHONPATH="\$PYTHONPATH:$PWD/numpy" '$PWD/root/usr/bin/python3' "\$@"
END
chmod +x python
touch ready
