# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced: Wine in a prefix of its own below $work, without a display, no program longer than five minutes. Debian has it outside of the
# path.
PATH=$PATH:/usr/lib/wine
wine=$(command -v wine64 || command -v wine) || wine=''
server=$(command -v wineserver || command -v wineserver64) || server=''

end_wine()
{
    WINEPREFIX=$work/wine "$server" -k 2>/dev/null || true
    rm -rf "$work/wine"
}
on_windows()
{
    env -u DISPLAY LC_ALL=C.UTF-8 HOME="$work" WINEPREFIX="$work/wine" WINEDEBUG=-all \
        WINEDLLOVERRIDES='mscoree=;mshtml=;winemenubuilder.exe=' timeout -k 5 300 "$wine" "$@"
}
start_wine()
{
    end_wine
    # The server stays: it would leave after three idle seconds, and a program that starts in that moment loses it.
    mkdir -p "$work/wine"
    WINEPREFIX=$work/wine "$server" -p
    on_windows wineboot -i >"$work/wine.log" 2>&1 || { echo "FAILED: wine does not start: $(tail -n 1 "$work/wine.log")"; exit 1; }
}
