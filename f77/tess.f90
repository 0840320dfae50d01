! tess.f90 - interfaces of the entries of tess.f and hhpred.f, for callers in
! Fortran 90 and later: the compiler then finds arguments of wrong type, kind,
! rank or number, and REAL arrays above all.  Optional: tess.f and hhpred.f need
! it not.  What the arguments mean: README.
!
! SPDX-License-Identifier: 0BSD
! Copyright (c) 2026 the tess authors
!
! Permission to use, copy, modify, and/or distribute this software for any
! purpose with or without fee is hereby granted.
!
! THE SOFTWARE IS PROVIDED "AS IS" AND THE AUTHOR DISCLAIMS ALL WARRANTIES WITH
! REGARD TO THIS SOFTWARE INCLUDING ALL IMPLIED WARRANTIES OF MERCHANTABILITY
! AND FITNESS. IN NO EVENT SHALL THE AUTHOR BE LIABLE FOR ANY SPECIAL, DIRECT,
! INDIRECT, OR CONSEQUENTIAL DAMAGES OR ANY DAMAGES WHATSOEVER RESULTING FROM
! LOSS OF USE, DATA OR PROFITS, WHETHER IN AN ACTION OF CONTRACT, NEGLIGENCE OR
! OTHER TORTIOUS ACTION, ARISING OUT OF OR IN CONNECTION WITH THE USE OR
! PERFORMANCE OF THIS SOFTWARE.
!
!     use tess_interface
module tess_interface
  implicit none
  interface

    subroutine tesswk(n, maxtet, liw, lrw, info)
      integer, intent(in) :: n, maxtet
      integer, intent(out) :: liw, lrw, info
    end subroutine tesswk

    subroutine tess(n, p, maxtet, ntet, tet, adj, liw, iw, lrw, rw, info)
      integer, intent(in) :: n, maxtet, liw, lrw
      double precision, intent(in) :: p(3, *)
      integer, intent(out) :: ntet, info
      integer, intent(inout) :: tet(4, *), adj(4, *), iw(*)
      double precision, intent(inout) :: rw(*)
    end subroutine tess

    subroutine tessre(n, p, maxtet, ntet, tet, adj, liw, iw, lrw, rw, info)
      integer, intent(in) :: n, maxtet, liw, lrw
      double precision, intent(in) :: p(3, *)
      integer, intent(out) :: info
      integer, intent(inout) :: ntet, tet(4, *), adj(4, *), iw(*)
      double precision, intent(inout) :: rw(*)
    end subroutine tessre

    subroutine tesslo(p, ntet, tet, adj, q, t, w, info)
      integer, intent(in) :: ntet, tet(4, *), adj(4, *)
      double precision, intent(in) :: p(3, *), q(3)
      integer, intent(inout) :: t
      double precision, intent(inout) :: w(4)
      integer, intent(out) :: info
    end subroutine tesslo

    subroutine tessva(p, ntet, tet, adj, nv, value, nq, q, t, out, info)
      integer, intent(in) :: ntet, tet(4, *), adj(4, *), nv, nq
      double precision, intent(in) :: p(3, *), value(nv, *), q(3, *)
      integer, intent(inout) :: t(*)
      double precision, intent(inout) :: out(nv, *)
      integer, intent(out) :: info
    end subroutine tessva

    subroutine tesshu(ntet, tet, adj, maxfac, nfac, fac, info)
      integer, intent(in) :: ntet, tet(4, *), adj(4, *), maxfac
      integer, intent(out) :: nfac, info
      integer, intent(inout) :: fac(3, *)
    end subroutine tesshu

    subroutine tessch(n, p, ntet, tet, adj, liw, iw, bad, info)
      integer, intent(in) :: n, ntet, tet(4, *), adj(4, *), liw
      double precision, intent(in) :: p(3, *)
      integer, intent(inout) :: iw(*)
      integer, intent(out) :: bad, info
    end subroutine tessch

    subroutine tessix(n, p, liw, iw, lrw, rw, info)
      integer, intent(in) :: n, liw, lrw
      double precision, intent(in) :: p(3, *)
      integer, intent(inout) :: iw(*)
      double precision, intent(inout) :: rw(*)
      integer, intent(out) :: info
    end subroutine tessix

    subroutine tessqu(n, p, iw, rw, q, v, w, info)
      integer, intent(in) :: n, iw(*)
      double precision, intent(in) :: p(3, *), rw(*), q(3)
      integer, intent(inout) :: v(4)
      double precision, intent(inout) :: w(4)
      integer, intent(out) :: info
    end subroutine tessqu

    subroutine tesspa(n, p, mine, maxtet, ntet, tet, adj, liw, iw, lrw, rw, &
      info)
      integer, intent(in) :: n, mine(*), maxtet, liw, lrw
      double precision, intent(in) :: p(3, *), rw(*)
      integer, intent(inout) :: ntet, tet(4, *), adj(4, *), iw(*)
      integer, intent(out) :: info
    end subroutine tesspa

    subroutine tessba(p, v, c, info)
      double precision, intent(in) :: p(3, *)
      integer, intent(in) :: v(4)
      double precision, intent(inout) :: c(4)
      integer, intent(out) :: info
    end subroutine tessba

    integer function tessed()
    end function tessed

    subroutine hhface(p1, p2, p3, f, info)
      double precision, intent(in) :: p1(3), p2(3), p3(3)
      double precision, intent(out) :: f(12)
      integer, intent(out) :: info
    end subroutine hhface

    double precision function hhside(f, z)
      double precision, intent(in) :: f(12), z(3)
    end function hhside

    integer function hhopp(f, z1, z2)
      double precision, intent(in) :: f(12), z1(3), z2(3)
    end function hhopp

    double precision function hhlcoo(f, z)
      double precision, intent(in) :: f(12), z(3)
    end function hhlcoo

    subroutine hhwrap(p1, p2, p3, z, c, info)
      double precision, intent(in) :: p1(3), p2(3), p3(3), z(3)
      double precision, intent(out) :: c
      integer, intent(out) :: info
    end subroutine hhwrap

    integer function hhorie(a, b, c, d)
      double precision, intent(in) :: a(3), b(3), c(3), d(3)
    end function hhorie

    integer function hhinsp(a, b, c, d, e)
      double precision, intent(in) :: a(3), b(3), c(3), d(3), e(3)
    end function hhinsp

  end interface
end module tess_interface
