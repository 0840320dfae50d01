function T = tessn(P)
% TESSN  Delaunay tetrahedra of points in space, as delaunayn.
%
%   T = tessn(P)
%
% P  n by 3, the points: real numbers, all finite.
% T  m by 4: each row the points of a tetrahedron, numbers of rows of P, with
%    det([P(T(i,2:4),:) - P(T(i,[1 1 1]),:)]) > 0.  No tetrahedron is flat.  Of
%    points that coincide the first one is in T.
%
% `make octave' builds what it needs, into build/: addpath build.
    if nargin ~= 1 || ~isnumeric(P) || ~isreal(P) || ndims(P) ~= 2 || ...
            size(P, 2) ~= 3
        error('tessn: P must be n by 3: three real coordinates a point');
    end
    T = tess_mex(full(double(P)).').';
end
