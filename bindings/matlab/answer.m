% SPDX-License-Identifier: GPL-3.0-or-later
% Answers the calls of tests/answers/calls.py from standard input as tests/answers/answer.c does, through the functions and classes.
1;

function text = bits(value)
    if isnan(value)
        text = ',nan';
    else
        text = [',' num2hex(value)];
    end
end

% The numbers of a result; of a text its length.
function numbers = column(result)
    if ischar(result)
        numbers = numel(result);
    else
        numbers = result(:);
    end
end

function numbers = argument(text, before)
    if strcmp(text, '@')
        numbers = before;
    else
        numbers = str2num(['[' text ']']).'; % the points of a load; here they stand in a column
    end
end

% The object of a family that a function makes: of its class, by a method of the class, or by one of another object.
function object = made(family, method, object, given)
    class_name = ['rwedge_' family];
    if strcmp(method, 'create')
        object = feval(class_name, given{:});
    elseif isempty(given)
        object = feval(method, object);
    else
        object = eval([class_name '.' method '(given{:})']);
    end
end

function [results, objects] = answer(name, count, given, objects)
    results = cell(1, count);
    parts = regexp(name, '^(contact|series)_(\w+)$', 'tokens', 'once');
    if isempty(parts)
        name = regexprep(name, {'^stresses$', '^elastic_limits$'}, {'stress', 'elastic_limit'});
        [results{:}] = feval(['rwedge_' name], given{:});
    elseif ~isempty(regexp(parts{2}, '^(create|copy|restore|fit)', 'once'))
        objects.(parts{1}) = made(parts{1}, parts{2}, objects.(parts{1}), given);
    else
        [results{:}] = feval(parts{2}, objects.(parts{1}), given{:});
    end
end

objects = struct('contact', [], 'series', []);
before = [];
line = fgetl(stdin);
while ischar(line)
    parts = strsplit(line, ',');
    head = strsplit(parts{1}, ':');
    given = cellfun(@(text) argument(text, before), parts(2:end), 'UniformOutput', false);
    try
        [results, objects] = answer(head{1}, str2double(head{2}), given, objects);
        results = cellfun(@column, results, 'UniformOutput', false);
        before = vertcat(results{:});
        texts = arrayfun(@bits, before', 'UniformOutput', false);
        text = ['' texts{:}];
    catch
        text = ',error';
    end
    disp([line text]);
    line = fgetl(stdin);
end
