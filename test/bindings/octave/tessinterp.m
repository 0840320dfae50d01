function F = tessinterp(P, V, Q, METHOD)
% TESSINTERP  Interpolation of scattered data in space, as griddatan.
%
%   F = tessinterp(P, V, Q, METHOD)
%
% P       n by 3, the points: real numbers, all finite
% V       their values: n of them, or n by k.  One that is NaN leaves its point
%         out of its column, and a warning, tessinterp:missing, counts them
% Q       nq by 3, the places
% METHOD  'linear'   in each Delaunay tetrahedron: the default
%         'smooth'   by gradients at the points: the most accurate one where the
%                    field is smooth; it may leave the data's range
%         'natural'  by Sibson's natural neighbours
%         'nearest'  of the nearest point
% F       nq by 1, or nq by k: the values at Q; NaN outside the points' convex
%         hull, and where Q is not finite
%
% Of points that coincide the mean of the values counts.
% `make octave' builds what it needs, into build/: addpath build.
    if nargin < 3
        error('tessinterp: it takes P, V, Q and perhaps METHOD');
    end
    if nargin < 4
        METHOD = 'linear';
    end
    if ~isnumeric(P) || ~isreal(P) || ndims(P) ~= 2 || size(P, 2) ~= 3
        error('tessinterp: P must be n by 3: three real coordinates a point');
    end
    if ~isnumeric(Q) || ~isreal(Q) || ndims(Q) ~= 2 || size(Q, 2) ~= 3
        error('tessinterp: Q must be nq by 3: three real coordinates a place');
    end
    if isvector(V)
        V = V(:);
    end
    if ~isnumeric(V) || ~isreal(V) || ndims(V) ~= 2 || ...
            size(V, 1) ~= size(P, 1) || isempty(V)
        error('tessinterp: V must have a real value, or a row, for each point');
    end
    if ~ischar(METHOD)
        METHOD = '';
    end
    number = find(strcmpi(METHOD, {'linear', 'smooth', 'natural', 'nearest'}));
    if isempty(number)
        error('tessinterp: METHOD must be linear, smooth, natural or nearest');
    end
    P = full(double(P)).';
    V = full(double(V));
    bad = find(~all(isfinite(P), 1), 1);
    if ~isempty(bad)
        error('tessinterp: point %d is not finite', bad);
    end
    absent = isnan(V);
    if any(absent(:))
        counts = sum(absent, 1);
        some = find(counts);
        if numel(some) > 9
            some = some(1:9);
        end
        words = sprintf(', column %d: %d', [some; counts(some)]);
        warning('tessinterp:missing', ['tessinterp: of %d values some are ' ...
                'NaN in %d columns, and their points are left out (%s)'], ...
                size(V, 1), sum(counts > 0), words(3:end));
    end
    found = all(isfinite(Q), 2);
    F = NaN(size(Q, 1), size(V, 2));
    % columns that lack the same values have one mesh
    [~, ~, alike] = unique(absent.', 'rows');
    for k = 1:max(alike)
        columns = find(alike(:) == k);
        there = ~absent(:, columns(1));
        F(found, columns) = tess_mex(P(:, there), V(there, columns), ...
                                     full(double(Q(found, :))).', number - 1);
    end
end
