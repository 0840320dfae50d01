! calls_c.f90 - a Fortran 2003 program that calls the C version.
!
!   cc -O2 -c tess.c hhpred.c
!   gfortran -O2 -o fortran test/bindings/fortran/tess_c.f90 \
!       test/samples/calls_c.f90 tess.o hhpred.o -lm
!
! Points and tetrahedra count from 0, as in C, and none is -1: here TET has 1
! added before it is used for a subscript.  For the reverse see calls_fortran.c.
program fortran
  use tess_c
  implicit none

  integer(tess_int), parameter :: n = 9, maxtet = 8*n
  integer(tess_int), parameter :: liw = 19*n + 1800, lrw = 4*n + 12
  real(tess_real) :: p(3, n), rw(lrw), w(4), q(3) = (/0.25d0, 0.5d0, 0.625d0/)
  integer(tess_int) :: tet(4, maxtet), adj(4, maxtet), iw(liw), ntet, t, v(4), i

  do i = 1, 8
    p(:, i) = (/mod(i - 1, 2), mod((i - 1)/2, 2), (i - 1)/4/)
  end do
  p(:, 9) = 0.5d0
  if (tess(n, p, maxtet, ntet, tet, adj, liw, iw, lrw, rw) /= 0) stop 1
  t = tess_none
  if (tess_locate(p, ntet, tet, adj, q, t, w) /= 0) stop 1
  v = tet(:, t + 1) + 1
  print '(i0, " tetrahedra, value ", f8.6)', ntet, &
    sum(w*(1 + p(1, v) + 2*p(2, v) + 3*p(3, v)))
end program fortran
