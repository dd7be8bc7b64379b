/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The normal load of a largest pressure. */
#include "histories.h"

#include <errno.h>
#include <fenv.h>

static const double F = 0.5, R = 10;

static double load_of_peak(const rwedge_contact *contact, double pressure)
{
    double P = NAN;
    assert_ok(rwedge_contact_peak_load(contact, pressure, &P));
    return P;
}

/* p0 = sqrt(2 P/(pi A R)), also of a cylinder that is held at a tilt: it touches beside. */
CLAIM(the_load_of_a_cylinder_is_that_of_Hertz)
{
    for (double p0 = 1e-4; p0 < 1; p0 *= 7) {
        rwedge_contact *cylinder = create_flat(0, R, A, F), *held = create_flat(0, R, A, F);
        const double P = PI * A * R * p0 / 2 * p0;
        assert_close(load_of_peak(cylinder, p0), P, 1e-13);
        assert_ok(rwedge_contact_set_rotation(held, 1));
        assert_ok(rwedge_contact_guide(held, 0, 0.01, 0, 0));
        assert_close(load_of_peak(held, p0), P, 1e-12); /* a narrow contact beside rounds more */
    }
}

CLAIM(the_load_of_a_wedge_is_that_of_its_contact_law)
{
    const double a = 0.4;
    for (double alpha = 0.01; alpha < 3; alpha *= 1.7) {
        const double p0 = THETA / A * rwedge_peak_pressure(alpha);
        assert_close(load_of_peak(create(a, F), p0), THETA / A * (a / alpha) * rwedge_load(alpha),
                     1e-12);
    }
}

/* Whatever loads it is under, which stay as they are. */
CLAIM(the_load_gives_the_pressure_of_any_pad)
{
    const double x[] = {-1, -0.61, -0.6, -0.21, -0.2, 0.2, 0.202, 0.5, 0.51, 1},
                 slope[] = {-0.1, -0.09, -0.05, -0.045, -0.015, -0.01, 0.02, 0.025, 0.06, 0.1};
    rwedge_contact *pads[] = {
        create_flat(0.5, R, A, F), create_profile(10, x, slope, F),
        APPLY(create_flat(0.5, R, A, F), {0.3, 0.01, 0, 0}, {0.3, 0.01, 0.1, 0})};
    for (int i = 0; i < 3; i++)
        for (double P = 1e-4; P < 1; P *= 7) {
            const contact_state before = state_of(pads[i]);
            const rwedge_contact *pressed = APPLY(
                i == 1 ? create_profile(10, x, slope, F) : create_flat(0.5, R, A, F), {P, 0, 0, 0});
            double p0, at;
            assert_ok(rwedge_contact_peak_pressure(pressed, &p0, &at));
            assert_close(load_of_peak(pads[i], p0), P, 1e-12);
            assert_state(pads[i], before);
        }
}

CLAIM(a_pressure_that_no_load_has_is_told)
{
    const double x[] = {-1, 0, 0, 1}, slope[] = {-0.1, -0.05, 0.05, 0.1};
    const double jump[] = {-1, 0.5, 0.5, 1}, slopes[] = {-0.1, 0.05, 0.2, 0.25};
    double P = 5, p0, at;
    assert_int_equal(rwedge_contact_peak_load(create(0, F), 1, &P), RWEDGE_EABSENT);
    assert_int_equal(rwedge_contact_peak_load(create_profile(4, x, slope, F), 1, &P),
                     RWEDGE_EABSENT);
    /* a smooth bottom and a kink beside: what it has just before the kink touches is the most */
    const rwedge_contact *low = APPLY(create_profile(4, jump, slopes, F), {0.001, 0, 0, 0});
    assert_ok(rwedge_contact_peak_pressure(low, &p0, &at));
    assert_close(load_of_peak(low, p0), 0.001, 1e-12);
    assert_int_equal(rwedge_contact_peak_load(low, 100, &P), RWEDGE_EABSENT);
    assert_int_equal(rwedge_contact_peak_load(low, 1e60, &P), RWEDGE_EABSENT);
    assert_int_equal(rwedge_contact_peak_load(low, 0, &P), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_peak_load(low, NAN, &P), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_peak_load(NULL, 1, &P), RWEDGE_ENULL);
    assert_int_equal(rwedge_contact_peak_load(low, 1, NULL), RWEDGE_ENULL);
    assert_true(P == 5);
}

/* It was looked for down to loads whose pressure is lost in rounding, and above the largest. */
CLAIM(a_pressure_that_no_load_makes_raises_nothing)
{
    static const double PRESSURES[] = {8e-22, 1e-40, 1e30, 9e59};
    for (size_t i = 0; i < sizeof PRESSURES / sizeof *PRESSURES; i++) {
        double P = 7;
        const rwedge_contact *pad = create_flat(0.4, 10, 0.5, 0.5);
        errno = 0;
        feclearexcept(FE_ALL_EXCEPT);
        assert_int_equal(rwedge_contact_peak_load(pad, PRESSURES[i], &P), RWEDGE_EABSENT);
        assert_int_equal(fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW), 0);
        assert_true(errno == 0 && P == 7);
    }
}
