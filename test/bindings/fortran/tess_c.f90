! tess_c.f90 - the C files for Fortran 2003 and later: interfaces of all
! routines of tess.h and hhpred.h.
!
!     cc -O3 -c tess.c hhpred.c
!     gfortran -O3 -o mine test/bindings/fortran/tess_c.f90 mine.f90 tess.o \
!         hhpred.o -lm
!
! What the arguments mean: tess.h.  Points and tetrahedra count from 0, as in C,
! and none is -1.  For other types alter tess_int and tess_real, and the names of
! bind, which are those of hhpred.h: name="tess__float".  The files in FORTRAN 77
! need no C, and count from 1: f77/tess.f90 has their interfaces.
!
! SPDX-License-Identifier: 0BSD
module tess_c
  use iso_c_binding, only: c_int, c_long, c_double
  implicit none
  private :: c_int, c_long, c_double

  integer, parameter :: tess_int = c_int, tess_real = c_double
  integer(tess_int), parameter :: tess_none = -1, tess_open = -2
  integer, parameter :: tess_ok = 0, tess_more = 1, tess_pool = 2
  integer, parameter :: tess_plane = 3, tess_line = 4, tess_point = 5
  integer, parameter :: tess_range = 6, hh_facet_len = 12

  interface

    integer(c_int) function tess_size(n, maxtet, liw, lrw) bind(c)
      import c_int, tess_int
      integer(tess_int), value :: n, maxtet
      integer(tess_int), intent(out) :: liw, lrw
    end function tess_size

    integer(c_int) function tess(n, p, maxtet, ntet, tet, adj, liw, iw, lrw, &
      rw) bind(c)
      import c_int, c_double, tess_int, tess_real
      integer(tess_int), value :: n, maxtet, liw, lrw
      real(tess_real), intent(in) :: p(3, *)
      integer(tess_int), intent(out) :: ntet
      integer(tess_int), intent(inout) :: tet(4, *), adj(4, *), iw(*)
      real(c_double), intent(inout) :: rw(*)
    end function tess

    integer(c_int) function tess_resume(n, p, maxtet, ntet, tet, adj, liw, iw, &
      lrw, rw) bind(c)
      import c_int, c_double, tess_int, tess_real
      integer(tess_int), value :: n, maxtet, liw, lrw
      real(tess_real), intent(in) :: p(3, *)
      integer(tess_int), intent(inout) :: ntet, tet(4, *), adj(4, *), iw(*)
      real(c_double), intent(inout) :: rw(*)
    end function tess_resume

    integer(c_int) function tess_locate(p, ntet, tet, adj, q, t, w) bind(c)
      import c_int, c_double, tess_int, tess_real
      integer(tess_int), value :: ntet
      integer(tess_int), intent(in) :: tet(4, *), adj(4, *)
      real(tess_real), intent(in) :: p(3, *), q(3)
      integer(tess_int), intent(inout) :: t
      real(c_double), intent(inout) :: w(4)
    end function tess_locate

    integer(c_int) function tess_values(p, ntet, tet, adj, nv, value, nq, q, &
      t, out) bind(c)
      import c_int, c_double, tess_int, tess_real
      integer(tess_int), value :: ntet, nv, nq
      integer(tess_int), intent(in) :: tet(4, *), adj(4, *)
      real(tess_real), intent(in) :: p(3, *), q(3, *)
      real(c_double), intent(in) :: value(nv, *)
      integer(tess_int), intent(inout) :: t(*)
      real(c_double), intent(inout) :: out(nv, *)
    end function tess_values

    integer(c_int) function tess_index(n, p, liw, iw, lrw, rw) bind(c)
      import c_int, c_double, tess_int, tess_real
      integer(tess_int), value :: n, liw, lrw
      real(tess_real), intent(in) :: p(3, *)
      integer(tess_int), intent(inout) :: iw(*)
      real(c_double), intent(inout) :: rw(*)
    end function tess_index

    integer(c_int) function tess_query(n, p, iw, rw, q, v, w) bind(c)
      import c_int, c_double, tess_int, tess_real
      integer(tess_int), value :: n
      real(tess_real), intent(in) :: p(3, *), q(3)
      integer(tess_int), intent(in) :: iw(*)
      real(c_double), intent(in) :: rw(*)
      integer(tess_int), intent(inout) :: v(4)
      real(c_double), intent(inout) :: w(4)
    end function tess_query

    integer(c_int) function tess_part(n, p, mine, maxtet, ntet, tet, adj, liw, &
      iw, lrw, rw) bind(c)
      import c_int, c_double, tess_int, tess_real
      integer(tess_int), value :: n, maxtet, liw, lrw
      real(tess_real), intent(in) :: p(3, *)
      integer(tess_int), intent(in) :: mine(*)
      integer(tess_int), intent(inout) :: ntet, tet(4, *), adj(4, *), iw(*)
      real(c_double), intent(in) :: rw(*)
    end function tess_part

    integer(c_int) function tess_ball(p, v, c) bind(c)
      import c_int, c_double, tess_int, tess_real
      real(tess_real), intent(in) :: p(3, *)
      integer(tess_int), intent(in) :: v(4)
      real(c_double), intent(inout) :: c(4)
    end function tess_ball

    integer(c_int) function tess_hull(ntet, tet, adj, maxfac, nfac, fac) bind(c)
      import c_int, tess_int
      integer(tess_int), value :: ntet, maxfac
      integer(tess_int), intent(in) :: tet(4, *), adj(4, *)
      integer(tess_int), intent(out) :: nfac
      integer(tess_int), intent(inout) :: fac(3, *)
    end function tess_hull

    integer(c_int) function tess_check(n, p, ntet, tet, adj, liw, iw, bad) &
      bind(c)
      import c_int, tess_int, tess_real
      integer(tess_int), value :: n, ntet, liw
      real(tess_real), intent(in) :: p(3, *)
      integer(tess_int), intent(in) :: tet(4, *), adj(4, *)
      integer(tess_int), intent(inout) :: iw(*)
      integer(tess_int), intent(out) :: bad
    end function tess_check

    integer(c_long) function tess_edition() bind(c)
      import c_long
    end function tess_edition

    integer(c_int) function hh_facet(p1, p2, p3, f) bind(c)
      import c_int, c_double, tess_real
      real(tess_real), intent(in) :: p1(3), p2(3), p3(3)
      real(c_double), intent(out) :: f(12)
    end function hh_facet

    real(c_double) function hh_side(f, z) bind(c)
      import c_double, tess_real
      real(c_double), intent(in) :: f(12)
      real(tess_real), intent(in) :: z(3)
    end function hh_side

    integer(c_int) function hh_opp(f, z1, z2) bind(c)
      import c_int, c_double, tess_real
      real(c_double), intent(in) :: f(12)
      real(tess_real), intent(in) :: z1(3), z2(3)
    end function hh_opp

    real(c_double) function hh_lcoord(f, z) bind(c)
      import c_double, tess_real
      real(c_double), intent(in) :: f(12)
      real(tess_real), intent(in) :: z(3)
    end function hh_lcoord

    integer(c_int) function hh_wrap(p1, p2, p3, z, c) bind(c)
      import c_int, c_double, tess_real
      real(tess_real), intent(in) :: p1(3), p2(3), p3(3), z(3)
      real(c_double), intent(out) :: c
    end function hh_wrap

    integer(c_int) function hh_orient(a, b, c, d) bind(c)
      import c_int, tess_real
      real(tess_real), intent(in) :: a(3), b(3), c(3), d(3)
    end function hh_orient

    integer(c_int) function hh_insphere(a, b, c, d, e) bind(c)
      import c_int, tess_real
      real(tess_real), intent(in) :: a(3), b(3), c(3), d(3), e(3)
    end function hh_insphere

  end interface
end module tess_c
