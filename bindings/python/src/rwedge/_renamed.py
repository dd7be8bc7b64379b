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
    **{f"{name}_field": f"criterion_field(criterion, constants, ...), or {name}(..., axis=0)" for name in
       ("smith_watson_topper", "smith_watson_topper_planes", "fatemi_socie", "fatemi_socie_planes", "findley", "modified_wohler",
        "mcdiarmid", "crossland", "dang_van")},
    **{f"{name}_damage_field": f"damage_field(criterion, constants, ...), or {name}_damage(..., axis=0)" for name in
       ("smith_watson_topper", "fatemi_socie")},
}


def now_called(name: str) -> str:
    """What an AttributeError says of an old name; nothing of others."""
    return f"rwedge.{name} has another name since version 2.0: {_RENAMED[name]}" if name in _RENAMED else ""
