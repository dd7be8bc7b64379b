# SPDX-License-Identifier: GPL-3.0-or-later
"""The closed form beside finite elements: a rounded wedge is pressed on a half-plane and sheared in CalculiX (Debian's package
calculix-ccx); surface tractions and stresses of both, as the mesh is refined.                   calculix.py PICTURE --refine 2

Two elastic bodies of the same steel, in the shape that the theory takes for flat: the wedge has its angle and its rounding. They
reach 4000 contact half-widths far, so that they stand for half-planes: there the one is held, and the other moves as a whole.
Elements have eight nodes in one layer of plane strain. Their edges follow ellipses and hyperbolas around the contact: fine where
tractions change, coarse far away. Friction is Coulomb's, contact between faces by penalty.

Units are N and mm, so that stresses are MPa and forces are per mm of thickness.
"""
import math
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

import numpy as np
import shown

import rwedge
from rwedge import plot

E, NU, F, THETA, A_OVER_B = 200e3, 0.3, 0.5, 0.01, 0.5
COMPLIANCE = rwedge.compliance(E, NU, E, NU)
B = 1.0  # half-width of the contact under P
ROUNDING = A_OVER_B * B
P = rwedge.normal_load(THETA, ROUNDING, COMPLIANCE, B)
Q = 0.6 * F * P
FOCUS, FAR, TOUCHING = 1.1 * B, 4000 * B, 1.35 * B  # of the ellipses; the outermost one; where faces may touch
# Elements along the surface between the foci, and how many more in the next mesh. With 24 ccx ends in a wrong state under P alone.
COARSE, FINER = 16, 2.25
PENALTY, STICK = 300 * E / B, 100 * E / B
OVERLAP = 0.05 * THETA * B  # at the apex, before any load: so bodies hold each other from the first iteration on


def profile(x):
    """The gap of the undeformed wedge: a parabola, and flanks that go on in its tangents."""
    return np.where(abs(x) < ROUNDING, x**2 * THETA / (2 * ROUNDING), THETA * (abs(x) - ROUNDING / 2))


class Mesh:
    """Columns of nodes from the surface to the outer ellipse: number[i, j], j into the depth."""

    def __init__(self, along):
        reach = math.acosh(FAR / FOCUS)
        v, w = np.meshgrid(np.linspace(-math.pi / 2, math.pi / 2, along + 1),
                           np.linspace(0, reach, round(along / math.pi * reach) + 1), indexing="ij")
        self.x, self.y = FOCUS * np.sin(v) * np.cosh(w), FOCUS * np.cos(v) * np.sinh(w)
        self.y[[0, -1]] = 0  # the surface beside the contact, to the bit
        self.number = np.arange(self.x.size).reshape(self.x.shape) + 1
        n = self.number
        self.elements = np.stack([n[:-1, :-1], n[1:, :-1], n[1:, 1:], n[:-1, 1:]], axis=-1).reshape(-1, 4)

    def touching(self, left, right):
        """(element, face) where bodies may touch: the faces 3 between the foci, and those of the columns at both sides."""
        along, deep = (size - 1 for size in self.number.shape)
        element = np.arange(along * deep).reshape(along, deep) + 1
        beside = np.flatnonzero(self.x[-1, 1:] < TOUCHING)
        return [*((k, 3) for k in element[:, 0]), *((element[0, k], left) for k in beside), *((element[-1, k], right) for k in beside)]


def lines(rows):
    return "\n".join(", ".join(f"{value:.15g}" if isinstance(value, float) else str(value) for value in row) for row in rows)


def deck(mesh):
    """CalculiX's input: first P, then Q. The half-plane's nodes come first, then those of the wedge, its mirror image behind
    its profile; then both again at z = 1. The wedge's outer nodes move as the last node does, on which the loads act."""
    size = mesh.x.size
    lower = np.column_stack([mesh.x.ravel(), mesh.y.ravel()])
    upper = np.column_stack([lower[:, 0], OVERLAP - lower[:, 1] - profile(lower[:, 0])])
    places = np.concatenate([lower, upper])
    nodes = [(i + 1 + layer * 2 * size, float(x), float(y), layer) for layer in (0, 1) for i, (x, y) in enumerate(places)]
    both = np.concatenate([mesh.elements, mesh.elements[:, [1, 0, 3, 2]] + size])
    elements = [(i + 1, *four, *(four + 2 * size)) for i, four in enumerate(both)]
    whole = 4 * size + 1
    outer = [int(node) + 2 * layer * size for node in mesh.number[:, -1] for layer in (0, 1)]
    lower_faces = mesh.touching(6, 4)
    upper_faces = [(element + len(mesh.elements), face) for element, face in mesh.touching(4, 6)]
    tied = "\n".join(f"*EQUATION\n2\n{node + size}, {axis}, 1., {whole}, {axis}, -1." for node in outer for axis in (1, 2))
    return f"""*NODE, NSET=ALL
{lines(nodes)}
*NODE
{whole}, 0, 0, 0
*ELEMENT, TYPE=C3D8, ELSET=STEEL
{lines(elements)}
*NSET, NSET=HALFPLANE, GENERATE
1, {size}
*MATERIAL, NAME=STEEL
*ELASTIC
{E}, {NU}
*SOLID SECTION, ELSET=STEEL, MATERIAL=STEEL
*SURFACE, NAME=LOWER, TYPE=ELEMENT
{lines((element, f"S{face}") for element, face in lower_faces)}
*SURFACE, NAME=UPPER, TYPE=ELEMENT
{lines((element, f"S{face}") for element, face in upper_faces)}
*SURFACE INTERACTION, NAME=TOUCH
*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR
{PENALTY}
*FRICTION
{F}, {STICK}
*CONTACT PAIR, INTERACTION=TOUCH, TYPE=SURFACE TO SURFACE
UPPER, LOWER
{tied}
*BOUNDARY
ALL, 3, 3
{lines((node, 1, 2) for node in outer)}
*STEP, INC=200
*STATIC
0.25, 1., 1e-5, 1.
*CLOAD
{whole}, 2, {P:.15g}
*END STEP
*STEP, INC=200
*STATIC
0.25, 1., 1e-5, 0.25
*CLOAD
{whole}, 1, {Q:.15g}
*CONTACT FILE
CDIS, CSTR
*EL FILE, NSET=HALFPLANE
S
*END STEP
"""


def last(name, results, nodes):
    """The six numbers at each of the nodes in the last block of that name of a .frd file; NaN where there are none."""
    block = results.rsplit(f" -4  {name}", 1)[1].split("\n -3", 1)[0]
    numbers = {int(line[3:13]): [float(line[13 + 12 * k:25 + 12 * k]) for k in range(6)]
             for line in block.split("\n") if line.startswith(" -1")}
    return np.array([numbers.get(int(node), [math.nan] * 6) for node in nodes]).T


def finite_elements(mesh, folder):
    """CalculiX's p, q at the nodes between the foci, and sxx, syy, txy at all nodes of the half-plane, after P and Q."""
    (folder / "wedge.inp").write_text(deck(mesh))
    done = subprocess.run(["ccx", "wedge"], cwd=folder, capture_output=True, text=True)
    if done.returncode != 0 or "Job finished" not in done.stdout:
        raise SystemExit(f"ccx did not finish: {done.stdout[-500:]}{done.stderr[-500:]}")
    results = (folder / "wedge.frd").read_text()
    _, _, _, pressure, shear, _ = last("CONTACT", results, mesh.number[:, 0] + mesh.x.size)
    sxx, syy, _, txy, _, _ = last("STRESS", results, mesh.number.ravel())
    return np.stack([-pressure, -shear]), np.stack([sxx, syy, txy]).reshape(3, *mesh.x.shape)


def closed_form(mesh):
    contact = rwedge.Contact(THETA, ROUNDING, COMPLIANCE, F)
    contact.load(P, [0, Q])
    return contact, np.stack(contact.tractions(mesh.x[:, 0])), np.stack(contact.stresses(mesh.x, mesh.y))


def errors(mesh, tractions, stresses):
    """Root mean squares of differences in the peak pressure: of the tractions p and q along the surface, and of the stresses in
    the half-disk of 2 b below 0.1 b."""
    p0 = float(rwedge.peak_pressure(A_OVER_B)) * THETA / COMPLIANCE
    along = np.gradient(mesh.x[:, 0])
    near = (np.hypot(mesh.x, mesh.y) < 2 * B) & (mesh.y > 0.1 * B)
    area = np.hypot(mesh.x - FOCUS, mesh.y) * np.hypot(mesh.x + FOCUS, mesh.y) * near  # of an element, but for a factor
    return (*np.sqrt(np.sum(tractions**2 * along, axis=1) / np.sum(along)) / p0,
            math.sqrt(np.sum(stresses**2 * area) / 3 / np.sum(area)) / p0)


def main():
    options = shown.arguments(__file__, __doc__, refine=(0, "how often the mesh is refined, by 2.25"))
    if not shutil.which("ccx"):
        raise SystemExit("calculix.py needs ccx, which is not installed: apt-get install calculix-ccx")
    print("root mean square differences, over the peak pressure")
    print(f"{'elements':>9}{'pressure':>10}{'shear':>10}{'stresses':>10}")
    for k in range(options.refine + 1):
        mesh, began = Mesh(round(COARSE * FINER**k)), time.perf_counter()
        with tempfile.TemporaryDirectory() as folder:
            computed = finite_elements(mesh, Path(folder))
        contact, *expected = closed_form(mesh)
        differences = errors(mesh, computed[0] - expected[0], computed[1] - expected[1])
        print(f"{2 * len(mesh.elements):9}" + "".join(f"{difference:10.4f}" for difference in differences) + f"   {time.perf_counter() - began:.0f} s",
              flush=True)
    draw(options.picture, mesh, *computed, contact)


def draw(picture, mesh, tractions, stresses, contact):
    """Lines are the closed form, circles the finest mesh: tractions, and stresses down the axis."""
    figure, (left, right) = shown.plt.subplots(1, 2, figsize=(9, 4))
    x, middle = mesh.x[:, 0], mesh.x.shape[0] // 2
    pressure, shear = plot.tractions(contact, ax=left, units=("mm", "MPa"))
    for line, values in ((pressure, -tractions[0]), (shear, -tractions[1] / F)):
        line.set(color=plot.BLACK, linewidth=1)
        left.plot(x, values, "o", color=plot.VERMILLION, fillstyle="none", markersize=4)
    y, fine = mesh.y[middle], np.linspace(0, 2 * B, 201)
    below = y < 2 * B
    names = (r"$\sigma_{xx}$", 0.5, (8, -8)), (r"$\sigma_{yy}$", 1, (-8, 12)), (r"$\tau_{xy}$", 0.3, (-8, 12))
    for values, exact, (name, where, beside) in zip(stresses, contact.stresses(0, fine), names):
        right.plot(fine, exact, color=plot.BLACK, linewidth=1)
        right.plot(y[below], values[middle][below], "o", color=plot.VERMILLION, fillstyle="none", markersize=4)
        right.annotate(name, (where * B, np.interp(where * B, fine, exact)), textcoords="offset points", xytext=beside)
    right.set(xlabel="depth $y$ at $x = 0$ / mm", ylabel="stress / MPa")
    left.set_title("lines: closed form; circles: CalculiX", fontsize="medium")
    size = max(len(x), np.count_nonzero(below))

    def padded(values):
        return np.pad(values, (0, size - len(values)), constant_values=math.nan)

    columns = {"x_mm": x, "p_MPa": tractions[0], "q_MPa": tractions[1], "y_mm": y[below],
               **{f"{name}_MPa": values[middle][below] for name, values in zip(("sxx", "syy", "txy"), stresses)}}
    shown.save(figure, picture, **{name: padded(values) for name, values in columns.items()})


if __name__ == "__main__":
    main()
