! Any system of the class with clearances, its corners rounded over a width s, for AUTO-07p.
!
!   z' = M z + b0 + w^2 b2 + sum_j g_j Phi_j          (sums of cos k theta, sin k theta; w = PAR(1))
!   Phi = eta+ r(X - D+) - eta- r(-X - D-) + zeta X' (1, or c((X - D+)/s) + c((-X - D-)/s))
!   r(y) = s log(1 + exp(y/s)),  c = r' = 1/(1 + exp(-y/s)),  X = h.z
!
! All numbers are read from system.dat, which `problem.py` writes. PAR(2) is added to every D+ and D-, each times a
! number of its own. s is PAR(3). cos theta and sin theta are the last two unknowns, of an oscillator whose limit cycle
! is the unit circle. PAR(21), PAR(22): least X - D+ and largest X - D+ of the first clearance over a period.

MODULE smoothed
  IMPLICIT NONE
  INTEGER, PARAMETER :: DP = KIND(1.0D0)
  LOGICAL :: ready = .FALSE.
  INTEGER :: n, orders, gaps
  REAL(DP), ALLOCATABLE :: matrix(:,:), fixed(:,:), squared(:,:)      ! (n, n), (n, 0:2*orders)
  REAL(DP), ALLOCATABLE :: h(:,:), g(:,:), plus(:,:), minus(:,:)      ! (n or 0:2*orders, gaps)
  REAL(DP), ALLOCATABLE :: edge(:,:), zeta(:)                         ! (2, gaps): D+ and D- at PAR(2) = 0
  REAL(DP), ALLOCATABLE :: moved(:,:)                                 ! by how much PAR(2) moves them
  INTEGER, ALLOCATABLE :: always(:)                                   ! damping in the gap, too?
  REAL(DP) :: first(3)                                                ! w, PAR(2), s
CONTAINS

  SUBROUTINE read_numbers
    INTEGER :: unit, j
    OPEN(NEWUNIT=unit, FILE='system.dat', STATUS='OLD')
    READ(unit,*) n, orders, gaps
    READ(unit,*) first
    ALLOCATE(matrix(n,n), fixed(n,0:2*orders), squared(n,0:2*orders), h(n,gaps), g(n,gaps))
    ALLOCATE(plus(0:2*orders,gaps), minus(0:2*orders,gaps), edge(2,gaps), zeta(gaps), moved(2,gaps), always(gaps))
    DO j = 1, n
      READ(unit,*) matrix(j,:)
    END DO
    DO j = 1, n
      READ(unit,*) fixed(j,:)
    END DO
    DO j = 1, n
      READ(unit,*) squared(j,:)
    END DO
    DO j = 1, gaps
      READ(unit,*) h(:,j)
      READ(unit,*) g(:,j)
      READ(unit,*) plus(:,j)
      READ(unit,*) minus(:,j)
      READ(unit,*) edge(:,j)
      READ(unit,*) moved(:,j)
      READ(unit,*) zeta(j), always(j)
    END DO
    CLOSE(unit)
    ready = .TRUE.
  END SUBROUTINE read_numbers

  ! Value of a series at the phase a + i b = exp(i theta), and its derivatives by a and b.
  SUBROUTINE series(c, a, b, value)
    REAL(DP), INTENT(IN) :: c(0:), a, b
    REAL(DP), INTENT(OUT) :: value(3)
    COMPLEX(DP) :: turn, power, weight
    INTEGER :: k
    turn = CMPLX(a, b, DP)
    power = (1.0_DP, 0.0_DP)
    value = (/ c(0), 0.0_DP, 0.0_DP /)
    DO k = 1, UBOUND(c,1)/2
      weight = CMPLX(c(2*k-1), -c(2*k), DP)
      value(2) = value(2) + REAL(k*weight*power, DP)
      value(3) = value(3) + REAL((0.0_DP,1.0_DP)*k*weight*power, DP)
      power = power*turn
      value(1) = value(1) + REAL(weight*power, DP)
    END DO
  END SUBROUTINE series

  ! r, r' and r'' of a rounded corner.
  SUBROUTINE corner(y, s, r)
    REAL(DP), INTENT(IN) :: y, s
    REAL(DP), INTENT(OUT) :: r(3)
    REAL(DP) :: e
    e = EXP(-ABS(y)/s)
    r(1) = MAX(y, 0.0_DP) + s*LOG(1.0_DP + e)
    r(2) = 1.0_DP/(1.0_DP + e)
    IF (y < 0.0_DP) r(2) = e/(1.0_DP + e)
    r(3) = e/(s*(1.0_DP + e)**2)
  END SUBROUTINE corner

  ! Rates without contact, with derivatives by z, a and b.
  SUBROUTINE plain(u, w, f, d)
    REAL(DP), INTENT(IN) :: u(*), w
    REAL(DP), INTENT(OUT) :: f(n), d(n,n+2)
    REAL(DP) :: v(3)
    INTEGER :: i
    d = 0.0_DP
    d(:,1:n) = matrix
    f = MATMUL(matrix, u(1:n))
    DO i = 1, n
      CALL series(fixed(i,:) + w*w*squared(i,:), u(n+1), u(n+2), v)
      f(i) = f(i) + v(1)
      d(i,n+1:n+2) = v(2:3)
    END DO
  END SUBROUTINE plain
END MODULE smoothed

SUBROUTINE FUNC(NDIM,U,ICP,PAR,IJAC,F,DFDU,DFDP)
  USE smoothed
  IMPLICIT NONE
  INTEGER, INTENT(IN) :: NDIM, ICP(*), IJAC
  REAL(DP), INTENT(IN) :: U(NDIM), PAR(*)
  REAL(DP), INTENT(OUT) :: F(NDIM)
  REAL(DP), INTENT(INOUT) :: DFDU(NDIM,NDIM), DFDP(NDIM,*)
  REAL(DP), ALLOCATABLE :: rates(:), slopes(:,:), free(:,:), speed(:), force(:)
  REAL(DP) :: x, v, w, s, a, b, radius, rp(3), rm(3), ep(3), em(3), damp, bend
  INTEGER :: i, j
  IF (.NOT. ready) CALL read_numbers
  ALLOCATE(rates(n), slopes(n,n+2), free(n,n+2), speed(n+2), force(n+2))
  w = PAR(1)
  s = PAR(3)
  a = U(n+1)
  b = U(n+2)
  CALL plain(U, w, rates, slopes)
  F(1:n) = rates
  free = slopes
  DO j = 1, gaps
    x = DOT_PRODUCT(h(:,j), U(1:n))
    v = DOT_PRODUCT(h(:,j), rates)
    speed = MATMUL(h(:,j), free)
    CALL corner(x - edge(1,j) - moved(1,j)*PAR(2), s, rp)
    CALL corner(-x - edge(2,j) - moved(2,j)*PAR(2), s, rm)
    CALL series(plus(:,j), a, b, ep)
    CALL series(minus(:,j), a, b, em)
    damp = zeta(j)
    bend = 0.0_DP
    IF (always(j) == 0) THEN
      IF (ANY(minus(:,j) /= 0.0_DP)) THEN
        damp = zeta(j)*(rp(2) + rm(2))
        bend = zeta(j)*(rp(3) - rm(3))*v
      ELSE
        damp = zeta(j)*rp(2)
        bend = zeta(j)*rp(3)*v
      END IF
    END IF
    F(1:n) = F(1:n) + g(:,j)*(ep(1)*rp(1) - em(1)*rm(1) + damp*v)
    force = damp*speed
    force(1:n) = force(1:n) + (ep(1)*rp(2) + em(1)*rm(2) + bend)*h(:,j)
    force(n+1:n+2) = force(n+1:n+2) + ep(2:3)*rp(1) - em(2:3)*rm(1)
    DO i = 1, n
      slopes(i,:) = slopes(i,:) + g(i,j)*force
    END DO
  END DO
  radius = a*a + b*b
  F(n+1) = a*(1.0_DP - radius) - w*b
  F(n+2) = b*(1.0_DP - radius) + w*a
  IF (IJAC == 0) RETURN
  DFDU(1:n,:) = slopes
  DFDU(n+1:n+2,1:n) = 0.0_DP
  DFDU(n+1,n+1) = 1.0_DP - radius - 2.0_DP*a*a
  DFDU(n+1,n+2) = -2.0_DP*a*b - w
  DFDU(n+2,n+1) = -2.0_DP*a*b + w
  DFDU(n+2,n+2) = 1.0_DP - radius - 2.0_DP*b*b
END SUBROUTINE FUNC

SUBROUTINE STPNT(NDIM,U,PAR,T)
  USE smoothed
  IMPLICIT NONE
  INTEGER, INTENT(IN) :: NDIM
  REAL(DP), INTENT(INOUT) :: U(NDIM), PAR(*)
  REAL(DP), INTENT(IN) :: T
  IF (.NOT. ready) CALL read_numbers
  PAR(1:3) = first
END SUBROUTINE STPNT

! Least and largest X - D+ of a period, by the cubics through values and velocities at neighbouring points.
SUBROUTINE PVLS(NDIM,U,PAR)
  USE smoothed
  IMPLICIT NONE
  INTEGER, INTENT(IN) :: NDIM
  REAL(DP), INTENT(IN) :: U(*)
  REAL(DP), INTENT(INOUT) :: PAR(*)
  REAL(DP), EXTERNAL :: GETP
  REAL(DP), ALLOCATABLE :: rates(:), slopes(:,:)
  REAL(DP) :: x(0:1), v(0:1), span, least, largest, q
  INTEGER :: mesh, inner, width, i, k, at
  IF (.NOT. ready) CALL read_numbers
  ALLOCATE(rates(n), slopes(n,n+2))
  width = NINT(GETP('NDX',0,U))
  mesh = NINT(GETP('NTST',0,U))
  inner = NINT(GETP('NCOL',0,U))
  least = HUGE(least)
  largest = -HUGE(least)
  DO i = 1, mesh
    span = PAR(11)*GETP('DTM',i,U)/inner
    DO k = 1, inner
      at = width*((i-1)*inner + k - 1)
      CALL gap_at(U(at+1:at+n+2), x(0), v(0))
      at = at + width
      CALL gap_at(U(at+1:at+n+2), x(1), v(1))
      least = MIN(least, x(0))
      largest = MAX(largest, x(0))
      IF (v(0)*v(1) < 0.0_DP) THEN
        q = turned()
        least = MIN(least, q)
        largest = MAX(largest, q)
      END IF
    END DO
  END DO
  PAR(21) = least
  PAR(22) = largest
CONTAINS
  SUBROUTINE gap_at(z, place, speed)
    REAL(DP), INTENT(IN) :: z(n+2)
    REAL(DP), INTENT(OUT) :: place, speed
    CALL plain(z, PAR(1), rates, slopes)
    place = DOT_PRODUCT(h(:,1), z(1:n)) - edge(1,1) - moved(1,1)*PAR(2)
    speed = DOT_PRODUCT(h(:,1), rates)
  END SUBROUTINE gap_at

  REAL(DP) FUNCTION turned()
    REAL(DP) :: c2, c3, t, rate
    INTEGER :: round
    c2 = 3.0_DP*(x(1) - x(0)) - span*(2.0_DP*v(0) + v(1))
    c3 = -2.0_DP*(x(1) - x(0)) + span*(v(0) + v(1))
    t = v(0)/(v(0) - v(1))
    DO round = 1, 20
      rate = span*v(0) + t*(2.0_DP*c2 + 3.0_DP*c3*t)
      t = t - rate/(2.0_DP*c2 + 6.0_DP*c3*t)
    END DO
    turned = x(0) + t*(span*v(0) + t*(c2 + c3*t))
  END FUNCTION turned
END SUBROUTINE PVLS

SUBROUTINE BCND
END SUBROUTINE BCND

SUBROUTINE ICND
END SUBROUTINE ICND

SUBROUTINE FOPT
END SUBROUTINE FOPT
