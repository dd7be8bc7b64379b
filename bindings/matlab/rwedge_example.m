% SPDX-License-Identifier: GPL-3.0-or-later
% The elastic limit over friction; the loop of slip over Q at a point of a fretting contact, and what its cycle does along the
% surface (N, mm).
f = 0:0.1:0.6;
[limit, x, y] = rwedge_yield_point(0.25, f, 0.3);
fprintf('  f     P/(bk)    x/b     y/b\n');
fprintf('%4.1f  %8.4f  %6.3f  %6.3f\n', [f; limit; x; y]);

E = 72e3;
nu = 0.33;
theta = 0.005;
friction = 0.6;
P = 60;
pad = rwedge_contact(theta, rwedge_rounding(theta, 20), rwedge_compliance(E, nu, E, nu), friction);
pad.load(P, 0);
Q = 0.8 * friction * P * [1 0.5 0 -0.5 -1 -0.5 0 0.5 1];
slip = zeros(size(Q));
for i = 1:numel(Q)
    pad.load(P, Q(i));
    slip(i) = pad.slip(-0.9 * pad.half_width());
end
fprintf('\n     Q   slip at -0.9 b\n');
fprintf('%6.1f  %12.4e\n', [Q; slip]);
fprintf('dissipated so far: %.4e N\n', pad.dissipated_energy());

b = pad.half_width();
x = b * linspace(-1.2, 1.2, 241);
x(end + 1) = -b; % the trailing edge, to the bit: there it is worst
[sxx, syy, txy] = pad.stresses_after([P + 0 * Q(:), Q(:)], x, 0 * x);
[value, angle, out] = rwedge_criterion_field(rwedge_measure('SWT_IN_PLANE'), E, sxx, syy, txy, nu, 0);
[worst, at] = max(value);
fprintf('Smith-Watson-Topper: at most %.6f MPa, at x = %.4f b, plane %.1f degrees\n', worst, x(at) / b, angle(at) * 180 / pi);
