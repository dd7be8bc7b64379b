/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The potential G(z) = (1/pi) int p(t)/(t-z) dt of a rounded wedge, pressed to the half-width c,
 * in ball arithmetic: each result contains the value at every point of the given ball, in as
 * many bits as are set. Written from the paper's Eq. (8) in elliptic coordinates; it shares
 * nothing with the library.
 *
 * Natural units: stresses in theta/A, lengths in any one unit. On y = 0 the values are those of
 * the limit from y > 0, and a ball that reaches below the surface encloses the continuation from
 * above. z = ±a and z = ±c are ordinary points of G and of y G'; a result that has no finite
 * enclosure (G' there, the apex of the sharp wedge) is a ball of infinite radius or not a
 * number. Many bits cancel for small a/c (about twice its magnitude) and far away: look at the
 * radius, and ask for more. */
#ifndef PATCH_HPP
#define PATCH_HPP

#include "balls/complex_ball.hpp"

/* G and y G' of a traction's potential G, or how both change. */
struct potentials {
    complex_ball G, H;
};

potentials operator*(const ball &factor, const potentials &p);
potentials operator+(const potentials &a, const potentials &b);
potentials operator-(const potentials &a, const potentials &b);

/* The stresses from the potentials N of the pressure and T of the shear traction, or how they
 * change: (sxx+syy)/2 and (syy-sxx)/2 + i txy. */
struct superposition {
    ball s;
    complex_ball D;
};

superposition superposed(const potentials &N, const potentials &T);

/* |D|^2 + kappa s^2, and how it changes as the stresses do. */
ball J2_of(const superposition &at, const ball &kappa);
ball J2_change(const superposition &at, const superposition &change, const ball &kappa);

/* G'', G''', G''''. */
struct higher_derivatives {
    complex_ball second, third, fourth;
};

class patch
{
  public:
    const ball half_width, alpha; /* alpha = a/c; 0 is the sharp wedge, 1 and above is Hertz */
    ball c0, phi0;                /* cosine and angle of the rounding's end; 0 and pi/2 for Hertz */

    /* a >= 0 and c > 0: half-widths of the rounding and of the contact, or of the stick zone. Where
     * balls leave open which is larger, angle and load are enclosed, the potential is unknown. */
    patch(const ball &a, const ball &c);

    bool is_hertz() const { return is_zero(c0); }
    bool is_sharp() const { return is_zero(alpha); }

    /* phi0/alpha, 1 for the sharp wedge. Half of how fast the load grows with c. */
    ball arc() const { return is_sharp() ? 1 : phi0 / alpha; }

    /* A P/theta, Eq. (7), (11), (15). */
    ball load() const { return half_width * (arc() + c0); }

    /* G(z), G'(z), and y G'(z), which is finite where G' is not. */
    complex_ball potential(const complex_ball &z) const;
    complex_ball slope(const complex_ball &z) const;
    complex_ball depth_slope(const complex_ball &z) const;
    potentials at(const complex_ball &z) const;

    /* The ball z is not to contain ±a and ±c. */
    higher_derivatives bends(const complex_ball &z) const;
};

#endif
