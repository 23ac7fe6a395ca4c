"""Rotations and angles from + - * / and square roots alone, for any algebra the model runs on."""

import math
from collections.abc import Sequence

import casadi as ca

from turnbuckle.model.symbolic.linear import cross_matrix, dot, multiply
from turnbuckle.model.symbolic.scalar import Matrix, Scalar, Vector, sqrt, where

#: Taylor series of cos x and sin x / x in x^2, below half a unit in the last place up to |x| = pi.
COSINE = tuple((-1.0) ** k / math.factorial(2 * k) for k in range(15))
SINC = tuple((-1.0) ** k / math.factorial(2 * k + 1) for k in range(14))
#: Taylor series of arctan x / x in x^2, the same up to tan(pi / 16).
ARC = tuple((-1.0) ** k / (2 * k + 1) for k in range(11))
#: Squared angles below this count as zero [rad^2]; single precision can hold it.
SMALLEST_SQUARE = 1e-30


def polynomial(x: Scalar, coefficients: Sequence[float]) -> Scalar:
    """Sum of c_k x^k by Horner's rule."""
    value: Scalar = coefficients[-1]
    for coefficient in reversed(coefficients[:-1]):
        value = coefficient + x * value
    return value


def half_angle(square: Scalar) -> tuple[Scalar, Scalar]:
    """cos(t / 2) and sin(t / 2) / t from t^2 [rad^2]: smooth at zero, without a square root."""
    quarter = square / 4
    return polynomial(quarter, COSINE), polynomial(quarter, SINC) / 2


def planar_rotation(angle: Scalar) -> Matrix:
    """Rotation matrix of an angle within a full turn either way [rad]."""
    c, ratio = half_angle(angle * angle)
    s = ratio * angle
    cosine, sine = c * c - s * s, 2 * c * s
    return [[cosine, -sine], [sine, cosine]]


def spatial_rotation(vector: Vector) -> Matrix:
    """Rotation matrix exp([t]x) of a rotation vector t within a full turn [rad].

    From the unit quaternion (w, v), w = cos(|t| / 2), v = t sin(|t| / 2) / |t|:
    R = (w^2 - v.v) I + 2 w [v]x + 2 v v'.
    """
    w, ratio = half_angle(dot(vector, vector))
    v = [ratio * entry for entry in vector]
    turn = cross_matrix(v)
    stretch = w * w - dot(v, v)
    return [
        [2 * (v[i] * v[j] + w * turn[i][j]) + (stretch if i == j else 0) for j in range(3)]
        for i in range(3)
    ]


def rotation_vector_rate(vector: Vector, spin: Vector) -> Vector:
    """Rate of the rotation vector t [rad/s] of a body that spins at w [rad/s] in the fixed frame.

    t' = w - t x w / 2 + C t x (t x w), C = (1 - (|t| / 2) cot(|t| / 2)) / |t|^2; below a full turn.
    Near zero C is any number of the order of 1: its factor is |t|^2 there.
    """
    square = dot(vector, vector)
    w, ratio = half_angle(square)
    factor = (1 - w / (2 * ratio)) / ca.fmax(square, SMALLEST_SQUARE)
    once = multiply(cross_matrix(vector), spin)
    twice = multiply(cross_matrix(vector), once)
    return [a - b / 2 + factor * c for a, b, c in zip(spin, once, twice, strict=True)]


def arc_tangent(sine: Scalar, cosine: Scalar) -> Scalar:
    """Angle [rad] of the unit vector (cosine, sine), from -pi to pi, as atan2(sine, cosine).

    Folded into an eighth of a turn and halved twice: tan(t / 2) = sin t / (1 + cos t).
    """
    low = ca.fmin(ca.fabs(sine), ca.fabs(cosine))
    high = ca.fmax(ca.fabs(sine), ca.fabs(cosine))
    half = low / (1 + high)
    quarter = half / (1 + sqrt(1 + half * half))
    angle = 4 * quarter * polynomial(quarter * quarter, ARC)
    angle = where(ca.fabs(sine) > ca.fabs(cosine), math.pi / 2 - angle, angle)
    angle = where(cosine < 0, math.pi - angle, angle)
    return ca.copysign(angle, sine)
