"""Moduli of a dilute elliptic cylinder in plane strain.

Eshelby's exact strain in the cylinder, from Hill's tensor P = <n (n . C . n)^-1 n> of the matrix, averaged over the
directions n with the weight of the ellipse, a b / (a^2 n_x^2 + b^2 n_y^2). What it adds to the stiffness per area
fraction is (C_i - C_m) : (1 + P : (C_i - C_m))^-1. P is compared with the closed form of Eshelby's tensor S = P : C_m of
an elliptic cylinder (Mura, Micromechanics of Defects in Solids, Eq. 11.22). Standard Python alone; prints the numbers
of tests/homogenisation/shapes_test.cpp.
"""
import math

# Components in the order xx, yy, xy (the tensor's, not twice it); matrices act on (xx, yy, 2 xy) strains.


def stiffness(bulk, shear):
    """Stress (xx, yy, xy) from strain (xx, yy, 2 xy) in plane strain."""
    lame = bulk - 2.0 / 3.0 * shear
    return [[lame + 2.0 * shear, lame, 0.0], [lame, lame + 2.0 * shear, 0.0], [0.0, 0.0, shear]]


def product(one, other):
    return [[sum(one[i][k] * other[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def inverse(matrix):
    rows = [list(row) + [float(i == j) for j in range(3)] for i, row in enumerate(matrix)]
    for i in range(3):
        pivot = max(range(i, 3), key=lambda k: abs(rows[k][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [x / rows[i][i] for x in rows[i]]
        for k in range(3):
            if k != i:
                rows[k] = [x - rows[k][i] * y for x, y in zip(rows[k], rows[i])]
    return [row[3:] for row in rows]


def hill(bulk, shear, a, b, steps=20000):
    """Strain (xx, yy, 2 xy) from stress (xx, yy, xy), by the trapezoidal rule, exact for smooth periodic functions."""
    stiff = bulk + 4.0 / 3.0 * shear
    sums = [[0.0] * 3 for _ in range(3)]
    for step in range(steps):
        angle = 2.0 * math.pi * step / steps
        n = (math.cos(angle), math.sin(angle))
        weight = a * b / (a * a * n[0] ** 2 + b * b * n[1] ** 2) / steps
        # (n . C . n)^-1 of an isotropic matrix: along n 1 / (K + 4 G / 3), across 1 / G.
        acoustic = [[(i == j) / shear + n[i] * n[j] * (1.0 / stiff - 1.0 / shear) for j in range(2)] for i in range(2)]
        pairs = ((0, 0), (1, 1), (0, 1))
        for row, (i, j) in enumerate(pairs):
            for column, (k, l) in enumerate(pairs):
                value = 0.25 * (n[j] * acoustic[i][k] * n[l] + n[i] * acoustic[j][k] * n[l] +
                                n[j] * acoustic[i][l] * n[k] + n[i] * acoustic[j][l] * n[k])
                sums[row][column] += weight * value * (2.0 if row == 2 else 1.0) * (2.0 if column == 2 else 1.0)
    return sums


def eshelby(bulk, shear, a, b):
    nu = (3.0 * bulk - 2.0 * shear) / (6.0 * bulk + 2.0 * shear)
    c = 1.0 / (2.0 * (1.0 - nu))
    s1111 = c * ((b * b + 2.0 * a * b) / (a + b) ** 2 + (1.0 - 2.0 * nu) * b / (a + b))
    s2222 = c * ((a * a + 2.0 * a * b) / (a + b) ** 2 + (1.0 - 2.0 * nu) * a / (a + b))
    s1122 = c * (b * b / (a + b) ** 2 - (1.0 - 2.0 * nu) * b / (a + b))
    s2211 = c * (a * a / (a + b) ** 2 - (1.0 - 2.0 * nu) * a / (a + b))
    s1212 = c * ((a * a + b * b) / (2.0 * (a + b) ** 2) + 0.5 * (1.0 - 2.0 * nu))
    return [[s1111, s1122, 0.0], [s2211, s2222, 0.0], [0.0, 0.0, 2.0 * s1212]]


def added(inside, matrix, a, b):
    """What the cylinder adds to the stiffness, per area fraction."""
    contrast = [[x - y for x, y in zip(one, other)] for one, other in zip(stiffness(*inside), stiffness(*matrix))]
    factor = product(hill(*matrix, a, b), contrast)
    strain = inverse([[float(i == j) + factor[i][j] for j in range(3)] for i in range(3)])
    return product(contrast, strain)


matrix, inside = (3e9, 1e9), (40e9, 30e9)
a, b = 2.0, 1.0
closed, by_hill = eshelby(*matrix, a, b), product(hill(*matrix, a, b), stiffness(*matrix))
assert all(abs(closed[i][j] - by_hill[i][j]) < 1e-12 for i in range(3) for j in range(3))
c = added(inside, matrix, a, b)
print("per area fraction, long axis along x:", "C11 %.9g, C22 %.9g, C12 %.9g" % (c[0][0], c[1][1], c[0][1]))
print("load shear %.9g, shear-xx-yy %.9g, bulk %.9g" %
      (c[2][2], 0.25 * (c[0][0] + c[1][1] - 2.0 * c[0][1]), 0.25 * (c[0][0] + c[1][1] + 2.0 * c[0][1])))
