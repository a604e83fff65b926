"""The resistance of a bend: how much longer a film seems where it flows into the junction of three films.

Stokes flow through three channels of width 1 that meet at 120 degrees around a triangle of side 1, the corners of three
grains. Extra dissipation over that of parabolic flow up to the sides of the triangle, 12 alpha (w1^2 + w2^2 + w3^2) for
mean flows w1 + w2 + w3 = 0 and a viscosity of 1: by symmetry one alpha serves for every such flow (docs/theory.md,
Eq. 63). Taylor-Hood triangles, N across each channel. Nothing here uses Breccia. Debian 12: python3-scipy.

    /usr/bin/python3 film_end.py
"""
import numpy as np
import scipy.sparse as sparse
from scipy.sparse.linalg import spsolve

ARM = 2.5  # length of the channels, after which the flow is parabolic to five digits


def mesh(n):
    """Places of the vertices, and triangles counter-clockwise."""
    numbers, places, triangles = {}, [], []

    def vertex(place):
        key = tuple(np.round(place, 9) + 0.0)
        if key not in numbers:
            numbers[key] = len(places)
            places.append(np.array(place))
        return numbers[key]

    corners = [np.array([np.cos(a), np.sin(a)]) / np.sqrt(3) for a in np.pi * np.array([1 / 2, 7 / 6, 11 / 6])]
    for i in range(n):
        for j in range(n - i):
            at = lambda a, b: vertex(corners[0] + (corners[1] - corners[0]) * a / n + (corners[2] - corners[0]) * b / n)
            triangles.append([at(i, j), at(i + 1, j), at(i, j + 1)])
            if i + j + 1 < n:
                triangles.append([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)])
    columns = np.concatenate([np.linspace(0, 1, 2 * n + 1), np.linspace(1, ARM, n + 1)[1:]])
    for k in range(3):
        a, b = corners[k], corners[(k + 1) % 3]
        outward = np.array([(b - a)[1], -(b - a)[0]])
        at = lambda i, j: vertex(a + (b - a) * j / n + outward * columns[i])
        for i in range(len(columns) - 1):
            for j in range(n):
                triangles += [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]]
    return np.array(places), np.array(triangles), corners


def extra_length(n, flows):
    vertices, triangles, corners = mesh(n)
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

    fixed = np.zeros(nodes, bool)
    for (i, j), count in uses.items():
        if count == 1:
            fixed[[i, j, middles[(i, j)]]] = True
    velocity = np.zeros((nodes, 2))
    for k, flow in enumerate(flows):
        p, q = corners[k], corners[(k + 1) % 3]
        outward = np.array([(q - p)[1], -(q - p)[0]])
        along, across = (places - p) @ outward, (places - p) @ (q - p)
        end = np.abs(along - ARM) < 1e-9
        velocity[end] = flow * np.outer(6 * across * (1 - across), outward)[end]
    free = np.flatnonzero(np.repeat(~fixed, 2))
    u = velocity.ravel()
    # One pressure is held: the flows balance.
    system = sparse.bmat([[a[free][:, free], b[1:][:, free].T], [b[1:][:, free], None]], format="csc")
    right = -np.concatenate([a[free] @ u, b[1:] @ u])
    u[free] += spsolve(system, right)[: len(free)]
    squares = np.dot(flows, flows)
    return (u @ (a @ u) - 12 * ARM * squares) / (12 * squares)


if __name__ == "__main__":
    for count in (4, 8, 12, 16):
        print(count, *(f"{extra_length(count, np.array(f)):.5f}" for f in ((1, -1, 0), (2, -1, -1))))
