# SPDX-License-Identifier: GPL-3.0-or-later
"""K of a crack beside finite elements: a cylinder is pressed on a half-plane and pulled along it; a crack goes down from the trailing
edge. CalculiX (Debian's package calculix-ccx) takes the tractions of the contact, and its faces' opening tells of K.
                                                                                                crack_elements.py PICTURE --refine 2

The elements, of eight nodes in one layer of plane strain with incompatible modes, follow ellipses and hyperbolas around the tip
of the crack: one ellipse is the crack itself, gone round from mouth to mouth, the outermost is held. The forces at the nodes are
integrals of the tractions. The opening and the sliding of the faces near the tip, over the root of the distance, go straight to
those of K. Lengths are in half-widths of the contact, b, K in the peak pressure times sqrt(b).
"""
import math
import shutil
import subprocess
import tempfile
from pathlib import Path

import numpy as np
import shown

import rwedge

E, NU, F, Q_OVER_FP = 200e3, 0.3, 0.6, 0.7
FAR = 500  # the outermost ellipse, in lengths of the crack
LENGTHS = 0.3, 2.0
NEAR = 0.02, 0.3  # distances from the tip whose opening is taken, in the length


def pressed():
    """The contact, its peak pressure being 1."""
    compliance = rwedge.compliance(E, NU, E, NU)
    contact = rwedge.Contact.flat(0, 1 / compliance, compliance, F)
    contact.load(math.pi / 2, [0, Q_OVER_FP * F * math.pi / 2])
    return contact


class Mesh:
    """Nodes at l sinh(u + iv): number[i, j], i along v from the right surface round the crack to the left one, j along u."""

    def __init__(self, length, around):
        v = np.linspace(0, math.pi, around + 1)
        u = np.linspace(0, math.asinh(FAR), round(around / math.pi * math.asinh(FAR)) + 1)
        self.x, self.y = length * np.outer(np.cos(v), np.sinh(u)), length * np.outer(np.sin(v), np.cosh(u))
        self.x[around // 2] = self.y[[0, -1]] = 0
        n = self.number = np.arange(self.x.size).reshape(self.x.shape) + 1
        self.elements = np.stack([n[:-1, :-1], n[:-1, 1:], n[1:, 1:], n[1:, :-1]], axis=-1).reshape(-1, 4)


def surface_forces(mesh, contact):
    """At the nodes of the right surface, below the contact: integrals of the tractions times the hat of the node."""
    at, edge = mesh.x[0], contact.edges[0]
    node, weight = np.polynomial.legendre.leggauss(40)
    share, force = (node + 1) / 2, np.zeros((2, len(at)))
    for j in range(len(at) - 1):
        width = at[j + 1] - at[j]
        p, q = contact.tractions(edge + at[j] + width * share)
        for k, traction in enumerate((q, -p)):
            force[k, j:j + 2] += width / 2 * np.array([weight @ (traction * (1 - share)), weight @ (traction * share)])
    given = np.array([contact.loads[2], contact.loads[0]])
    return force * (given / force.sum(axis=1))[:, None]  # to their resultants Q and P, with their sign


def rows(values):
    return "\n".join(", ".join(f"{value:.12g}" for value in row) for row in values)


def deck(mesh, force):
    size = mesh.x.size
    nodes = [(i + 1 + layer * size, x, y, layer) for layer in (0, 1) for i, (x, y) in enumerate(zip(mesh.x.ravel(), mesh.y.ravel()))]
    elements = [(i + 1, *four, *(four + size)) for i, four in enumerate(mesh.elements)]
    loads = [(mesh.number[0, j] + layer * size, k + 1, force[k, j] / 2) for layer in (0, 1) for k in (0, 1) for j in np.flatnonzero(force[k])]
    held = [(node + layer * size, 1, 2) for node in mesh.number[:, -1] for layer in (0, 1)]
    return f"""*NODE, NSET=ALL
{rows(nodes)}
*ELEMENT, TYPE=C3D8I, ELSET=STEEL
{rows(elements)}
*NSET, NSET=FACES
{rows((node,) for node in mesh.number[:, 0])}
*MATERIAL, NAME=STEEL
*ELASTIC
{E}, {NU}
*SOLID SECTION, ELSET=STEEL, MATERIAL=STEEL
*BOUNDARY
ALL, 3, 3
{rows(held)}
*STEP
*STATIC
*CLOAD
{rows(loads)}
*NODE PRINT, NSET=FACES
U
*END STEP
"""


def displacements(mesh, force, folder):
    """Of the nodes of the crack's faces, from the right mouth to the left one."""
    (folder / "crack.inp").write_text(deck(mesh, force))
    done = subprocess.run(["ccx", "crack"], cwd=folder, capture_output=True, text=True)
    if done.returncode != 0 or "Job finished" not in done.stdout:
        raise SystemExit(f"ccx did not finish: {done.stdout[-500:]}{done.stderr[-500:]}")
    lines = [line.split() for line in (folder / "crack.dat").read_text().splitlines()]
    found = {int(words[0]): [float(word) for word in words[1:3]] for words in lines if len(words) == 4 and words[0].isdigit()}
    return np.array([found[int(node)] for node in mesh.number[:, 0]]).T


def intensities(mesh, length, moved):
    """K_I and K_II: of opening and sliding 8 K/E' sqrt(r/(2 pi)), straight in r next to the tip."""
    half = mesh.x.shape[0] // 2
    r = length - mesh.y[:half, 0]
    apart = moved[:, :half] - moved[:, :half:-1]
    near = (r > NEAR[0] * length) & (r < NEAR[1] * length)
    K = E / (1 - NU**2) / 8 * apart[:, near] * np.sqrt(2 * math.pi / r[near])
    return np.polynomial.polynomial.polyfit(r[near], K.T, 2)[0]


def main():
    options = shown.arguments(__file__, __doc__, refine=(0, "how often the mesh is refined, by 2"))
    if not shutil.which("ccx"):
        raise SystemExit("crack_elements.py needs ccx, which is not installed: apt-get install calculix-ccx")
    contact = pressed()
    cycle = contact.cycle({"P": [contact.loads[0]], "Q": [contact.loads[2]]})
    expected = np.stack(cycle.crack(contact.edges[0], 0, LENGTHS)[:2])[:, 0]
    print("   l/b  elements      K_I     K_II   by elements   difference over K")
    for refined in range(options.refine + 1):
        computed = np.empty_like(expected)
        for i, length in enumerate(LENGTHS):
            mesh = Mesh(length, 48 * 2**refined)
            with tempfile.TemporaryDirectory() as folder:
                moved = displacements(mesh, surface_forces(mesh, contact), Path(folder))
            computed[:, i] = intensities(mesh, length, moved)
            difference = np.hypot(*(computed[:, i] - expected[:, i])) / np.hypot(*expected[:, i])
            print(f"{length:6.2f}{len(mesh.elements):10}{expected[0, i]:9.4f}{expected[1, i]:9.4f}{computed[0, i]:9.4f}{computed[1, i]:9.4f}"
                  f"{difference:12.5f}", flush=True)

    lengths = np.geomspace(0.1, 6, 60)
    K = np.stack(cycle.crack(contact.edges[0], 0, lengths)[:2])[:, 0]
    figure, axes = shown.plt.subplots(figsize=(6, 4))
    for mode, name in enumerate(("$K_I$", "$K_{II}$")):
        axes.semilogx(lengths, K[mode], label=name, **shown.style(mode))
        axes.semilogx(LENGTHS, computed[mode], "o", color=shown.style(mode)["color"], fillstyle="none")
    axes.set(xlabel="length of the crack over b", ylabel=r"$K/(p_0 \sqrt{b})$; circles: finite elements")
    axes.legend()
    shown.save(figure, options.picture, length=lengths, K_I=K[0], K_II=K[1])


if __name__ == "__main__":
    main()
