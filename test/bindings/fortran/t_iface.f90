! t_iface.f90 - calls every entry by f77/tess.f90's interfaces; the corners of
! two unit cubes, one on the other, and duplicates.  With -DWRONG=k a call is
! wrong, and must not compile.
program iface
  use tess_interface
  implicit none
  integer, parameter :: n = 16, liw = 17*n + 1800, lrw = 4*n + 12
  integer, parameter :: maxtet = 8*n
  double precision :: p(3, n), rw(lrw), q(3), w(4), f(12), c, out(3, 2)
  integer :: tet(4, maxtet), adj(4, maxtet), iw(liw), fac(3, 4*maxtet)
  integer :: ntet, ntet2, info, i, k, t, nfac, bad, liw2, lrw2
  integer :: tests, failed, where(2), v(4), mine(n)
  real :: single(3, n)

  tests = 0
  failed = 0
  do i = 1, n
    p(:, i) = (/mod(i - 1, 2), mod((i - 1)/2, 2), min((i - 1)/4, 2)/)
  end do
  single = real(p)

  call tesswk(n, maxtet, liw2, lrw2, info)
  call test(info == 0 .and. liw2 <= liw .and. lrw2 <= lrw)
#if WRONG == 1
  call tess(n, single, maxtet, ntet, tet, adj, liw, iw, lrw, rw, info)
#elif WRONG == 2
  call tess(n, p, maxtet, ntet, tet, adj, liw, iw, lrw, single, info)
#elif WRONG == 3
  call tess(n, p, maxtet, ntet, tet, adj, iw, rw, info)
#elif WRONG == 4
  call tess(n, p, maxtet, ntet, tet, adj, liw, iw, lrw, rw, 0)
#elif WRONG == 5
  call tessix(n, single, liw, iw, lrw, rw, info)
#elif WRONG == 6
  call tessqu(n, p, iw, single, q, v, w, info)
#elif WRONG == 7
  call tesspa(n, p, mine, maxtet, ntet, tet, adj, liw, iw, lrw, single, info)
#elif WRONG == 8
  call tessba(single, v, w, info)
#endif
  call tess(n, p, maxtet, ntet, tet, adj, liw, iw, lrw, rw, info)
  ! 12 distinct points; a cube's 8 triangles of 5 or 6 tetrahedra
  call test(info == 0 .and. ntet >= 10 .and. ntet <= 12)
  call test(all(iw(1:12) == (/(i, i=1, 12)/)) .and. all(iw(13:16) == (/(i, i=9, 12)/)))
  ntet2 = ntet
  call tessre(n, p, maxtet, ntet, tet, adj, liw, iw, lrw, rw, info)
  call test(info == 0 .and. ntet == ntet2)
  call tessch(n, p, ntet, tet, adj, liw, iw, bad, info)
  call test(info == 0 .and. bad == 0)
  call tesshu(ntet, tet, adj, 4*maxtet, nfac, fac, info)
  call test(info == 0 .and. nfac == 20)
  q = (/0.25d0, 0.5d0, 1.125d0/)
  t = 0
  call tesslo(p, ntet, tet, adj, q, t, w, info)
  call test(info == 0)
  do k = 1, 3
    call test(abs(sum(w*p(k, tet(:, t))) - q(k)) < 1d-15)
  end do
  ! the points' coordinates for values: q, and the point nearest to one outside
  where = 0
  call tessva(p, ntet, tet, adj, 3, p, 2, &
    reshape((/q, 0.25d0, -3d0, 1.5d0/), (/3, 2/)), where, out, info)
  call test(info == 1 .and. where(1) > 0 .and. where(2) < 0)
  call test(all(abs(out(:, 1) - q) < 1d-15))
  call test(all(abs(out(:, 2) - (/0.25d0, 0d0, 1.5d0/)) < 1d-15))

  ! without the mesh: q is where it was; the part of all is the mesh; a ball
  call tessix(n, p, liw, iw, lrw, rw, info)
  call test(info == 0)
  v = 0
  call tessqu(n, p, iw, rw, q, v, w, info)
  call test(info == 0 .and. all(abs(matmul(p(:, v), w) - q) < 1d-15))
  mine = 1
  ntet = 0
  call tesspa(n, p, mine, maxtet, ntet, tet, adj, liw, iw, lrw, rw, info)
  call test(info == 0 .and. ntet == ntet2)
  call tessba(p, (/1, 2, 3, 5/), w, info)
  ! (the radius is rounded outwards)
  call test(info == 0 .and. all(abs(w(:3) - 0.5d0) < 1d-14) .and. &
    w(4) >= sqrt(0.75d0) .and. w(4) < 1d-12 + sqrt(0.75d0))

  call test(tessed() == 50000)
  call hhface(p(:, 1), p(:, 2), p(:, 3), f, info)
  call test(info == 0)
  call test(abs(hhside(f, p(:, 9)) - 2d0) < 1d-15)
  call test(hhopp(f, p(:, 5), p(:, 9)) == 1)
  ! the ball through 0, e1, e2 and 2 e3 has its centre at height 1
  call test(abs(hhlcoo(f, p(:, 9)) - 1d0) < 1d-15)
  call hhwrap(p(:, 1), p(:, 2), p(:, 3), p(:, 7), c, info)
  call test(info == 0 .and. abs(c + 1d0) < 1d-15)
  call test(hhorie(p(:, 1), p(:, 2), p(:, 3), p(:, 5)) == 1)
  call test(hhinsp(p(:, 1), p(:, 2), p(:, 3), p(:, 5), p(:, 8)) == 0)
  print '("1..", i0)', tests
  if (failed > 0) stop 1

contains

  subroutine test(ok)
    logical, intent(in) :: ok
    tests = tests + 1
    if (.not. ok) failed = failed + 1
    print '(a, i0, " - test ", i0)', trim(merge('ok    ', 'not ok', ok)) // ' ', &
      tests, tests
  end subroutine test

end program iface
