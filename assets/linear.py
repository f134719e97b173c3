"""Linear algebra whose results do not depend on the machine.

BLAS and LAPACK add in an order that suits the processor. Here every element is
multiplied and added by itself, in a fixed order.
"""

import numpy as np


def product(a, b):
    """a @ b."""
    out = np.zeros((a.shape[0], b.shape[1]))
    for k in range(a.shape[1]):
        rows = np.flatnonzero(a[:, k])
        out[rows] += a[rows, k, None] * b[k]
    return out


def inverse(a):
    """The inverse of a symmetric, positive definite matrix."""
    n = len(a)
    left, right = a.copy(), np.eye(n)
    for k in range(n):
        pivot = left[k, k]
        left[k] /= pivot
        right[k] /= pivot
        rows = np.flatnonzero(left[:, k])
        rows = rows[rows != k]
        factor = left[rows, k, None]
        left[rows, k:] -= factor * left[k, k:]
        right[rows, :k + 1] -= factor * right[k, :k + 1]
    return right
