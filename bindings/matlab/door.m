% SPDX-License-Identifier: GPL-3.0-or-later
% Answers the calls of tests/doors/calls.sh from standard input as tests/doors/door.c does, through the functions and classes.
1;

function text = bits(value)
    if isnan(value)
        text = ',nan';
    else
        text = [',' num2hex(value)];
    end
end

results = struct('stress', 3, 'yield_point', 3, 'subsurface_yield', 3, 'surface_yield', 2, 'contact_tractions', 2, ...
    'contact_stresses', 3, 'contact_yield_factor', 3, 'contact_load', 0);
line = fgetl(stdin);
while ischar(line)
    parts = strsplit(line, ',');
    name = parts{1};
    arguments = num2cell(str2double(parts(2:end)));
    count = 1;
    if isfield(results, name)
        count = results.(name);
    end
    r = cell(1, count);
    if strcmp(name, 'contact_create')
        contact = rwedge_contact(arguments{:});
        r = {};
    elseif strncmp(name, 'contact_', 8)
        [r{:}] = feval(name(9:end), contact, arguments{:});
    else
        [r{:}] = feval(['rwedge_' name], arguments{:});
    end
    r = cellfun(@bits, r, 'UniformOutput', false);
    disp([line r{:}]);
    line = fgetl(stdin);
end
