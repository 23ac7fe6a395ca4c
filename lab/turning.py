"""Turns of a body: unit quaternions (w, x, y, z), and rotation vectors [rad] for what is told.

Plain Python numbers, not arrays: for one body that is several times faster than NumPy. The plane is
a slice of space: a body in it turns about z alone.
"""

from math import atan2, cos, hypot, sin

from turnbuckle.model.base import Coordinates

Quaternion = tuple[float, float, float, float]
Vector = tuple[float, float, float]

SMALL_ANGLE = 1e-4
"""Below [rad], differences of an angle and its sine have lost their digits."""


def from_vector(vector: Vector) -> Quaternion:
    """The turn by a rotation vector [rad]."""
    x, y, z = vector
    angle = hypot(x, y, z)
    share = sin(0.5 * angle) / angle if angle > 0.0 else 0.5
    return cos(0.5 * angle), share * x, share * y, share * z


def to_vector(turn: Quaternion) -> Vector:
    """The rotation vector [rad] of a turn, at most half a turn long."""
    w, x, y, z = turn if turn[0] >= 0.0 else (-turn[0], -turn[1], -turn[2], -turn[3])
    sine = hypot(x, y, z)
    share = 2.0 * atan2(sine, w) / sine if sine > 0.0 else 2.0
    return share * x, share * y, share * z


def then(first: Quaternion, second: Quaternion) -> Quaternion:
    """One turn after the other, both about axes of the fixed frame; of length one again."""
    (a, b, c, d), (w, x, y, z) = first, second
    turn = (
        w * a - x * b - y * c - z * d,
        w * b + x * a + y * d - z * c,
        w * c - x * d + y * a + z * b,
        w * d + x * c - y * b + z * a,
    )
    size = hypot(*turn)
    return turn[0] / size, turn[1] / size, turn[2] / size, turn[3] / size


def between(first: Quaternion, second: Quaternion) -> Vector:
    """The rotation vector [rad], in the fixed frame, that leads from one turn to another."""
    w, x, y, z = first
    return to_vector(then((w, -x, -y, -z), second))


def matrix(turn: Quaternion) -> tuple[Vector, Vector, Vector]:
    """The rotation matrix of a turn, by rows."""
    w, x, y, z = turn
    return (
        (1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)),
        (2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)),
        (2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)),
    )


def spin(vector: Vector, rate: Vector) -> Vector:
    """Angular velocity [rad/s] in the fixed frame, of a rotation vector [rad] and its rate: the
    left Jacobian of SO(3), I + (1 - cos t)/t^2 [v]x + (t - sin t)/t^3 [v]x^2 with t = |v|."""
    angle = hypot(*vector)
    if angle < SMALL_ANGLE:
        first, second = 0.5, 1.0 / 6.0
    else:
        first = (1.0 - cos(angle)) / (angle * angle)
        second = (angle - sin(angle)) / (angle * angle * angle)
    once = cross(vector, rate)
    twice = cross(vector, once)
    x, y, z = (r + first * a + second * b for r, a, b in zip(rate, once, twice, strict=True))
    return x, y, z


def cross(first: Vector, second: Vector) -> Vector:
    """The cross product of two vectors."""
    (x, y, z), (u, v, w) = first, second
    return y * w - z * v, z * u - x * w, x * v - y * u


def in_space(turns: Coordinates) -> Vector:
    """A rotation vector of three entries: none of them given for a point, z alone in the plane."""
    if len(turns) == 3:
        return turns[0], turns[1], turns[2]
    return 0.0, 0.0, sum(turns)
