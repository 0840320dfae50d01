! t_module.f90 - calls every routine of the C files by the module of
! test/bindings/fortran/tess_c.f90; the points are those of t_iface.f90.
program module_test
  use tess_c
  implicit none
  integer, parameter :: dp = tess_real
  integer(tess_int), parameter :: n = 16, liw = 17*n + 1800, lrw = 4*n + 12
  integer(tess_int), parameter :: maxtet = 8*n
  real(dp) :: p(3, n), rw(lrw), q(3), w(4), f(hh_facet_len), c, out(3, 2)
  integer(tess_int) :: tet(4, maxtet), adj(4, maxtet), iw(liw)
  integer(tess_int) :: fac(3, 4*maxtet), ntet, ntet2, i, t, nfac, bad, liw2
  integer(tess_int) :: lrw2, where(2), v(4), mine(n)
  integer :: code, tests, failed

  tests = 0
  failed = 0
  do i = 1, n
    p(:, i) = (/mod(i - 1, 2), mod((i - 1)/2, 2), min((i - 1)/4, 2)/)
  end do
  call test(tess_edition()/10000 == 5)
  ! (a function and what it sets, in one expression: in which order is not said)
  code = tess_size(n, maxtet, liw2, lrw2)
  call test(code == 0 .and. liw2 <= liw .and. lrw2 <= lrw)
  code = tess(n, p, 3, ntet, tet, adj, liw, iw, lrw, rw)
  call test(code == tess_more .and. ntet == 3 .and. any(adj(:, :3) == tess_open))
  code = tess_resume(n, p, maxtet, ntet, tet, adj, liw, iw, lrw, rw)
  call test(code == tess_ok .and. ntet >= 10 .and. ntet <= 12)
  call test(all(iw(:12) == (/(i, i=0, 11)/)) .and. all(iw(13:16) == (/(i, i=8, 11)/)))
  code = tess_check(n, p, ntet, tet, adj, liw, iw, bad)
  call test(code == 0 .and. bad == tess_none)
  code = tess_hull(ntet, tet, adj, 4*maxtet, nfac, fac)
  call test(code == 0 .and. nfac == 20)
  q = (/0.25_dp, 0.5_dp, 1.125_dp/)
  t = tess_none
  code = tess_locate(p, ntet, tet, adj, q, t, w)
  call test(code == 0 .and. &
    all(abs(matmul(p(:, tet(:, t + 1) + 1), w) - q) < 1e-15_dp))
  where = tess_none
  code = tess_values(p, ntet, tet, adj, 3, p, 2, &
    reshape((/q, 0.25_dp, -3.0_dp, 1.5_dp/), (/3, 2/)), where, out)
  call test(code == 1 .and. where(1) >= 0 .and. where(2) < -1)
  call test(all(abs(out(:, 1) - q) < 1e-15_dp))
  call test(all(abs(out(:, 2) - (/0.25_dp, 0.0_dp, 1.5_dp/)) < 1e-15_dp))
  code = tess_index(n, p, liw, iw, lrw, rw)
  call test(code == 0)
  v = tess_none
  code = tess_query(n, p, iw, rw, q, v, w)
  call test(code == 0 .and. all(abs(matmul(p(:, v + 1), w) - q) < 1e-15_dp))
  mine = 1
  ntet2 = 0
  code = tess_part(n, p, mine, maxtet, ntet2, tet, adj, liw, iw, lrw, rw)
  call test(code == 0 .and. ntet2 == ntet)
  code = tess_ball(p, (/0, 1, 2, 4/), w)
  ! (the radius is rounded outwards)
  call test(code == 0 .and. all(abs(w(:3) - 0.5_dp) < 1e-14_dp) .and. &
    w(4) >= sqrt(0.75_dp) .and. w(4) < 1e-12_dp + sqrt(0.75_dp))
  call test(hh_facet(p(:, 1), p(:, 2), p(:, 2), f) == 1)
  call test(hh_facet(p(:, 1), p(:, 2), p(:, 3), f) == 0)
  call test(abs(hh_side(f, p(:, 9)) - 2) < 1e-15_dp)
  call test(hh_opp(f, p(:, 5), p(:, 9)) == 1)
  call test(abs(hh_lcoord(f, p(:, 9)) - 1) < 1e-15_dp)
  code = hh_wrap(p(:, 1), p(:, 2), p(:, 3), p(:, 7), c)
  call test(code == 0 .and. abs(c + 1) < 1e-15_dp)
  call test(hh_orient(p(:, 1), p(:, 2), p(:, 3), p(:, 5)) == 1)
  call test(hh_insphere(p(:, 1), p(:, 2), p(:, 3), p(:, 5), p(:, 8)) == 0)
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

end program module_test
