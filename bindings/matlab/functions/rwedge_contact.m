classdef rwedge_contact < handle
%RWEDGE_CONTACT  A contact with a load history.
%   A contact without load, separated.
%   rwedge:domain where theta/A leaves the domain too; rwedge:memory.
%     theta  angle between flank and surface, rad, 0 < theta < pi/2; the theory is that of small angles
%     a      half-width of the rounding, length, finite, >= 0; 0 is the sharp wedge
%     A      composite compliance, 1/stress, finite, > 0: rwedge_compliance()
%     f      coefficient of friction, 0 <= f <= 1e6
%
%   c = rwedge_contact(theta, a, A, f)      a contact without load
%   c = rwedge_contact(theta, a, A, f, beta)  with rwedge_dundurs_beta(...): it warns where dissimilar bodies have friction
%   c.set_strain(strain_per_tension)
%   c.load(P, Q)
%   c.apply(P, M, Q, sigma)
%   value = c.obstacle(P, M, Q, sigma)
%   value = c.largest_tension_step(Q)
%   [P, M, Q, sigma] = c.loads()
%   [left, right] = c.edges()
%   [left, right] = c.stick_zone()
%   value = c.tilt()
%   [normal_left, normal_right, shear_left, shear_right] = c.edge_asymptotes()
%   value = c.half_width()
%   value = c.stick_half_width()
%   value = c.memory()
%   [p, q] = c.tractions(x)
%   [sxx, syy, txy] = c.stresses(x, y)
%   [sxx, syy, txy] = c.stress_history(P, M, Q, sigma, x, y)
%   value = c.state_size()
%   state = c.state()
%   slip = c.slip(x)
%   value = c.dissipated_energy()
%   [factor, x, y] = c.yield_factor(nu, k)
%   [stress_range, swt, swt_angle, fatemi_socie, fs_angle] = c.cycle_fatigue(P, M, Q, sigma, x, y, E, nu, k_over_sy)
%   [slip_range, ruiz_f1, ruiz_f2, energy] = c.cycle_friction(P, M, Q, sigma, x)
%   [worst_x, worst_value] = c.cycle_worst(measure, P, M, Q, sigma, x, value, y, E, nu, k_over_sy)
%   value = c.displacement(b)
%   [sxx, syy, txy] = c.cycle(loads, x, y)  stresses at points through a table of loads
%   d = c.copy()                            an independent copy, to try a load and go back; d = c is the same contact
%
%   c.load(P, Q) takes vectors too, one load after the other: those before one that is refused stay.
%
%   Doubtful results give the warning rwedge:validity: see rwedge_validity. warning('off', 'rwedge:validity') silences it.
%
%   It is freed when the last variable that holds it is cleared. "help rwedge_contact.load" and so on say more.
    properties (SetAccess = private, Hidden, Transient)
        number = 0
        a = NaN % for a warning
    end
    methods
        function contact = rwedge_contact(theta, a, A, f, beta)
            if nargin > 0 && nargin < 4
                error('rwedge:arguments', 'too few arguments: contact = rwedge_contact(theta, a, A, f)');
            elseif nargin > 0
                contact.number = rwedge_mex('contact_create', theta, a, A, f);
                contact.a = a;
                contact.warn('theta', theta);
            end
            if nargin > 4
                contact.warn('beta', beta, 'f', f);
            end
        end

        function disp(contact)
        %DISP  The loads, and the sizes of the contact.
            if ~rwedge_mex('is_contact', contact.number)
                disp('  rwedge_contact, deleted');
                return
            end
            [P, M, Q, sigma] = contact.loads();
            fprintf('  rwedge_contact: P = %.6g, M = %.6g, Q = %.6g, sigma = %.6g; half-width %.6g, stick zone %.6g\n', ...
                P, M, Q, sigma, contact.half_width(), contact.stick_half_width());
        end

        function delete(contact)
        %DELETE  Frees the contact; clear does so too.
            rwedge_mex('contact_destroy', contact.number);
        end

        function other = copy(contact)
        %COPY  other = contact.copy()
        %   An independent copy, history and all: to try a load and go back.
        %   rwedge:handle, rwedge:memory.
            other = rwedge_contact();
            other.number = rwedge_mex('contact_copy', contact.number);
            other.a = contact.a;
        end

        function [sxx, syy, txy] = cycle(contact, loads, x, y)
        %CYCLE  [sxx, syy, txy] = contact.cycle(loads, x, y)
        %   Stresses at points while the contact goes on through a table of loads, in one call to the library: see
        %   stress_history. A row of loads is [P Q], with the moment and the tension that there are, or [P M Q sigma]. The
        %   stresses at point i under load j are at (i, j), as rwedge_smith_watson_topper_field takes them.
            if nargin < 4
                error('rwedge:arguments', 'too few arguments: [sxx, syy, txy] = contact.cycle(loads, x, y)');
            elseif size(loads, 2) == 2
                [~, M, ~, sigma] = contact.loads();
                stays = cumsum(loads(:, 1) == 0) == 0; % a moment is gone once the bodies were separated
                same = ones(size(loads, 1), 1);
                loads = [loads(:, 1), M * stays, loads(:, 2), sigma * same];
            elseif size(loads, 2) ~= 4
                error('rwedge:size', 'loads has %d columns: a row is [P Q] or [P M Q sigma]', size(loads, 2));
            end
            [sxx, syy, txy] = contact.stress_history(loads(:, 1), loads(:, 2), loads(:, 3), loads(:, 4), x, y);
        end

        function set_strain(contact, strain_per_tension)
        %SET_STRAIN  contact.set_strain(strain_per_tension)
        %   How much a bulk tension stretches the surface of the half-plane against that of the wedge: A/4 of
        %   the tension unless it is set. That is right for bodies of equal compliance. For others it is
        %   (1 - nu1^2)/E1 of the tension, E1 and nu1 being those of the half-plane.   new
        %     strain_per_tension  strain over tension, 1/stress, finite, >= 0, also over A
        %   rwedge:domain where the bodies touch: it is set before the first load, or when they are
        %   separated; rwedge:handle.
            if nargin < 2
                error('rwedge:arguments', 'too few arguments: contact.set_strain(strain_per_tension)');
            end
            rwedge_mex('contact_set_strain', contact.number, strain_per_tension);
        end

        function load(contact, P, Q)
        %LOAD  contact.load(P, Q)
        %   The next point of the history, reached in a straight line of the (P, Q) plane from the last one.
        %      Sec. 3.2; new
        %     P  0, or 1e-60 to 1e60; not below 1e-8 of the last P: but 0 may follow any load. It separates
        %        the bodies (Q must then be 0 too), and all but the dissipated energy is forgotten
        %     Q  |Q| <= f P; equality is full sliding, to 8 epsilon of f times the larger of P and the last
        %        P, or the largest P since it slides: a ramp may be interpolated in any number of steps
        %   rwedge:sliding where |Q| > f P. rwedge:domain. rwedge:range where the half-width, a/b, the
        %   peak pressure or the energy leaves the domain. rwedge:range too where P is not 0 but below
        %   1e-8 of the last P, whose rounding would blur what Q/(fP) is: go there in two loads. rwedge:path
        %   after a moment or another tension, as rwedge_contact.apply(). rwedge:handle; rwedge:memory. After an error the contact is as before;
        %   of vectors, the loads before the one that is refused stay. It remembers at most two points of the history per load, and
        %   of them only those that its tractions or its slip still depend on.
            if nargin < 3
                error('rwedge:arguments', 'too few arguments: contact.load(P, Q)');
            end
            rwedge_mex('contact_load', contact.number, P, Q);
            contact.warn_of_size();
        end

        function apply(contact, P, M, Q, sigma)
        %APPLY  contact.apply(P, M, Q, sigma)
        %   The next point of the history with a moment and a bulk tension, reached in a straight line of all
        %   four.   new
        %     P      0, or at least 1e-8 of the last P: as for rwedge_contact.load()
        %     M      moment about x = 0 per unit length, a force, finite; positive presses the right side; 0
        %            where P is 0
        %     Q      |Q| <= f P, as for rwedge_contact.load()
        %     sigma  bulk tension of the half-plane, stress, finite: added to its sxx. It stretches the
        %            surface against the wedge's, by A sigma/4 or as rwedge_contact.set_strain() says, and
        %            so makes it slip. Apply it while P is 0 to have it without slip
        %   rwedge_contact.load() keeps M and sigma as they are, and drops M where P is 0. The result is
        %   exact without friction, and where |Q| = f P. It is exact without moment and under one sigma,
        %   whatever P and Q do. It is exact under constant P and M, where both edges slip the same way:
        %   |d sigma| <= 4 |dQ|/(pi s), s being the half-width of the contact, for a strain of A/4. It is
        %   exact where both edges of the contact move outwards, or both inwards, and both slip the same way
        %   or stick. Other loads have no closed form. Nor have loads that bring the front of slip between
        %   two patches of the memory at one edge, and between two others at the other edge, or that leave a
        %   part beyond the front that sticks: lib/README.md, "Moment and bulk tension".
        %   rwedge:path where no closed form is shown: rwedge_contact.obstacle() says why. rwedge:domain
        %   where M tilts the wedge by theta (1 - 1e-9) or more, so that a flank all but lies on the
        %   surface. The others as rwedge_contact.load(): rwedge:sliding; rwedge:range; rwedge:handle;
        %   rwedge:memory.
            if nargin < 5
                error('rwedge:arguments', 'too few arguments: contact.apply(P, M, Q, sigma)');
            end
            rwedge_mex('contact_apply', contact.number, P, M, Q, sigma);
            contact.warn_of_size();
        end

        function value = obstacle(contact, P, M, Q, sigma)
        %OBSTACLE  value = contact.obstacle(P, M, Q, sigma)
        %   Why rwedge_contact.apply() would return rwedge:path for these loads, and what to do instead, in
        %   English; empty where it would not.   new
        %     arguments as for rwedge_contact.apply(); the contact stays as it is
        %   Static text.
        %     P      0, or at least 1e-8 of the last P: as for rwedge_contact_load()
        %     M      moment about x = 0 per unit length, a force, finite; positive presses the right side; 0 where P is 0
        %     Q      |Q| <= f P, as for rwedge_contact_load()
        %     sigma  bulk tension of the half-plane, stress, finite: added to its sxx. It stretches the surface against the wedge's, by A sigma/4 or as rwedge_contact_set_strain() says, and so makes it slip. Apply it while P is 0 to have it without slip
            if nargin < 5
                error('rwedge:arguments', 'too few arguments: value = contact.obstacle(P, M, Q, sigma)');
            end
            value = rwedge_mex('contact_obstacle', contact.number, P, M, Q, sigma);
        end

        function value = largest_tension_step(contact, Q)
        %LARGEST_TENSION_STEP  value = contact.largest_tension_step(Q)
        %   The largest |d sigma| with which the present Q may change to another under constant P and M,
        %   stress: 4 |dQ|/(pi s), for a strain of A/4 per tension. Inf without friction, and where a
        %   tension stretches nothing.   new
        %     Q  finite
        %   NaN outside the domain; 0 when separated. Relative error as that of the edges.
            if nargin < 2
                error('rwedge:arguments', 'too few arguments: value = contact.largest_tension_step(Q)');
            end
            value = rwedge_mex('contact_largest_tension_step', contact.number, Q);
        end

        function [P, M, Q, sigma] = loads(contact)
        %LOADS  [P, M, Q, sigma] = contact.loads()
        %   The present loads.   new
        %     P, M, Q, sigma  each receives one number
        %   rwedge:handle.
            [P, M, Q, sigma] = rwedge_mex('contact_loads', contact.number);
        end

        function [left, right] = edges(contact)
        %EDGES  [left, right] = contact.edges()
        %   The edges of the contact, left < x < right.   new
        %     left, right  length
        %   rwedge:absent when separated; rwedge:handle. Error below 1e-14 of the width, or of |x| where that
        %   is larger, over 1 - |tilt|/theta.
            [left, right] = rwedge_mex('contact_edges', contact.number);
        end

        function [left, right] = stick_zone(contact)
        %STICK_ZONE  [left, right] = contact.stick_zone()
        %   The edges of the stick zone: between them and those of the contact friction is exhausted, |q| = f
        %   |p|. Those of the contact where there is no such zone.   new
        %     left, right  length
        %   rwedge:absent in full sliding, and when separated; rwedge:handle. After one step of Q and sigma
        %   the error is that of the contact's edges, over the root of the part of P that the zone carries,
        %   and with the zone's tilt where that is larger.
            [left, right] = rwedge_mex('contact_stick_zone', contact.number);
        end

        function value = tilt(contact)
        %TILT  value = contact.tilt()
        %   The angle by which the moment tilts the wedge, rad: |tilt| < theta.   new
        %   0 without a moment. Error below 1e-14 theta, where the edges have their relative
        %   error.
            value = rwedge_mex('contact_tilt', contact.number);
        end

        function [normal_left, normal_right, shear_left, shear_right] = edge_asymptotes(contact)
        %EDGE_ASYMPTOTES  [normal_left, normal_right, shear_left, shear_right] = contact.edge_asymptotes()
        %   How pressure and shear behave at the edges, at the distance r: |p| ~ K_N sqrt(r), and, as long as
        %   slip is short, q ~ -K_T/sqrt(r), which slips over the length 2 |K_T|/(f K_N): to 0.1 % at Q/(fP)
        %   = 0.001, 9 % at 0.1, 35 % at 0.5. Two contacts of the same K_N and K_T are alike at their edges:
        %   this is how a pad is matched to a specimen.   new
        %     normal_left, normal_right  K_N, stress over the root of a length
        %     shear_left, shear_right    K_T, stress times the root of a length, of the present Q and of
        %                                the strain by sigma less what it was when the bodies touched
        %   rwedge:absent when separated; rwedge:handle. K_N to 1e-14 of the larger one, of the edges that
        %   rwedge_contact.edges() gives.
            [normal_left, normal_right, shear_left, shear_right] = rwedge_mex('contact_edge_asymptotes', contact.number);
        end

        function value = half_width(contact)
        %HALF_WIDTH  value = contact.half_width()
        %   Half-width b of the contact, length; 0 when separated. Half its width where it is
        %   off the centre.
        %      Eq. (7), (11), (15), inverse
            value = rwedge_mex('contact_half_width', contact.number);
        end

        function value = stick_half_width(contact)
        %STICK_HALF_WIDTH  value = contact.stick_half_width()
        %   Half-width c of the stick zone, length. Outside it, c < |x| < b, friction is exhausted: |q| = f
        %   |p|. So it is in a ring that came into contact with |dQ| = f dP, to rounding, though it has not
        %   slipped. c is b where all sticks, 0 in full sliding and when separated.
        %      Eq. (25); new
            value = rwedge_mex('contact_stick_half_width', contact.number);
        end

        function value = memory(contact)
        %MEMORY  value = contact.memory()
        %   How many points of its history the contact remembers: those that its tractions depend on, and
        %   those that its slip is measured from. At most two per load, and some tens after any number of
        %   loads that dither around one point; 0 when separated. The memory it takes grows in
        %   proportion; so does the time of its functions, at most, for each point of the half-plane.
            value = rwedge_mex('contact_memory', contact.number);
        end

        function [p, q] = tractions(contact, x)
        %TRACTIONS  [p, q] = contact.tractions(x)
        %   Pressure p and shear traction q at n points of the surface, stress: compression negative; q =
        %   f p where it slips under Q > 0. Both are 0 for |x| >= b.   Eq. (8), (12), (14), (22) to (27)
        %     x     length, finite; not the apex 0 of a loaded sharp wedge
        %     p, q  each receives n numbers
        %   rwedge:domain; rwedge:handle. Nothing is written unless every point is in the domain.
        %   Error of p as rwedge_pressure(), of q below 1e-13 f (theta/A + |p|).
            if nargin < 2
                error('rwedge:arguments', 'too few arguments: [p, q] = contact.tractions(x)');
            end
            [p, q] = rwedge_mex('contact_tractions', contact.number, x);
        end

        function [sxx, syy, txy] = stresses(contact, x, y)
        %STRESSES  [sxx, syy, txy] = contact.stresses(x, y)
        %   Stresses at n points (x, y) of the half-plane, tension positive.   Eq. (28), (32), (33); new
        %     x, y           length, finite, y >= 0; not the apex (0, 0) of a loaded sharp wedge
        %     sxx, syy, txy  each receives n numbers
        %   rwedge:domain; rwedge:handle. Nothing is written unless every point is in the domain.
        %   Error below 1e-13 of what rwedge_stress() says, for every remembered point of the history.
            if nargin < 3
                error('rwedge:arguments', 'too few arguments: [sxx, syy, txy] = contact.stresses(x, y)');
            end
            [sxx, syy, txy] = rwedge_mex('contact_stresses', contact.number, x, y);
        end

        function [sxx, syy, txy] = stress_history(contact, P, M, Q, sigma, x, y)
        %STRESS_HISTORY  [sxx, syy, txy] = contact.stress_history(P, M, Q, sigma, x, y)
        %   Stresses at n points while the contact goes on through many loads: as rwedge_contact.apply() and
        %   rwedge_contact.stresses() after each, to the same bits. It is faster: what a load leaves as it
        %   was is not computed again.   new
        %     P              0, or at least 1e-8 of the last P
        %     M, Q, sigma    finite: loads numbers each, as P
        %     x, y           length, finite, y >= 0: n numbers each
        %     sxx, syy, txy  each receives loads * n numbers, the n of the first load first; not one of the
        %                    inputs
        %   The contact then has the last of the loads. After an error the contact is as before and
        %   nothing is written. rwedge:domain where one of both functions has it; rwedge:path;
        %   rwedge:sliding; rwedge:range; rwedge:handle; rwedge:memory.
            if nargin < 7
                error('rwedge:arguments', 'too few arguments: [sxx, syy, txy] = contact.stress_history(P, M, Q, sigma, x, y)');
            end
            [sxx, syy, txy] = rwedge_mex('contact_stress_history', contact.number, P, M, Q, sigma, x, y);
            contact.warn_of_size();
        end

        function value = state_size(contact)
        %STATE_SIZE  value = contact.state_size()
        %   How many numbers rwedge_contact.state() gives for the contact as it is.   new
            value = rwedge_mex('contact_state_size', contact.number);
        end

        function state = state(contact)
        %STATE  state = contact.state()
        %   The contact as numbers, for restarts and for other processes. A contact that is made of them
        %   gives the same bits from then on. They have no other use. Their form has a version: this library
        %   reads its own and those of older libraries.   new
        %     n      rwedge_contact.state_size()
        %     state  receives n numbers
        %   rwedge:handle; rwedge:range for another n.
            state = rwedge_mex('contact_state', contact.number);
        end

        function slip = slip(contact, x)
        %SLIP  slip = contact.slip(x)
        %   Slip at n points of the surface, length: how far the half-plane's surface has moved tangentially,
        %   relative to the wedge's, since the point last came into contact. It has the sign of q while it
        %   grows, so that q d(slip) is the heat. It is 0 where a point has stuck ever since. In full
        %   sliding the loads do not determine the rigid displacement. The slip is then the least that the
        %   loads need: the centre of the contact is on the verge of slip.
        %      Eq. (17) to (21); new
        %     x     length, |x| <= b: points outside have no partner
        %     slip  receives n numbers
        %   rwedge:path off the centre where rings of contact slipped at once when they came into contact,
        %   or slipped after they had been added to others that slipped before, and in full sliding.
        %   rwedge:domain; rwedge:handle. Nothing is written unless every point is in the domain.
        %   Error below 1e-12 f theta b, for loads that differ by 1 % or more.
            if nargin < 2
                error('rwedge:arguments', 'too few arguments: slip = contact.slip(x)');
            end
            slip = rwedge_mex('contact_slip', contact.number, x);
        end

        function value = dissipated_energy(contact)
        %DISSIPATED_ENERGY  value = contact.dissipated_energy()
        %   Energy dissipated by friction since the contact was created, per unit thickness (a force): the
        %   time integral of the traction times the rate of slip over the contact, without the rigid
        %   displacement in full sliding. It never falls. In a cycle under constant P it is the area of the
        %   loop of Q over the rigid displacement.   new
        %   A load off the centre that slips while P or M change, or slides, has no single
        %   integral: the energy is then NaN until the first load after the bodies have separated, from
        %   which it counts again. What was dissipated between is missing in the sum. Relative error of each
        %   load's share below 1e-12, and epsilon times P over the change of Q/f where that slip reaches an
        %   older layer. Off the centre it is below 1e-12 and 1e-14 times P over the change of Q/f. Both grow
        %   with 1/(1 - |tilt|/theta), and with |x| at the edges over the width where that is above 1.
            value = rwedge_mex('contact_dissipated_energy', contact.number);
        end

        function [factor, x, y] = yield_factor(contact, nu, k)
        %YIELD_FACTOR  [factor, x, y] = contact.yield_factor(nu, k)
        %   How far the present state is from first yield (von Mises, plane strain): k over the maximum of
        %   sqrt(J2) over the half-plane. Loads times this factor would not just yield, because the contact
        %   grows with them: see rwedge_yield_load().
        %     nu      Poisson's ratio of the half-plane, 0 <= nu <= 0.5
        %     factor  receives the factor: above 1 all is elastic; 0 where the stress is infinite, at the
        %             apex of the sharp wedge
        %     x, y    where the maximum is, length
        %   The search is for the global maximum, around each remembered edge of slip, at every scale. It
        %   takes as long as the stresses at about 7000 points for a first load, and at 25 000 where
        %   rwedge_contact.memory() is 250. rwedge:absent when separated: there is no stress.
        %   rwedge:domain; rwedge:handle; rwedge:range where the factor leaves the domain. Relative error
        %   below 1e-12.
        %     k  yield stress in pure shear, stress, finite, > 0
            if nargin < 3
                error('rwedge:arguments', 'too few arguments: [factor, x, y] = contact.yield_factor(nu, k)');
            end
            [factor, x, y] = rwedge_mex('contact_yield_factor', contact.number, nu, k);
            contact.warn('safety', factor);
        end

        function [stress_range, swt, swt_angle, fatemi_socie, fs_angle] = cycle_fatigue(contact, P, M, Q, sigma, x, y, E, nu, k_over_sy)
        %CYCLE_FATIGUE  [stress_range, swt, swt_angle, fatemi_socie, fs_angle] = contact.cycle_fatigue(P, M, Q, sigma, x, y, E, nu, k_over_sy)
        %   Fatigue parameters at n points of the half-plane, from the stresses after each load.   new
        %     x, y            length, finite, y >= 0: n numbers each; not the apex (0, 0) of a loaded sharp
        %                     wedge
        %     stress_range    receives n numbers: largest less smallest sxx
        %     swt, swt_angle  each receives n numbers: rwedge_smith_watson_topper()
        %     fatemi_socie, fs_angle  each receives n numbers: rwedge_fatemi_socie()
        %   rwedge:domain, rwedge:path, rwedge:sliding, rwedge:range, rwedge:handle, rwedge:memory. Errors
        %   as those of the functions that are named.
        %     P            0, or at least 1e-8 of the last P
        %     M, Q, sigma  finite: loads numbers each, as P
        %     E            Young's modulus, stress, 1e-60 to 1e60
        %     nu           Poisson's ratio of the half-plane, 0 <= nu <= 0.5
        %     k_over_sy    as in rwedge_fatemi_socie(), 1/stress, 0 or 1e-60 to 1e60
            if nargin < 10
                error('rwedge:arguments', 'too few arguments: [stress_range, swt, swt_angle, fatemi_socie, fs_angle] = contact.cycle_fatigue(P, M, Q, sigma, x, y, E, nu, k_over_sy)');
            end
            [stress_range, swt, swt_angle, fatemi_socie, fs_angle] = rwedge_mex('contact_cycle_fatigue', contact.number, P, M, Q, sigma, x, y, E, nu, k_over_sy);
        end

        function [slip_range, ruiz_f1, ruiz_f2, energy] = cycle_friction(contact, P, M, Q, sigma, x)
        %CYCLE_FRICTION  [slip_range, ruiz_f1, ruiz_f2, energy] = contact.cycle_friction(P, M, Q, sigma, x)
        %   What friction does at n places of the surface in the cycle. All is 0 where there is no contact.
        %   Slip counts from when a place came into contact. Where the contact leaves it and comes back, slip
        %   goes on from where it ended.   Ruiz, Boddington, Chen (1984), see lib/README.md; new
        %     x           length, finite: n numbers; not the apex 0 of a loaded sharp wedge
        %     slip_range  receives n numbers: largest less smallest slip, length
        %     ruiz_f1     receives n numbers: largest |q| times slip range
        %     ruiz_f2     receives n numbers: ruiz_f1 times the largest sxx after a load, 0 where that is not
        %                 tensile
        %     energy      receives n numbers: dissipated per area, the integral of q d(slip)
        %   rwedge:path where the slip has no closed form after one of the loads, or on the way to
        %   separation; rwedge:domain, rwedge:sliding, rwedge:range, rwedge:handle, rwedge:memory. Under
        %   constant P and M slip and energy are those of rwedge_contact.slip() and the tractions. Where they
        %   change, a step is cut into 32 parts: the energy of the contact then errs by 0.1 % in usual
        %   cycles, and by 1 % where little slips.
        %     P            0, or at least 1e-8 of the last P
        %     M, Q, sigma  finite: loads numbers each, as P
            if nargin < 6
                error('rwedge:arguments', 'too few arguments: [slip_range, ruiz_f1, ruiz_f2, energy] = contact.cycle_friction(P, M, Q, sigma, x)');
            end
            [slip_range, ruiz_f1, ruiz_f2, energy] = rwedge_mex('contact_cycle_friction', contact.number, P, M, Q, sigma, x);
        end

        function [worst_x, worst_value] = cycle_worst(contact, measure, P, M, Q, sigma, x, value, y, E, nu, k_over_sy)
        %CYCLE_WORST  [worst_x, worst_value] = contact.cycle_worst(measure, P, M, Q, sigma, x, value, y, E, nu, k_over_sy)
        %   Where a measure of the cycle is largest on a line along x: at the places at which it is known, or
        %   between them, around its tops.   new
        %     measure                 0 <= measure <= 6: RWEDGE_MEASURE_STRESS_RANGE to RWEDGE_MEASURE_ENERGY_PER_AREA
        %     x                       length, finite; ascending: n numbers
        %     value                   at least 0, finite: the measure there, n numbers, 0 where there is none
        %     y                       depth, length, finite, y >= 0; 0 for slip, F1, F2 and energy
        %     worst_x, worst_value    each receives one number
        %   rwedge:domain where x does not ascend too; rwedge:range for n = 0; the others as in
        %   rwedge_contact.cycle_friction(). The place is found to 1e-10 of the distance of its neighbours
        %   where the top is not flat.
        %     P            0, or at least 1e-8 of the last P
        %     M, Q, sigma  finite: loads numbers each, as P
        %     E            Young's modulus, stress, 1e-60 to 1e60
        %     nu           Poisson's ratio of the half-plane, 0 <= nu <= 0.5
        %     k_over_sy    as in rwedge_fatemi_socie(), 1/stress, 0 or 1e-60 to 1e60
            if nargin < 12
                error('rwedge:arguments', 'too few arguments: [worst_x, worst_value] = contact.cycle_worst(measure, P, M, Q, sigma, x, value, y, E, nu, k_over_sy)');
            end
            [worst_x, worst_value] = rwedge_mex('contact_cycle_worst', contact.number, measure, P, M, Q, sigma, x, value, y, E, nu, k_over_sy);
        end

        function value = displacement(contact, b)
        %DISPLACEMENT  value = contact.displacement(b)
        %   How far remote points of the half-plane have moved along the surface against the wedge's, further
        %   than if the contact were bonded over |x| < b: what slip adds. Its loop over Q encloses the energy
        %   of a cycle under constant P. See lib/cycle/displacement.c.   new
        %     b  length, > 0, finite
        %   NaN for NULL and when separated; NaN off the centre where the slip has no closed form, as in
        %   rwedge_contact.slip(). Relative error below 1e-12; off the centre 1e-6 of f theta times the
        %   half-width.
            if nargin < 2
                error('rwedge:arguments', 'too few arguments: value = contact.displacement(b)');
            end
            value = rwedge_mex('contact_displacement', contact.number, b);
        end
    end
    methods (Access = private)
        function warn_of_size(contact)
            b = rwedge_mex('contact_half_width', contact.number);
            if b > 0
                contact.warn('alpha', contact.a / b);
            end
        end

        % Warns by rwedge_validity of the arguments that are given by name.
        function warn(contact, varargin)
            known = struct('theta', NaN, 'alpha', NaN, 'beta', NaN, 'f', NaN, 'safety', NaN);
            for k = 1:2:numel(varargin)
                known.(varargin{k}) = varargin{k + 1};
            end
            doubts = rwedge_mex('validity', known.theta, known.alpha, known.beta, known.f, NaN, known.safety);
            bit = 1;
            while doubts >= bit
                if bitand(doubts, bit)
                    warning('rwedge:validity', '%s', rwedge_mex('validity_text', bit));
                end
                bit = 2 * bit;
            end
        end
    end
    methods (Static)
        function contact = restore(state)
        %RESTORE  contact = rwedge_contact.restore(state)
        %   The contact of such numbers.   new
        %     state    not other than rwedge_contact.state() gave it: Inf and NaN may be in it
        %   rwedge:domain where the numbers are not those of a contact, rwedge:memory. Free
        %   with rwedge_contact.destroy().
            if nargin < 1
                error('rwedge:arguments', 'too few arguments: contact = rwedge_contact.restore(state)');
            end
            contact = rwedge_contact();
            contact.number = rwedge_mex('contact_restore', state);
        end
    end
end

% SPDX-License-Identifier: GPL-3.0-or-later
