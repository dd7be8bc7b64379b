# SPDX-License-Identifier: GPL-3.0-or-later
# How C becomes WebAssembly: with vectors of two numbers, which every browser has since 2023.
# shellcheck shell=sh disable=SC2034
options='--target=wasm32-wasi -msimd128 -std=gnu99 -O2 -DNDEBUG -ffp-contract=off'
