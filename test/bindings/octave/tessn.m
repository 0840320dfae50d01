function [T, N] = tessn(P)
% TESSN  Delaunay tetrahedra of points in space, as delaunayn.
%
%   T = tessn(P)
%   [T, N] = tessn(P)
%
% P  n by 3, the points: real numbers, all finite.
% T  m by 4: each row the points of a tetrahedron, numbers of rows of P, with
%    det([P(T(i,2:4),:) - P(T(i,[1 1 1]),:)]) > 0.  No tetrahedron is flat.  Of
%    points that coincide the first one is in T.
% N  m by 4: the neighbours, numbers of rows of T: N(i,k) has the three points
%    of T(i,:) but T(i,k).  0 on the convex hull.
%
% `make octave' builds what it needs, into build/: addpath build.
    if nargin ~= 1 || ~isnumeric(P) || ~isreal(P) || ndims(P) ~= 2 || ...
            size(P, 2) ~= 3
        error('tessn: P must be n by 3: three real coordinates a point');
    end
    if nargout < 2
        T = tess_mex(full(double(P)).').';
    else
        [T, N] = tess_mex(full(double(P)).');
        T = T.';
        N = N.';
    end
end
