# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints what a Tab makes of a line in fish, on a terminal of its own: the arguments that the command rwedge is then given.
    fish_tab.py COMPLETIONS LINE"""
import os
import pty
import re
import sys


def main(completions, line):
    setup = (f"source {completions}; function fish_prompt; echo READY; end;"
             "function rwedge; echo '<<'(string join ' ' -- $argv)'>>'; exit; end")
    pid, terminal = pty.fork()
    if pid == 0:
        os.execvp("fish", ["fish", "--no-config", "--interactive", "--init-command", setup])
    seen, typed = "", False
    while not (inserted := re.search("<<(.*?)>>", seen)):
        more = os.read(terminal, 4096).decode(errors="replace")
        seen += more
        if re.search("\x1b\\[0?c", more):  # fish asks what terminal this is
            os.write(terminal, b"\x1b[?62;c")
        if "READY" in seen and not typed:
            os.write(terminal, (line + "\t\r").encode())
            typed = True
    print(inserted.group(1))


main(*sys.argv[1:])
