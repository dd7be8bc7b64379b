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
%   c.load(P, Q)
%   value = c.half_width()
%   value = c.stick_half_width()
%   value = c.memory()
%   [p, q] = c.tractions(x)
%   [sxx, syy, txy] = c.stresses(x, y)
%   slip = c.slip(x)
%   value = c.dissipated_energy()
%   [factor, x, y] = c.yield_factor(nu, k)
%   d = c.copy()                            an independent copy, to try a load and go back; d = c is the same contact
%
%   c.load(P, Q) takes vectors too, one load after the other: those before one that is refused stay.
%
%   It is freed when the last variable that holds it is cleared. "help rwedge_contact.load" and so on say more.
    properties (SetAccess = private, Hidden, Transient)
        number = 0
    end
    methods
        function contact = rwedge_contact(theta, a, A, f)
            if nargin > 0 && nargin < 4
                error('rwedge:arguments', 'too few arguments: contact = rwedge_contact(theta, a, A, f)');
            elseif nargin > 0
                contact.number = rwedge_mex('contact_create', theta, a, A, f);
            end
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
        end

        function load(contact, P, Q)
        %LOAD  contact.load(P, Q)
        %   The next point of the history, reached in a straight line of the (P, Q) plane from the last one.
        %      Sec. 3.2; new
        %     P  0, or 1e-60 to 1e60; not below 1e-8 of the last P: but 0 may follow any load. It separates
        %        the bodies (Q must then be 0 too), and all but the dissipated energy is forgotten
        %     Q  |Q| <= f P; equality is full sliding, to 8 epsilon of f times the larger of P and the last
        %        P
        %   rwedge:sliding where |Q| > f P. rwedge:domain. rwedge:range where the half-width, a/b, the
        %   peak pressure or the energy leaves the domain. rwedge:range too where P is not 0 but below
        %   1e-8 of the last P, whose rounding would blur what Q/(fP) is: go there in two loads.
        %   rwedge:handle; rwedge:memory. After an error the contact is as before; of
        %   vectors, the loads before the one that is refused stay. It remembers at most
        %   two points of the history per load, and of them only those that no later load has wiped out.
            if nargin < 3
                error('rwedge:arguments', 'too few arguments: contact.load(P, Q)');
            end
            rwedge_mex('contact_load', contact.number, P, Q);
        end

        function value = half_width(contact)
        %HALF_WIDTH  value = contact.half_width()
        %   Half-width b of the contact, length; 0 when separated.
        %      Eq. (7), (11), (15), inverse
            value = rwedge_mex('contact_half_width', contact.number);
        end

        function value = stick_half_width(contact)
        %STICK_HALF_WIDTH  value = contact.stick_half_width()
        %   Half-width c of the stick zone, length. Outside it, c < |x| < b, friction is exhausted: |q| = f
        %   |p|. c is b where all sticks, 0 in full sliding and when separated.
        %      Eq. (25); new
            value = rwedge_mex('contact_stick_half_width', contact.number);
        end

        function value = memory(contact)
        %MEMORY  value = contact.memory()
        %   How many points of its history the contact remembers; 0 when separated. The time
        %   of its functions grows in proportion, for each point of the half-plane.
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
        %   Relative error of each load's share below 1e-12, and epsilon times P over the
        %   change of Q/f where that slip reaches an older layer.
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
        %   takes a millisecond for a first load, and its time grows with the square of
        %   rwedge_contact.memory(). rwedge:absent when separated: there is no stress. rwedge:domain;
        %   rwedge:handle; rwedge:range where the factor leaves the domain. Relative error below 1e-12.
        %     k  yield stress in pure shear, stress, finite, > 0
            if nargin < 3
                error('rwedge:arguments', 'too few arguments: [factor, x, y] = contact.yield_factor(nu, k)');
            end
            [factor, x, y] = rwedge_mex('contact_yield_factor', contact.number, nu, k);
        end
    end
end

% SPDX-License-Identifier: GPL-3.0-or-later
