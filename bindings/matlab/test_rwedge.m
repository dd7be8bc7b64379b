% SPDX-License-Identifier: GPL-3.0-or-later
% The functions and classes as their users meet them: shapes, errors, NaN, and handles.
1;

function claim(sentence, holds)
    global failures
    if ~holds
        failures = failures + 1;
        printf('FAILED: %s\n', sentence);
    end
end

% The call ends with the error of that identifier, and its message has all these words.
function refused(identifier, words, call)
    try
        call();
        claim([func2str(call) ' is refused'], false);
    catch err
        claim([func2str(call) ': ' err.identifier], strcmp(err.identifier, ['rwedge:' identifier]));
        for word = words
            claim([err.message ': has ' word{1}], ~isempty(strfind(err.message, word{1})));
        end
    end
end

function leaves_by_error()
    c = rwedge_contact(0.01, 0.5, 1.8e-5, 0.6);
    c.load(1000, [100 601]);
end

function yield_factor_out_of_range()
    c = rwedge_contact(0.01, 0.5, 1.8e-5, 0.6);
    c.load(1e-10, 0);
    c.yield_factor(0.3, 1e60);
end

function two_results()
    [~, ~] = rwedge_mex('load', 0.3);
end

function shapes()
    alpha = reshape(0.1:0.1:2.4, 2, 3, 4);
    claim('the shape of the argument', isequal(size(rwedge_load(alpha)), [2 3 4]));
    claim('a row, a column', isrow(rwedge_load(1:3)) && iscolumn(rwedge_load((1:3)')));
    claim('empty', isequal(size(rwedge_load(zeros(0, 3))), [0 3]) && isempty(rwedge_pressure([], 0.3)));
    for i = [1 7 24]
        claim('a scalar goes with every element', isequal(rwedge_shear(alpha, 0.2, 0.5)(i), rwedge_shear(alpha(i), 0.2, 0.5)));
    end
    [limit, x, y] = rwedge_yield_point(alpha, 0.1, 0.3);
    [limit1, x1, y1] = rwedge_yield_point(alpha(5), 0.1, 0.3);
    claim('several results', isequal([limit(5) x(5) y(5)], [limit1 x1 y1]) && isequal(size(y), [2 3 4]));
    p = linspace(-1.5, 1.5, 100);
    [sxx, ~, txy] = rwedge_stress(0.3, 0.2, 0.5, p, abs(p));
    [a, ~, c] = rwedge_stress(0.3, 0.2, 0.5, p(7), abs(p(7)));
    claim('an array of stresses is that of its points', isequal([a c], [sxx(7) txy(7)]));
    claim('one output', isequal(rwedge_stress(0.3, 0.2, 0.5, p, 0.1 + 0 * p)(3), rwedge_stress(0.3, 0.2, 0.5, p(3), 0.1)));
    refused('size', {'rwedge_pressure: x has'}, @() rwedge_pressure(1:3, 1:2));
    refused('size', {'x has the size 2 in dimension 3', 'have 4'}, @() rwedge_pressure(alpha, zeros(2, 3, 2)));
    grid = rwedge_shear([0.2 0.4 0.6], [0.1; 0.3], reshape([0.2 0.5], 1, 1, 2));
    claim('the size of a grid', isequal(size(grid), [2 3 2]));
    claim('a grid', grid(2, 3, 1) == rwedge_shear(0.6, 0.3, 0.2) && grid(1, 2, 2) == rwedge_shear(0.4, 0.1, 0.5));
    claim('a row goes with nothing', isequal(size(rwedge_pressure(zeros(0, 1), 1:3)), [0 3]));
    [sxx, ~, txy] = rwedge_stress(0.3, 0.2, 0.5, -1:0.5:1, (0.1:0.1:0.3)');
    [one, ~, other] = rwedge_stress(0.3, 0.2, 0.5, 0.5, 0.2);
    claim('a grid of points', isequal(size(txy), [3 5]) && sxx(2, 4) == one && txy(2, 4) == other);
end

function classes()
    claim('single', rwedge_load(single(0.25)) == rwedge_load(0.25) && isa(rwedge_load(single(0.25)), 'double'));
    claim('integers', isequal(rwedge_load(int32([1 2])), rwedge_load([1 2])) && rwedge_load(uint8(3)) == rwedge_load(3));
    claim('logical', rwedge_load(true) == rwedge_load(1));
    c = rwedge_contact(0.01, int8(1), 1.8e-5, single(0.5));
    c.load(int32(1000), int16([0 100]));
    d = rwedge_contact(0.01, 1, 1.8e-5, 0.5);
    d.load(1000, [0 100]);
    claim('loads of other classes', c.dissipated_energy() == d.dissipated_energy() && c.half_width() == d.half_width());
    for wrong = {'0.25', {0.25}, struct('x', 1)}
        refused('class', {'rwedge_load: alpha is not', class(wrong{1})}, @() rwedge_load(wrong{1}));
    end
end

% The last warning has these words; none where they are empty.
function said(sentence, words)
    [text, identifier] = lastwarn();
    claim(sentence, strcmp(text, words) && (isempty(words) || strcmp(identifier, 'rwedge:validity')));
    lastwarn('', '');
end

% What is said in warnings, in order of the calls.
function doubts()
    lastwarn('', '');
    warning('on', 'rwedge:validity');
    c = rwedge_contact(0.01, 0.5, 1.8e-5, 0.3, 0);
    c.load(2000, 0);
    c.yield_factor(0.3, 1e4);
    c.load(0, 0);
    said('nothing is doubtful', '');
    rwedge_contact(1.15, 0.5, 1.8e-5, 0.3);
    said('the angle', rwedge_validity_text(1));
    rwedge_contact(0.01, 0.5, 1.8e-5, 0.3, rwedge_dundurs_beta(2.1e5, 0.3, 7e4, 0.33));
    said('the bodies', rwedge_validity_text(2));
    c.load(2000, 0);
    c.yield_factor(0.3, 10);
    said('yield', rwedge_validity_text(4));
    c.load(1e7, 0);
    said('units', rwedge_validity_text(8));
    d = c.copy();
    d.load(2e7, 0);
    said('units, of a copy', rwedge_validity_text(8));
    warning('off', 'rwedge:validity');
end

function shown()
    c = rwedge_contact(0.01, 0.5, 1.8e-5, 0.6);
    c.load(2000, 0);
    c.load(2000, 300);
    text = evalc('disp(c)');
    words = {'P = 2000', 'Q = 300', sprintf('half-width %.6g', c.half_width()), sprintf('%.6g', c.stick_half_width())};
    for word = words
        claim(['a contact shows ' word{1}], ~isempty(strfind(text, word{1})));
    end
    text = evalc('c');
    claim('at the prompt too', ~isempty(strfind(text, 'P = 2000')));
    delete(c);
    claim('a deleted one', ~isempty(strfind(evalc('disp(c)'), 'deleted')));
end

function errors()
    claim('NaN gives NaN', isnan(rwedge_load(NaN)) && isnan(rwedge_elastic_limit(0.3, NaN, 0.3)));
    claim('outside the domain, NaN', isequaln(rwedge_load([-1 1]), [NaN rwedge_load(1)]));
    claim('no whole number, NaN', isnan(rwedge_coefficient(0.3, 1.5)) && isnan(rwedge_coefficient(0.3, 1e10)));
    refused('domain', {'rwedge_stress', 'outside its domain', 'y = -1', '0, or 1e-60 to 1e60', 'element 2'}, ...
        @() rwedge_stress(0.3, 0.2, 0, 0, [1 -1]));
    refused('domain', {'y = NaN'}, @() rwedge_stress(0.3, 0.2, 0, [0 0], [1 NaN]));
    refused('domain', {': f = 2000000; allowed is 0, or 1e-60 to 1e6'}, @() rwedge_stress(0.3, 2e6, 0, 0, 1));
    refused('domain', {'alpha = 0, f = 0.2', 'not the apex (0, 0)'}, @() rwedge_stress(0, 0.2, 0, 0, 0)); % none alone is to blame
    refused('domain', {'nu = 0.6', '0 <= nu <= 0.5'}, @() rwedge_yield_point(0.3, 0.2, 0.6));
    refused('domain', {'alpha = 1e-15', '1e-14'}, @() rwedge_yield_point(1e-15, 0.2, 0.3));
    refused('domain', {'theta = 2', 'pi/2'}, @() rwedge_contact(2, 0.5, 1.8e-5, 0.6));
    refused('domain', {': terms = 2.5; allowed is whole, 1 <= terms <= 2^24'}, @() rwedge_series(0.3, 2.5));
    refused('range', {': terms = 0; allowed is whole, 1 <= terms <= 2^24'}, @() rwedge_series(0.25, 0));
    refused('range', {'rwedge_series_fit', 'samples * terms <= 2^27'}, @() rwedge_series.fit(0.1:0.1:0.9, 0.1:0.1:0.9, 2^24));
    refused('rank', {'rwedge_series_fit'}, @() rwedge_series.fit([0.1 0.1 0.1], [1 1 1], 3));
    refused('class', {'complex'}, @() rwedge_load(1 + 2i));
    refused('class', {'sparse'}, @() rwedge_load(sparse([1 0 2])));
    refused('domain', {'x = 1', '|x| < 1', 'element 2'}, @() rwedge_series.fit([0.1 1 2], [1 1 1], 1));
    refused('domain', {'p = NaN', 'element 3'}, @() rwedge_series.fit([0.1 0.2 0.3], [1 1 NaN], 1));
    refused('arguments', {'rwedge_load(alpha)'}, @() rwedge_load());
    refused('arguments', {'rwedge_stress(alpha, f, c, x, y)'}, @() rwedge_stress(0.3, 0.2));
    refused('arguments', {'rwedge_contact(theta, a, A, f)'}, @() rwedge_contact(0.01, 0.5, 1.8e-5));
    refused('arguments', {'rwedge_series(alpha, terms)'}, @() rwedge_series(0.3));
    refused('arguments', {'fit(x, p, terms)'}, @() rwedge_series.fit(0.1, 1));
    refused('arguments', {'no such function'}, @() rwedge_mex('nothing'));
    refused('arguments', {'rwedge_pressure takes 2 argument(s)'}, @() rwedge_mex('pressure', 1));
    refused('arguments', {'gives 1 result(s), not 1 and 2'}, @() two_results());
    [limit, x] = rwedge_surface_yield(0.3, [0 0.1], 0.5);
    claim('an absent branch is NaN, a sweep goes on', isequal(isnan([limit; x]), [true false; true false]));
end

function contacts()
    c = rwedge_contact(0.01, 0.5, 1.8e-5, 0.6);
    refused('absent', {'contact_yield_factor', 'unloaded'}, @() c.yield_factor(0.3, 300));
    c.load(1000, 300);
    refused('sliding', {'exceeds friction', 'P = 1000', 'Q = 601'}, @() c.load(1000, 601));
    refused('domain', {': P = -1; allowed is 0, or 1e-60 to 1e60'}, @() c.load(-1, 0));
    refused('range', {'P = 1e-06, Q = 0; allowed is P 0, or', 'not below 1e-8 of the last P, Q 0, or 1e-60 to 1e60 in magnitude, |Q| <= f P'}, @() c.load(1e-6, 0));
    refused('range', {'k = 1e+60; allowed is', 'k 1e-60 to 1e60'}, @() yield_factor_out_of_range());
    refused('domain', {'x = Inf', 'element 3'}, @() c.tractions([0 0.1 Inf]));
    refused('domain', {'x = 50', '|x| <= b'}, @() c.slip(50));
    refused('arguments', {'contact.load(P, Q)'}, @() c.load(1000));
    before = c.state();
    refused('sliding', {'Q = 1000000', 'element 3'}, @() c.load(1500, [100 200 1e6]));
    refused('path', {'element 2'}, @() c.apply(1500, [0 800], 100, 0));
    claim('of loads of which one is refused, none is taken', isequal(c.state(), before));
    other = c.copy();
    other.load(1500, [100 -200]);
    c.load(1500, 100);
    c.load(1500, -200);
    claim('loads at once are the loads one by one', isequal(c.state(), other.state()));
    sharp = rwedge_contact(0.01, 0, 1.8e-5, 0.6);
    sharp.load(1000, 0);
    refused('domain', {'x = 0', 'sharp wedge'}, @() sharp.tractions(0));
    refused('domain', {'x = 0, y = 0', 'not the apex (0, 0)'}, @() sharp.stresses(0, 0));
    refused('handle', {'no such contact'}, @() rwedge_contact().load(1, 0));
    refused('handle', {'no such contact'}, @() rwedge_mex('contact_load', 1e6, 1, 0));
    x = [0 0.3; -0.2 0.5] * c.half_width();
    [p, q] = c.tractions(x);
    claim('the shape of x', isequal(size(p), [2 2]) && isequal(size(q), [2 2]));
    [~, q1] = c.tractions(x(2));
    claim('a traction of an array', q1 == q(2));
    d = c.copy();
    same = c;
    d.load(1000, -500);
    [~, after] = c.tractions(x);
    claim('a copy is independent', isequal(after, q));
    same.load(1000, -500);
    [~, after] = c.tractions(x);
    claim('an assignment is the same contact', ~isequal(after, q));
    all = rwedge_contact(0.01, 0.5, 1.8e-5, 0.6);
    all.load(1000, [0 300 -500]);
    tilted = rwedge_contact(0.01, 0.5, 1.8e-5, 0.6);
    tilted.apply(1000, 100, 0, 0);
    refused('path', {'the two edges would slip in opposite directions'}, @() tilted.apply(1000, 100, 0, 500));
    sticking = rwedge_contact(0.1, 17.8, 4.81e-5, 0.65);
    refused('path', {'where the edges slip in opposite directions'}, ...
        @() sticking.permanent_stick(300, 0, 0, 0, 300, 0, 0, 900));
    [factor, x, y] = all.yield_factor(0.3, 300);
    claim('yield factor', factor > 0 && y >= 0 && abs(x) <= all.half_width());
    refused('domain', {'slope'}, @() rwedge_contact.create_profile([0 1], [0.1 0], 1e-4, 0.5));
    delete(all);
    refused('handle', {'any more'}, @() all.half_width());
    refused('handle', {'contact_copy', 'any more'}, @() all.copy());
end

function lives()
    before = rwedge_mex('alive');
    c = rwedge_contact(0.01, 0.5, 1.8e-5, 0.6);
    d = c;
    s = rwedge_series(0.3, 5);
    claim('two alive', rwedge_mex('alive') == before + 2);
    clear c
    claim('held by d', rwedge_mex('alive') == before + 2);
    clear d s
    claim('none left by clear', rwedge_mex('alive') == before);
    try
        leaves_by_error();
    catch
    end
    claim('none left by an error', rwedge_mex('alive') == before);
    try
        rwedge_contact(0.01, -1, 1, 1);
    catch
    end
    claim('none made by a constructor that fails', rwedge_mex('alive') == before);
    many = cell(1, 100);
    for i = 1:100
        many{i} = rwedge_contact(0.01, 0.5, 1.8e-5, i / 100);
        many{i}.load(1000, 0);
    end
    claim('a hundred, each its own', rwedge_mex('alive') == before + 100 && many{3}.half_width() == many{97}.half_width());
    clear -f rwedge_mex % it holds objects: it must stay
    claim('objects outlive clear -f', many{50}.half_width() > 0 && rwedge_mex('alive') == before + 100);
    many = [];
    claim('none left', rwedge_mex('alive') == before);
end

function cycles()
    pad = rwedge_contact(0.005, 0.1, rwedge_compliance(72e3, 0.33, 72e3, 0.33), 0.6);
    pad.load(60, 0);
    single = pad.copy();
    Q = [20; -10; 28];
    x = [-0.2 0.05 0.3 0.1];
    y = [0 0.1 0 0.2];
    [sxx, syy, txy] = pad.stresses_after([60 + 0 * Q, Q], x, y);
    for i = 1:3
        single.load(60, Q(i));
        [a, b, c] = single.stresses(x, y);
        claim('a cycle has the bits of loads one by one', isequal(sxx(:, i), a') && isequal(syy(:, i), b') && ...
            isequal(txy(:, i), c'));
    end
    four = single.copy();
    claim('a row of two or of four', isequal(pad.stresses_after([60 -20], x, y), four.stresses_after([60 0 -20 0], x, y)));
    identifier = '';
    try
        pad.stresses_after([60 0 20], x, y);
    catch err
        identifier = err.identifier;
    end
    claim('a row of three is refused', strcmp(identifier, 'rwedge:size'));
    cycle = rwedge_cycle(pad, [60; 60], [0; 0], [20; -20], [0; 0]);
    [left, right] = cycle.permanent_stick();
    [l, r] = pad.permanent_stick(60, 0, 20, 0, 60, 0, -20, 0);
    claim('what never slips', abs(left - l) < 1e-12 && abs(right - r) < 1e-12);
    b = pad.half_width();
    clear pad
    slip = cycle.friction([0 0.99 * b]);
    claim('a cycle outlives its contact', cycle.loads() == 2 && slip(1) == 0 && slip(2) > 0);
    [sxx, ~, ~] = cycle.stresses(x, y);
    claim('a column for each load', isequal(size(sxx), [4 2]));
    delete(cycle);
    identifier = '';
    try
        cycle.loads();
    catch err
        identifier = err.identifier;
    end
    claim('a cycle that was deleted is none', strcmp(identifier, 'rwedge:handle'));
end

global failures
failures = 0;
shapes();
errors();
classes();
doubts();
shown();
contacts();
lives();
cycles();
exit(double(failures > 0));
