# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures: the command of each, and the functions that it is about. They make the gallery."""
from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

from languages import TOP

PAD = "--E1 72100 --nu1 0.33 --theta 0.05 --radius 10 --f 0.3"
CYCLE = f"{PAD} --load 135.75,0,0,0 --load 135.75,0,38.75,100 --load 135.75,0,-38.75,-100"
# file: what is to be seen, the command, the functions
FIGURES = {
    "pressure": ("Contact pressure for several a/b (the paper's Fig. 2)", "2", "pressure peak_pressure transition_pressure"),
    "normal-limit": ("Elastic limit under a normal load, and the depth of the point that yields (Fig. 3)", "3",
                     "subsurface_yield surface_yield"),
    "elastic-limit": ("Elastic limit in full sliding over the friction (Fig. 4)", "4",
                      "elastic_limit elastic_limits critical_friction yield_load"),
    "yield-point": ("Path of the point that yields as friction grows (Fig. 5)", "5", "yield_point"),
    "max-tension": ("Largest tension at the trailing edge (Fig. 6)", "6", "max_tension"),
    "unlike-limit": ("Elastic limit of unlike bodies in full sliding, against similar ones (Fig. 4)", "unlike-limit", "sliding_limit"),
    "unlike-tension": ("Largest tension of unlike bodies, the pad held and free to tilt (Fig. 6)", "unlike-tension",
                       "sliding_law coupling"),
    "shear": ("Shear traction in partial slip (Fig. 7)", "7", "shear stick_width shear_ratio contact_tractions"),
    "von-mises": ("Von Mises' stress below a contact in partial slip", "field --a-over-b 0.25 --friction 0.6 --c-over-b 0.4",
                  "stress stresses von_mises contact_stresses"),
    "loop": ("Loops of a cycle of Q under constant P: their area is the energy", "loop", "contact_load contact_dissipated_energy contact_slip"),
    "eccentric": ("Stick zone off the centre, where a bulk tension grows with Q", "eccentric",
                  "contact_apply contact_stick_zone contact_permanent_stick cycle_permanent_stick contact_largest_tension_step"),
    "history-loop": ("The loop of a history with bulk tension", f"loop {CYCLE} --cycles 2", ""),
    "history": ("Stresses at the trailing edge in the last cycle", f"history {CYCLE} --cycles 2 --at -0.2067,0", "contact_stress_history"),
    "fretting": ("Smith, Watson and Topper's parameter along the surface", f"fretting {CYCLE}",
                 "criterion criterion_field"),
    "measure": ("Its contours around the edge: at 1, 2 and 5 times powers of ten", f"measure {CYCLE} --over field", ""),
    "contact": ("A pad as it touches, its loads, and what sticks", f"contact {PAD} --load 135.75,0 --load 135.75,25", "contact_edges"),
    "tractions": ("Pressure and shear under these loads", f"tractions {PAD} --load 135.75,0 --load 135.75,25", ""),
    "stress": ("Von Mises' stress under these loads", f"stress {PAD} --load 135.75,0 --load 135.75,25", "contact_yield_factor"),
}
WORKED = "bindings/python/examples"
CASES = {"calculix": "", "crack_elements": "", "design": "--rows 60 --columns 41 --workers 0 --check 1", "dovetail": "", "fretting": "", "pads": "", "phase": "", "rig": "",
         "spectrum": "", "total_life": ""}


def can_run(case: str) -> bool:
    return case not in ("calculix", "crack_elements") or shutil.which("ccx") is not None


def shown(name: str, up: str = "") -> list[str]:
    title, command, _ = FIGURES[name]
    return [f"![{title}]({up}figures/{name}.svg)", "", "```sh", f"rwedge figure {command} -o {name}.svg", "```", ""]


def of(function: str) -> list[str]:
    """The figure on the page of a function, if there is one."""
    name = next((n for n, (_, _, functions) in FIGURES.items() if function in functions.split()), None)
    return ["## Figure", "", FIGURES[name][0] + ".", "", *shown(name, "../")] if name else []


def gallery() -> str:
    lines = ["# Gallery", "", "Each figure with the command that draws it. `rwedge figure` has options for other numbers.", ""]
    for name, (title, _, functions) in FIGURES.items():
        about = ", ".join(f"[`rwedge_{f}()`](functions/{f}.md)" for f in functions.split())
        lines += [f"## {title}", "", *shown(name), *([f"See {about}.", ""] if about else [])]
    for name in filter(can_run, CASES):
        lines += [f"## Worked case: {name}", "", f"![{name}](figures/{name}-case.svg)", "", "```sh",
                  f"python {WORKED}/{name}.py {name}.svg", "```", "", f"[What it is]({WORKED}/README.md)", ""]
    return "\n".join(lines)


def draw(tool: str, folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for name, (_, command, _) in FIGURES.items():
        subprocess.run([tool, "figure", *command.split(), "-o", str(folder / f"{name}.svg")], check=True)
    for name in filter(can_run, CASES):
        subprocess.run([sys.executable, "-B", TOP / WORKED / f"{name}.py", folder / f"{name}-case.svg", *CASES[name].split()],
                       check=True, stdout=subprocess.DEVNULL, env={**os.environ, "RWEDGE_TOOL": tool})
