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
# Now and then a program cannot reach Wine's server. Then it has not begun: it fails, and says nothing or "wine client error". It is
# run again. Programs of ours say why they fail.
on_windows()
{
    wine_said=$(mktemp)
    for attempt in 1 2 3; do
        wine_status=0
        env -u DISPLAY LC_ALL=C.UTF-8 HOME="$work" WINEPREFIX="$work/wine" WINEDEBUG=-all \
            WINEDLLOVERRIDES='mscoree=;mshtml=;winemenubuilder.exe=' timeout -k 5 300 "$wine" "$@" 2>"$wine_said" || wine_status=$?
        [ "$wine_status" -ne 0 ] && [ "$wine_status" -ne 124 ] || break
        [ ! -s "$wine_said" ] || grep -q '^wine client error' "$wine_said" || break
        echo "attempt $attempt: $(cat "$wine_said")" >>"$work/wine.log"
    done
    cat "$wine_said" >&2
    rm -f "$wine_said"
    return "$wine_status"
}
start_wine()
{
    end_wine
    # The server stays: it would leave after three idle seconds, and a program that starts in that moment loses it.
    mkdir -p "$work/wine"
    WINEPREFIX=$work/wine "$server" -p
    on_windows wineboot -i >"$work/wine.log" 2>&1 || { echo "FAILED: wine does not start: $(tail -n 1 "$work/wine.log")"; exit 1; }
}
