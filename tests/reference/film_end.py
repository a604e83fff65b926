"""The resistance of the bends: how much longer films seem where they flow into the junction of three of them.

Stokes flow of viscosity 1 through three channels of width 1 that meet under given angles around a triangle, the corners
of three grains. What it dissipates more than parabolic flow up to the sides of the triangle is
12 (alpha_1 w1^2 + alpha_2 w2^2 + alpha_3 w3^2) for mean flows w1 + w2 + w3 = 0 (docs/theory.md, Eq. 63): a quadratic form of
two variables has three coefficients, so that three flows give the three alphas. Taylor-Hood triangles, N across each
channel. Prints alpha at 120 degrees for several N, then a polynomial in the two angles beside a film that fits the
alphas of many junctions, and the largest difference. Nothing here uses Breccia. Debian 12: python3-scipy. Minutes.

    /usr/bin/python3 film_end.py
"""
import numpy as np
import scipy.sparse as sparse
from scipy.sparse.linalg import spsolve

ARM = 2.5  # length of the channels, after which the flow is parabolic to five digits


def left(direction):
    return np.array([-direction[1], direction[0]])


def mesh(n, angles):
    """Places of the vertices, and triangles counter-clockwise; corners of the grains and directions of the channels.

    angles: from channel 1 to 2 and from 2 to 3 [degrees]. Channel k is between the corners k and k + 1.
    """
    numbers, places, triangles = {}, [], []

    def vertex(place):
        key = tuple(np.round(place, 9) + 0.0)
        if key not in numbers:
            numbers[key] = len(places)
            places.append(np.array(place))
        return numbers[key]

    turns = np.radians([0.0, angles[0], angles[0] + angles[1]])
    directions = [np.array([np.cos(a), np.sin(a)]) for a in turns]
    # The corner of the grain between two channels is half a width to the left of one and to the right of the other.
    corners = [np.linalg.solve([left(directions[k - 1]), left(directions[k])], [0.5, -0.5]) for k in range(3)]
    for i in range(n):
        for j in range(n - i):
            at = lambda a, b: vertex(corners[0] + (corners[1] - corners[0]) * a / n + (corners[2] - corners[0]) * b / n)
            triangles.append([at(i, j), at(i + 1, j), at(i, j + 1)])
            if i + j + 1 < n:
                triangles.append([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)])
    columns = np.concatenate([np.linspace(0, 1, 2 * n + 1), np.linspace(1, ARM, n + 1)[1:]]) / ARM
    for k, out in enumerate(directions):
        a, b = corners[k], corners[(k + 1) % 3]
        end = (a + b) / 2 @ out + ARM

        def at(i, j):
            place = a + (b - a) * j / n
            along = place @ out
            return vertex(out * (along + (end - along) * columns[i]) + left(out) * (place @ left(out)))

        for i in range(len(columns) - 1):
            for j in range(n):
                triangles += [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]]
    return np.array(places), np.array(triangles), corners, directions


def taylor_hood(vertices, triangles):
    """Matrices of viscosity and of volume, places of the nodes, and the three nodes of each edge of the boundary."""
    middles, places, elements, uses = {}, list(vertices), [], {}
    for t in triangles:
        element = list(t)
        for a, b in ((0, 1), (1, 2), (2, 0)):
            key = tuple(sorted((t[a], t[b])))
            if key not in middles:
                middles[key] = len(places)
                places.append((vertices[t[a]] + vertices[t[b]]) / 2)
            uses[key] = uses.get(key, 0) + 1
            element.append(middles[key])
        elements.append(element)
    places = np.array(places)
    nodes, pressures = len(places), len(vertices)
    rows, columns, values = [], [], []
    b_rows, b_columns, b_values = [], [], []
    for e in elements:
        x = vertices[e[:3]]
        edges = np.array([x[1] - x[0], x[2] - x[0]])
        area = np.linalg.det(edges) / 2
        gradient = np.linalg.inv(edges) @ np.array([[-1, 1, 0], [-1, 0, 1]])
        for point in range(3):
            l = np.full(3, 1 / 6)
            l[point] = 2 / 3
            g = np.empty((2, 6))
            for i in range(3):
                j = (i + 1) % 3
                g[:, i] = (4 * l[i] - 1) * gradient[:, i]
                g[:, 3 + i] = 4 * (l[i] * gradient[:, j] + l[j] * gradient[:, i])
            strain = np.zeros((3, 12))
            strain[0, 0::2], strain[1, 1::2] = g[0], g[1]
            strain[2, 0::2], strain[2, 1::2] = g[1], g[0]
            dofs = np.array([[2 * k, 2 * k + 1] for k in e]).ravel()
            matrix = area / 3 * strain.T @ np.diag([2, 2, 1]) @ strain
            rows.append(np.repeat(dofs, 12)), columns.append(np.tile(dofs, 12)), values.append(matrix.ravel())
            coupling = area / 3 * np.outer(l, strain[0] + strain[1])
            b_rows.append(np.repeat(e[:3], 12)), b_columns.append(np.tile(dofs, 3)), b_values.append(coupling.ravel())
    join = np.concatenate
    a = sparse.csr_matrix((join(values), (join(rows), join(columns))), shape=(2 * nodes, 2 * nodes))
    b = sparse.csr_matrix((join(b_values), (join(b_rows), join(b_columns))), shape=(pressures, 2 * nodes))
    edges = [(i, j, middles[(i, j)]) for (i, j), count in uses.items() if count == 1]
    return a, b, places, edges


def lengths(n, angles):
    """alpha of the three channels."""
    vertices, triangles, corners, directions = mesh(n, angles)
    a, b, places, edges = taylor_hood(vertices, triangles)
    nodes = len(places)
    fixed = np.zeros(nodes, bool)
    for edge in edges:
        fixed[list(edge)] = True
    free = np.flatnonzero(np.repeat(~fixed, 2))
    # One pressure is held: the flows balance.
    system = sparse.bmat([[a[free][:, free], b[1:][:, free].T], [b[1:][:, free], None]], format="csc")
    flows = np.array([[1, -1, 0], [0, 1, -1], [-1, 0, 1]], float)
    velocities = []
    for flow in flows:
        velocity = np.zeros((nodes, 2))
        for k, out in enumerate(directions):
            p, q = corners[k], corners[(k + 1) % 3]
            along, across = places @ out, places @ left(out) + 0.5
            end = (np.abs(along - (p + q) / 2 @ out - ARM) < 1e-7) & (across > -1e-7) & (across < 1 + 1e-7)
            velocity[end] = flow[k] * np.outer(6 * across * (1 - across), out)[end]
        velocities.append(velocity.ravel())
    u = np.array(velocities).T
    u[free] += spsolve(system, -np.concatenate([a[free] @ u, b[1:] @ u]))[: len(free)]
    sums = (np.einsum("ik,ik->k", u, a @ u) - 24 * ARM) / 12  # of two alphas each
    return np.linalg.solve(flows**2, sums)


def monomials(beside):
    """Of the two angles beside a film, in units of 120 degrees: symmetric in both."""
    mean, apart = np.mean(beside) / 120 - 1, (beside[0] - beside[1]) / 120
    return [1, mean, mean**2, apart**2, mean**3, mean * apart**2]


if __name__ == "__main__":
    for count in (4, 8, 12, 16):
        print(count, *(f"{alpha:.5f}" for alpha in lengths(count, (120, 120))))
    N, ANGLES = 8, range(75, 170, 7)
    scale = lengths(16, (120, 120))[0] / lengths(N, (120, 120))[0]  # of the mesh
    rows, alphas, means = [], [], []
    for first in ANGLES:
        for second in ANGLES:
            third = 360 - first - second
            if not (second >= first and third >= second and third <= 170):
                continue
            found = scale * lengths(N, (first, second))
            print(first, second, third, *(f"{alpha:.4f}" for alpha in found), flush=True)
            for k, beside in enumerate(((third, first), (first, second), (second, third))):
                rows.append(monomials(beside))
                alphas.append(found[k])
    rows, alphas = np.array(rows), np.array(alphas)
    fit = np.linalg.lstsq(rows, alphas, rcond=None)[0]
    print("fit", *(f"{c:.4f}" for c in fit), "largest difference", f"{np.abs(rows @ fit - alphas).max():.4f}")
