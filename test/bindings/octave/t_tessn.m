% t_tessn.m - tests of tessn.m and tessinterp.m, beside Octave's own
% functions; what they give is left in build/tessn.mat, for test_tess89.py.
%
%   make octave
%   octave-cli --norc --no-history test/bindings/octave/t_tessn.m
%
% Prints TAP.
1;
addpath build

function test(name, good)
    global counts
    words = {'not ok', 'ok'};
    counts(2 - good) += 1;
    printf('%s %d - %s\n', words{1 + good}, sum(counts), name);
end

% refuses - that the call fails with these words
function refuses(words, call, varargin)
    said = '';
    try
        call(varargin{:});
    catch failure
        said = failure.message;
    end
    test(['refuses: ' words], ~isempty(strfind(said, words)));
end

% same - within most of each other, NaN at the same places
function yes = same(a, b, most)
    yes = isequal(size(a), size(b)) && isequal(isnan(a), isnan(b)) && ...
        all(abs(a(:) - b(:)) <= most | isnan(a(:)));
end

function T = rows_of(T)
    T = sortrows(sort(T, 2));
end

global counts
counts = [0 0];
rand('twister', 3);
p = rand(300, 3);
q = 1.4 * rand(500, 3) - 0.2;
q(1:20, :) = 0.35 + 0.3 * rand(20, 3);
v = [sin(9 * p(:, 1)), p(:, 2) .* p(:, 3)];

T = tessn(p);
test('tessn: delaunayn''s tetrahedra', ...
     isequal(rows_of(T), rows_of(delaunayn(p))));
positive = true;
for i = 1:rows(T)
    positive = positive && det(p(T(i, 2:4), :) - p(T(i, [1 1 1]), :)) > 0;
end
test('tessn: positively oriented', positive);
[T, N] = tessn(p);
beside = true;
for i = 1:rows(T)
    for k = 1:4
        face = sort(T(i, [1:k-1, k+1:4]));
        % all that have these three points: it, and the neighbour or none
        have = find(sum(ismember(T, face), 2) == 3)';
        beside = beside && isequal(sort([i, N(i, k)(N(i, k) > 0)]), have);
    end
end
test('tessn: neighbours opposite to each point', ...
     isequal(size(N), size(T)) && beside);
[x, y, z] = ndgrid(0:4);
grid = [x(:), y(:), z(:)];
T4 = tessn(int8(grid));
volume = 0;
for i = 1:rows(T4)
    volume += det(grid(T4(i, 2:4), :) - grid(T4(i, [1 1 1]), :)) / 6;
end
test('tessn: integers, a grid', abs(volume - 64) < 1e-12);
test('tessn: points twice', isequal(rows_of(tessn([p; p])), rows_of(T)));
% more tetrahedra than 8 a point
s = linspace(0, 1, 200)';
o = 0 * s;
test('tessn: two lines', rows(tessn([s o o; o s o+1])) == 199 * 199);

linear = tessinterp(p, v, q);
want = [griddatan(p, v(:, 1), q), griddatan(p, v(:, 2), q)];
test('tessinterp: griddatan''s values, linear', same(linear, want, 1e-12));
nearest = tessinterp(p, v, q, 'nearest');
outside = isnan(want(:, 1));
want = [griddatan(p, v(:, 1), q, 'nearest'), ...
        griddatan(p, v(:, 2), q, 'nearest')];
want(outside, :) = NaN;
test('tessinterp: griddatan''s values, nearest', same(nearest, want, 0));
test('tessinterp: one value a point, in a row', ...
     same(tessinterp(p, v(:, 1)', q), linear(:, 1), 0));
smooth = tessinterp(p, v, q, 'smooth');
natural = tessinterp(p, v, q, 'Natural');
for method = {'linear', 'smooth', 'natural', 'nearest'}
    f = tessinterp(p, v, [q(1:3, :); NaN 0 0; 0 -Inf 0], method{1});
    test(['tessinterp: NaN where Q is not finite, ' method{1}], ...
         isequal(any(isnan(f), 2), [false; false; false; true; true]));
end
for method = {'linear', 'smooth', 'natural'}
    f = tessinterp(p, p * [1; 2; 3], q(1:9, :), method{1});
    test(['tessinterp: a linear field, ' method{1}], ...
         same(f, q(1:9, :) * [1; 2; 3], 1e-12));
end
% hundreds of neighbours
ball = rand(400, 3) - 0.5;
ball = ball ./ sqrt(sum(ball.^2, 2));
ball = [ball; 1.01 * ball(1:9, :)];
test('tessinterp: hundreds of neighbours', same( ...
     tessinterp(ball, ball * [1; 2; 3], q(1:9, :) - 0.5, 'natural'), ...
     (q(1:9, :) - 0.5) * [1; 2; 3], 1e-12));
test('tessinterp: no places', ...
     isequal(size(tessinterp(p, v, zeros(0, 3))), [0 2]));

% missing values, points that coincide
w = [v, v(:, 1), v(:, 2)];
w(11:50, 1) = NaN;
w(1:2:99, 4) = NaN;
for method = {'linear', 'smooth', 'natural', 'nearest'}
    want = zeros(500, 0);
    for k = 1:4
        there = ~isnan(w(:, k));
        want(:, k) = tessinterp(p(there, :), w(there, k), q, method{1});
    end
    lastwarn('');
    f = tessinterp(p, w, q, method{1});
    test(['tessinterp: missing values, ' method{1}], same(f, want, 1e-12) && ...
         sum(isfinite(f(:, 4))) > 99 && ...
         ~isempty(strfind(lastwarn, 'column 1: 40, column 4: 50')));
    twice = [p; p(1:99, :); p(1:9, :)];
    u = rand(408, 2);
    mean_of = u(1:300, :);
    mean_of(1:99, :) = (u(1:99, :) + u(301:399, :)) / 2;
    mean_of(1:9, :) = (u(1:9, :) + u(301:309, :) + u(400:408, :)) / 3;
    test(['tessinterp: the mean where points coincide, ' method{1}], ...
         same(tessinterp(twice, u, q, method{1}), ...
              tessinterp(p, mean_of, q, method{1}), 1e-11));
end
lastwarn('');
tessinterp(p, v, q);
test('tessinterp: no warning where no value is missing', isempty(lastwarn));

bad = p;
bad([123 234], 2) = NaN;
refuses('P must be n by 3', @tessn, p(:, 1:2));
refuses('P must be n by 3', @tessn, p + 1i);
refuses('P must be n by 3', @tessn, 'abc');
refuses('point 123 is not finite', @tessn, bad);
refuses('in one plane', @tessn, p .* [1 1 0]);
refuses('on one line', @tessn, p .* [1 0 0]);
refuses('at most one distinct point', @tessn, zeros(0, 3));
refuses('P must be n by 3', @tessinterp, p', v, q);
refuses('point 123 is not finite', @tessinterp, bad, v + bad(:, 2), q);
warning('off', 'tessinterp:missing');
refuses('at most one distinct point', @tessinterp, p, v * NaN, q);
refuses('in one plane', @tessinterp, [p; p .* [1 1 0]], ...
        [v * NaN; v], q);
warning('on', 'tessinterp:missing');
refuses('a value is infinite', @tessinterp, p, [Inf; v(2:end, 1)], q, 'smooth');
refuses('V must have a real value', @tessinterp, p, v(2:end, :), q);
refuses('V must have a real value', @tessinterp, p, v + 1i, q);
refuses('Q must be nq by 3', @tessinterp, p, v, q(:, 1:2));
refuses('linear, smooth, natural or nearest', @tessinterp, p, v, q, 'cubic');
refuses('linear, smooth, natural or nearest', @tessinterp, p, v, q, 3);
refuses('it takes P, V, Q', @tessinterp, p, v);
refuses('real doubles with 3 rows', @tess_mex, p);
refuses('real doubles with 3 rows', @tess_mex, single(p'));
refuses('real doubles with 300 rows', @tess_mex, p', v', q', 0);
refuses('see tessn', @tess_mex);

save('-v6', 'build/tessn.mat', 'p', 'v', 'q', 'T', 'N', 'linear', 'smooth', ...
     'natural', 'nearest');
printf('1..%d\n', sum(counts));
exit(counts(2) > 0);
