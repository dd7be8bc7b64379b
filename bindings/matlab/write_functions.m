% SPDX-License-Identifier: GPL-3.0-or-later
function names = write_functions(header, templates, folder)
%WRITE_FUNCTIONS  Writes the functions and classes of rwedge into FOLDER: each a call of rwedge_mex, with the comment of
%   rwedge.h as its help text. NAMES are the functions of the header, what serves each, and
%   its numbers of arguments and results.
[declared, common] = read_header(header);
names = cell(0, 4);
methods = struct('contact', '', 'series', '');
for i = 1:numel(declared)
    d = declared(i);
    family = regexp(d.name, '^(contact|series)_', 'match', 'once');
    if any(strcmp(d.name, {'stresses', 'elastic_limits'}))
        server = ['rwedge_' d.name(1:end - 2 + strcmp(d.name, 'elastic_limits'))]; % takes arrays as it is
    elseif isempty(family)
        server = ['rwedge_' d.name];
        write_text(fullfile(folder, [server '.m']), function_text(d, common));
    else
        family = family(1:end - 1);
        server = ['rwedge_' family];
        if isempty(regexp(d.name, '_(create|copy|destroy|fit)$', 'once'))
            methods.(family) = [methods.(family) method_text(d, family, common)];
        end
    end
    names(end + 1, :) = {['rwedge_' d.name], server, numel(d.inputs), numel(d.outputs)}; %#ok<AGROW>
end
for family = {'contact', 'series'}
    text = fileread(fullfile(templates, ['rwedge_' family{1} '.m.in']));
    text = regexprep(text, '^% SPDX[^\n]*\n', '');
    text = strrep(text, ['        %@methods' char(10)], methods.(family{1}));
    for i = 1:numel(declared)
        text = insert_help(text, declared(i), common);
    end
    write_text(fullfile(folder, ['rwedge_' family{1} '.m']), text);
end
end

% Every function that the header declares, and its lists of arguments that return.
function [declared, common] = read_header(file)
declared = struct('name', {}, 'inputs', {}, 'outputs', {}, 'comment', {}, 'dimensional', {});
common = struct('natural', {cell(0, 2)}, 'dimensional', {cell(0, 2)});
lines = regexp(fileread(file), '\r?\n', 'split');
comment = {};
section = 'natural';
i = 0;
while i < numel(lines)
    i = i + 1;
    line = lines{i};
    if ~isempty(strfind(line, '---- Dimensional quantities'))
        section = 'dimensional';
    elseif ~isempty(strfind(line, '---- The paper''s series'))
        section = 'natural';
    end
    if strncmp(line, '/*', 2)
        comment = {};
        while true
            comment{end + 1} = comment_line(lines{i}); %#ok<AGROW>
            if ~isempty(strfind(lines{i}, '*/'))
                break
            end
            i = i + 1;
        end
        if any(~cellfun(@isempty, regexp(comment, '[Aa]rguments that return', 'once'))) && isempty(common.(section))
            common.(section) = listed_arguments(comment);
        end
    elseif strncmp(line, 'RWEDGE_API', 10)
        while isempty(strfind(line, ';'))
            i = i + 1;
            line = [line ' ' strtrim(lines{i})]; %#ok<AGROW>
        end
        d = declaration(line);
        d.comment = comment;
        d.dimensional = strcmp(section, 'dimensional');
        declared(end + 1) = d; %#ok<AGROW>
    elseif isempty(line)
        comment = {};
    end
end
end

% A line of a comment without its marks, and its source ("Eq. (7)") not set off to the right.
function text = comment_line(line)
text = regexprep(line, {'^(/\*| \*) ?', ' *\*/$'}, '');
text = regexprep(text, '    +(Eq\.|Sec\.|Figs?\.|new$)', '   $1');
end

function d = declaration(line)
parts = regexp(line, '^RWEDGE_API (.*?)rwedge_(\w+)\((.*)\);', 'tokens', 'once');
d = struct('name', parts{2}, 'inputs', {{}}, 'outputs', {{}}, 'comment', {{}}, 'dimensional', false);
for argument = regexp(parts{3}, ' *, *', 'split')
    c = argument{1};
    name = regexp(c, '\w+(?=(\[\])?$)', 'match', 'once');
    if strcmp(c, 'void') || ~isempty(regexp(c, '^size_t|rwedge_', 'once'))
        continue % lengths are those of the arrays
    elseif ~isempty(regexp(c, '^double (\*|.*\[\])', 'once'))
        d.outputs{end + 1} = name;
    else
        d.inputs{end + 1} = name;
    end
end
if isempty(d.outputs) && (isempty(strfind(parts{1}, 'int32_t')) || strcmp(d.name, 'series_terms')) ...
        && isempty(regexp(parts{1}, '^void', 'once'))
    d.outputs = {'value'};
end
end

% {names, text} of the lines "  name, name  text" of a comment.
function list = listed_arguments(comment)
list = cell(0, 2);
for line = comment
    parts = regexp(line{1}, '^  (\w+(?:, \w+)*)  +(.*)$', 'tokens', 'once');
    if ~isempty(parts)
        list(end + 1, :) = {regexp(parts{1}, ', ', 'split'), line{1}}; %#ok<AGROW>
    end
end
end

% The help text after its first line: the comment, and the arguments that it does not list itself.
function lines = help_lines(d, common)
lines = d.comment(~strcmp(d.comment, '  contact  receives the handle'));
lines = strrep(lines, ' Free with rwedge_series_destroy().', '');
lines = without_pointers(lines, ~isempty(regexp(d.name, '^(contact|series)_(?!create|fit)', 'once')));
lines = strrep(lines, 'Unless RWEDGE_OK, the contact is as before.', ...
    'After an error the contact is as before; of vectors, the loads before the one that is refused stay.');
lines = regexprep(lines, {'(rwedge_(contact|series))_create\(', '(rwedge_(contact|series))_(\w+)\('}, {'$1(', '$1.$3('});
here = listed_arguments(d.comment);
if d.dimensional
    shared = common.dimensional;
else
    shared = common.natural;
end
for i = 1:size(shared, 1)
    if any(ismember(shared{i, 1}, d.inputs)) && ~any(ismember(shared{i, 1}, [here{:, 1}, {''}]))
        lines{end + 1} = shared{i, 2}; %#ok<AGROW>
    end
end
identifiers = {'DOMAIN', 'domain'; 'RANGE', 'range'; 'NOCONV', 'noconv'; 'NOMEM', 'memory'; ...
    'SLIDING', 'sliding'; 'RANK', 'rank'; 'ABSENT', 'absent'};
for i = 1:size(identifiers, 1)
    lines = strrep(lines, ['RWEDGE_E' identifiers{i, 1}], ['rwedge:' identifiers{i, 2}]);
end
lines = strrep(lines, 'HUGE_VAL', 'Inf');
end

% What the header says of NULL: a method's object may have been deleted, which is rwedge:handle, and nothing else can be NULL.
function lines = without_pointers(lines, is_method)
if is_method
    lines = strrep(lines, 'RWEDGE_ENULL', 'rwedge:handle');
else
    lines = regexprep(lines, {'[,;] RWEDGE_ENULL', '^RWEDGE_ENULL, '}, '');
end
lines = regexprep(lines, {'[;,] (NaN|0|and) for NULL', ' or NULL', '; each may be NULL', ', never NULL'}, '');
lines = regexprep(lines, ' ?\<NaN for NULL\. ?', '');
end

function text = commented(lines, margin)
text = '';
for line = lines
    text = [text regexprep([margin '%   ' line{1}], ' +$', '') char(10)]; %#ok<AGROW>
end
end

% "[p, q] = name(x)"
function text = call_text(outputs, name, inputs)
text = [name '(' strjoin(inputs, ', ') ')'];
if numel(outputs) == 1
    text = [outputs{1} ' = ' text];
elseif numel(outputs) > 1
    text = ['[' strjoin(outputs, ', ') '] = ' text];
end
end

function text = function_text(d, common)
name = ['rwedge_' d.name];
call = call_text(d.outputs, name, d.inputs);
lines = help_lines(d, common);
notes = {};
if ~isempty(d.inputs)
    notes = {'', 'The arguments are arrays of one size, or scalars, which go with every element.'};
end
if any(~cellfun(@isempty, strfind(lines, 'rwedge:absent')))
    notes{end + 1} = 'Where rwedge:absent is said above, the results are NaN, and no error.';
end
text = ['function ' call char(10) ...
    '%' upper(name) '  ' call char(10) commented([lines, notes], '') ...
    enough_text(numel(d.inputs), call, '') ...
    call_text(d.outputs, 'rwedge_mex', [{['''' d.name '''']}, d.inputs]) ';' char(10) 'end' char(10)];
end

% What refuses a call with fewer arguments: it would end in words about the function's own lines.
function text = enough_text(count, call, margin)
text = '';
if count > 0
    text = [margin 'if nargin < ' num2str(count) char(10) ...
        margin '    error(''rwedge:arguments'', ''too few arguments: ' call ''');' char(10) margin 'end' char(10)];
end
end

function text = method_text(d, family, common)
method = d.name(numel(family) + 2:end);
arguments = [{family}, d.inputs];
call = call_text(d.outputs, [family '.' method], d.inputs);
text = [char(10) '        function ' call_text(d.outputs, method, arguments) char(10) ...
    '        %' upper(method) '  ' call char(10) ...
    commented(help_lines(d, common), '        ') ...
    enough_text(numel(arguments) * ~isempty(d.inputs), call, '            ') ...
    '            ' call_text(d.outputs, 'rwedge_mex', [{['''' d.name ''''], [family '.number']}, d.inputs]) ';' char(10) ...
    '        end' char(10)];
end

% Puts the help text of a function where its name is marked in a template.
function text = insert_help(text, d, common)
margin = regexp(text, ['(?<=\n)( *)%@' d.name '\n'], 'tokens', 'once');
if ~isempty(margin)
    text = strrep(text, [margin{1} '%@' d.name char(10)], commented(help_lines(d, common), margin{1}));
end
end

function write_text(file, text)
out = fopen(file, 'w');
if out < 0
    error('rwedge:build', 'cannot write %s', file);
end
% the licence last: the first comment is the help text
fwrite(out, [text char(10) '% SPDX-License-Identifier: GPL-3.0-or-later' char(10)]);
fclose(out);
end
