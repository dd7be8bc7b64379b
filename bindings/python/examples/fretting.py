# SPDX-License-Identifier: GPL-3.0-or-later
"""A fretting-fatigue test: a cylinder is pressed on a specimen, then tangential force and bulk tension go to and fro in phase.
Prints stick zone, slip, and where and on which plane Smith, Watson and Topper's parameter is worst, and compares three cases with
published numbers.                                                                          fretting.py PICTURE

Units are N and mm, so that stresses are MPa and forces are per mm of thickness.
"""
import math

import numpy as np
import shown

import rwedge
from rwedge import plot

THETA = 0.05  # rad; where a = R theta is wider than the contact, the pad is a cylinder (Hertz) for any angle


def pad(E, nu, R, f):
    """A cylinder of radius R, of the specimen's material."""
    return rwedge.Contact(THETA, rwedge.rounding(THETA, R), rwedge.compliance(E, nu, E, nu), f)


def under_tension(E, nu, R, f, P, Q, sigma):
    """The quantities that are published for a cylinder pressed with P, then loaded with Q and sigma together: half-width, peak
    pressure, half-width and offset of the stick zone, and tension at the trailing edge."""
    contact = pad(E, nu, R, f)
    contact.load(P)
    contact.apply(P, 0, Q, sigma)
    (left, right), b = contact.stick_zone, contact.half_width
    return {"b": b, "p0": -contact.tractions(0)[0], "c": (right - left) / 2, "e": (left + right) / 2,
            "sxx": contact.stresses(-b, 0)[0]}


def compare(case, computed, published):
    print(case)
    for name, value in published.items():
        print(f"  {name:12} {computed[name]:11.6g}   published {value:11.6g}   difference {computed[name] / value - 1:8.1e}")


def published_cases():
    """Closed forms for cylinders: e = b sigma/(4 f p0) and c = b sqrt(1 - Q/(f P)) of D. Nowell and D. A. Hills, Mechanics of
    fretting fatigue tests, Int. J. Mech. Sci. 29 (1987) 355-365; NAFEMS' benchmark CB1 for Hertz."""
    computed = under_tension(72.1e3, 0.33, 10, 0.3, 543 / 4, 155 / 4, 100)
    compare("aluminium, 543 N on 4 mm, R = 10 mm, Q = 155 N, sigma = 100 MPa, f = 0.3 (mm, MPa)", computed,
            {"b": 0.206698, "p0": 418.104, "c": 0.045519, "e": 0.041197, "sxx": 345.747})

    E, nu, R, f, p0 = 72.1e3, 0.33, 10, 0.75, 157
    b = p0 * R * rwedge.compliance(E, nu, E, nu)
    P = math.pi / 2 * p0 * b
    computed = under_tension(E, nu, R, f, P, 0.45 * P, 92.7)
    compare("p0 = 157 MPa, sigma = 92.7 MPa, Q/P = 0.45, f = 0.75 (over b, p0)",
            {"p0": computed["p0"], "c/b": computed["c"] / b, "e/b": computed["e"] / b, "sxx/p0": computed["sxx"] / p0},
            {"p0": 157, "c/b": 0.6325, "e/b": 0.1968, "sxx/p0": 1.8193})

    A = rwedge.compliance(210e3, 0.3, 70e3, 0.3)
    theta = 0.125  # wide enough for the contact to be Hertz'
    a = rwedge.rounding(theta, 50)
    b = rwedge.half_width(theta, a, A, 35e3)
    compare("NAFEMS CB1: steel cylinder, R = 50 mm, on aluminium, 35 kN/mm (mm, MPa)",
            {"b": b, "p0": rwedge.peak_pressure(a / b) * theta / A}, {"b": 6.2146, "p0": 3585.36})


def main():
    picture = shown.arguments(__file__, __doc__).picture
    published_cases()

    E, nu, f, P, Q, sigma = 72.1e3, 0.33, 0.3, 543 / 4, 155 / 4, 100
    contact = pad(E, nu, 10, f)
    contact.load(P)
    b = contact.half_width
    x = np.union1d(b * np.linspace(-1.6, 1.6, 129), b * np.sin(np.linspace(-math.pi / 2, math.pi / 2, 81)))
    contact.apply(P, 0, Q, sigma)  # the first loading differs from the cycles after it
    phase = np.cos(np.linspace(0, 2 * math.pi, 49))
    before = contact.dissipated_energy
    stresses = contact.stresses_after({"P": P, "Q": Q * phase, "sigma": sigma * phase}, x, 0)
    value, angle = rwedge.smith_watson_topper(*stresses, E, nu, axis=0)
    worst = value.argmax()
    left, right = contact.stick_zone
    print("the first of them, as a test: Q and sigma in phase, fully reversed")
    print(f"  contact {b:.4f} mm, stick zone from {left:.4f} to {right:.4f} mm")
    never = contact.permanent_stick(P, 0, -Q, -sigma, P, 0, Q, sigma)
    print("  never slips in a cycle: from {:.4f} to {:.4f} mm".format(*never))
    print(f"  dissipated per cycle {1000 * (contact.dissipated_energy - before):.3f} µJ per mm of thickness")
    print(f"  Smith-Watson-Topper {value[worst]:.4f} MPa at x = {x[worst] / b:.4f} b, plane {math.degrees(angle[worst]):.1f} degrees")

    figure, (top, middle, bottom) = shown.plt.subplots(3, sharex=True, figsize=(5.5, 7.5))
    touching, slips = abs(x) <= b, {}
    for number, (sign, word) in enumerate(((1, "right"), (-1, "left"))):
        contact.apply(P, 0, sign * Q, sign * sigma)
        plot.tractions(contact, ax=top, units=("mm", "MPa"), label=f"$Q$, $\\sigma$ to the {word}")
        slips[word] = np.full(x.shape, math.nan)
        slips[word][touching] = 1000 * contact.slip(x[touching])
        middle.plot(x, slips[word], **shown.style(number))
    top.set_xlabel("")
    top.legend()
    middle.set_ylabel("slip / µm")
    bottom.plot(x, value, color=plot.BLACK)
    bottom.plot(x[worst], value[worst], "o", color=plot.VERMILLION, fillstyle="none")
    bottom.annotate(f"{value[worst]:.3f} MPa, plane {math.degrees(angle[worst]):.0f}°", (x[worst], value[worst]),
                    textcoords="offset points", xytext=(10, -4))
    bottom.set(xlabel="$x$ / mm", ylabel="Smith–Watson–Topper / MPa")
    shown.save(figure, picture, x_mm=x, swt_MPa=value, angle_rad=angle, slip_right_um=slips["right"],
               slip_left_um=slips["left"])


if __name__ == "__main__":
    main()
