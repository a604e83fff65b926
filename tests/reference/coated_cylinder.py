"""Transverse moduli of a dilute coated cylinder in plane strain.

The area strain: the composite cylinder assemblage (Hashin and Rosen 1964), applied first to core and coating, then to
the coated cylinder and the matrix. The shear: the displacements of order two around a coated cylinder in a sheared
matrix (Christensen and Lo 1979, Eqs. 4.3 to 4.5), whose 1/r part gives the change of the modulus. The factor between
both is that of a homogeneous cylinder, whose change is Eshelby's. Standard Python alone; prints the numbers of
tests/homogenisation/coating_test.cpp.
"""
import math


def solve(matrix, right):
    n = len(right)
    rows = [row + [value] for row, value in zip(matrix, right)]
    for i in range(n):
        pivot = max(range(i, n), key=lambda k: abs(rows[k][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for k in range(n):
            if k != i:
                factor = rows[k][i] / rows[i][i]
                rows[k] = [x - factor * y for x, y in zip(rows[k], rows[i])]
    return [rows[i][n] / rows[i][i] for i in range(n)]


def field(power, r, bulk, shear):
    """u_r / cos 2a, u_a / sin 2a and the tractions s_rr, s_ra of one solution r^power."""
    eta = 3.0 - 4.0 * (3.0 * bulk - 2.0 * shear) / (6.0 * bulk + 2.0 * shear)
    a, b = {1: (1.0, -1.0), 3: (eta - 3.0, eta + 3.0), -1: (eta + 1.0, 1.0 - eta), -3: (1.0, 1.0)}[power]
    scale = r ** (power - 1)
    radial, hoop, angle = a * power * scale, (a + 2.0 * b) * scale, (-2.0 * a + (power - 1) * b) * scale
    normal = (bulk - 2.0 / 3.0 * shear) * (radial + hoop) + 2.0 * shear * radial
    return [a * r**power, b * r**power, normal, shear * angle]


def dipole(core, coating, matrix, a, b):
    columns = [field(p, a, *core) + [0.0] * 4 for p in (1, 3)]
    for p in (1, 3, -1, -3):
        columns.append([-x for x in field(p, a, *coating)] + field(p, b, *coating))
    for p in (-1, -3):
        columns.append([0.0] * 4 + [-x for x in field(p, b, *matrix)])
    right = [0.0] * 4 + field(1, b, *matrix)
    scales = [1.0, 1.0, matrix[1], matrix[1]] * 2
    rows = [[column[i] / scales[i] for column in columns] for i in range(8)]
    return solve(rows, [x / scale for x, scale in zip(right, scales)])[6] / b**2


def beta(matrix):
    plane = matrix[0] + matrix[1] / 3.0
    return (plane + 2.0 * matrix[1]) / (2.0 * (plane + matrix[1]))


def shear_change(core, coating, matrix, a, b):
    """(G - G_matrix) / (G_matrix c) of few cylinders, of area fraction c with their coatings."""
    homogeneous = (3.0 * matrix[0], 5.0 * matrix[1])
    of_homogeneous = 4.0 / (1.0 + 4.0 * beta(matrix))
    return dipole(core, coating, matrix, a, b) * of_homogeneous / dipole(homogeneous, homogeneous, matrix, a, b)


def plane_bulk(core, coating, matrix, a, b, fraction):
    def mixed(inside, outside, share):
        plane = outside[0] + outside[1] / 3.0
        return plane + share / (1.0 / (inside - plane) + (1.0 - share) / (plane + outside[1]))

    return mixed(mixed(core[0] + core[1] / 3.0, coating, (a / b) ** 2), matrix, fraction)


if __name__ == "__main__":
    core, matrix, fraction = (40e9, 30e9), (3e9, 1e9), 0.01
    for coating in ((1.5e9, 0.1e9), (8e9, 4e9)):
        change = shear_change(core, coating, matrix, 0.8, 1.0)
        shear = matrix[1] * (1.0 + fraction * change / (1.0 - fraction * beta(matrix) * change))
        print(coating, "K + G/3 %.9g" % plane_bulk(core, coating, matrix, 0.8, 1.0, fraction), "G %.9g" % shear)
