# SPDX-License-Identifier: GPL-3.0-or-later
"""What stood under another name before version 2.0, and what serves now: bindings/README.md has the table for all languages."""
from __future__ import annotations

_RENAMED = {
    "permanent_stick": "Contact.permanent_stick()",
    "Contact.cycle": "Contact.stresses_after(loads, x, y)",
    "Contact.cycle_friction": "Contact.cycle(loads).friction(x)",
    "Contact.cycle_worst": "Contact.cycle(loads).worst(measure, ...)",
    "Contact.cycle_below": "Contact.cycle(loads).below(x, angle, length, line)",
    "Contact.keep_cycle": "Contact.cycle(loads)",
}


def now_called(name: str) -> str:
    """What an AttributeError says of an old name; nothing of others."""
    return f"rwedge.{name} has another name since version 2.0: {_RENAMED[name]}" if name in _RENAMED else ""
