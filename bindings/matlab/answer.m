% SPDX-License-Identifier: GPL-3.0-or-later
% Answers what tests/answers/calls.py matlab prints, from standard input, as the program in C does: the calls are as they
% stand in the documentation.
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

before = [];
text_line = fgetl(stdin);
while ischar(text_line)
    fields = strsplit(text_line, "\t", 'CollapseDelimiters', false);
    try
        eval([fields{2} ';']);
        if ~isempty(strfind(fields{1}, '_copy:'))
            contact = copy; % what makes one begins the next
        end
        before = cellfun(@column, eval(['{' fields{3} '}']), 'UniformOutput', false);
        before = vertcat(before{:});
        answers = arrayfun(@bits, before', 'UniformOutput', false);
        answers = ['' answers{:}];
    catch
        answers = ',error';
    end
    disp([fields{1} answers]);
    text_line = fgetl(stdin);
end
