"""The softness of the openings of films in a wall under tractions (docs/theory.md, Eq. 63b).

A layer of an incompressible solid of shear modulus 1 fills a channel of width 1 between rigid sides, and is cut by a wall
under the angle theta to the channel, 90 degrees at most. Tractions act on the cut. A uniform normal one is borne by the
pressure alone. A unit tangential one, along the direction tau of the cut that has the angle theta to the channel's way
out, moves the cut along tau by c in the mean. A flow of mean 1 that leaves the channel freely dissipates 12 alpha more than a
parabolic one up to the middle of the cut, alpha < 0 where it is less, and moves the cut along tau by cos(theta) + m in the mean. Prints c, m
and alpha by theta for some meshes, then polynomials in cos^2(theta) that fit c, m / cos(theta) and alpha. Nothing here uses
Breccia. Debian 12: python3-scipy. A minute.

    /usr/bin/python3 film_opening.py
"""
import numpy as np
import scipy.sparse as sparse
from scipy.sparse.linalg import spsolve

from film_end import ARM, taylor_hood

SIDE = 0.5  # half the width of the channel, whose axis is x; it comes from -ARM


def graded(count, strength=0.85):
    """Shares of a length, closer at both ends."""
    x = np.linspace(0, 1, count + 1)
    return x - strength * np.sin(2 * np.pi * x) / (2 * np.pi)


def mesh(n, theta):
    """Vertices and triangles of the channel up to the cut, n elements across."""
    across = SIDE * (2 * graded(n) - 1)
    first = across[1] - across[0]
    along = [0.0]
    while along[-1] < 1:
        along.append(along[-1] + min(1.5 * (along[-1] - along[-2]) if len(along) > 1 else first, 1 / n))
    along = np.concatenate([along, np.linspace(along[-1], ARM, n + 1)[1:]])[::-1] / ARM
    ends = across / np.tan(theta)
    vertices = np.array([[end - s * (ARM + end), y] for s in along for end, y in zip(ends, across)])
    at = lambda i, j: i * (n + 1) + j
    triangles = []
    for i in range(len(along) - 1):
        for j in range(n):
            triangles += [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]]
    return vertices, np.array(triangles)


def opening(n, theta):
    """c, m and alpha."""
    vertices, triangles = mesh(n, theta)
    a, b, places, edges = taylor_hood(vertices, triangles)
    tau = np.array([np.cos(theta), np.sin(theta)])
    along, across = places.T
    fixed = np.zeros(len(places), bool)
    mean = np.zeros(2 * len(places))  # of the displacement along tau, over the cut, times its length
    cut = 1 / np.sin(theta)
    for i, j, middle in edges:
        on_cut = abs(places[middle] @ [np.sin(theta), -np.cos(theta)]) < 1e-9
        if not on_cut:
            fixed[[i, j, middle]] = True
            continue
        length = np.linalg.norm(places[i] - places[j])
        for node, share in ((i, 1 / 6), (j, 1 / 6), (middle, 4 / 6)):
            mean[2 * node : 2 * node + 2] += share * length * tau
    free = np.flatnonzero(np.repeat(~fixed, 2))
    system = sparse.bmat([[a[free][:, free], b[:, free].T], [b[:, free], None]], format="csc")
    u = np.zeros((2 * len(places), 2))
    far = along < -ARM + 1e-9
    u[0::2, 1][far] = 1.5 * (1 - 4 * across[far] ** 2)
    right = np.zeros((len(free) + b.shape[0], 2))
    right[: len(free), 0] = mean[free]
    right[:, 1] = -np.concatenate([a[free] @ u[:, 1], b @ u[:, 1]])
    u[free] += spsolve(system, right)[: len(free)]
    c, moved = mean @ u / cut
    return c, moved - np.cos(theta), (u[:, 1] @ a @ u[:, 1] - 12 * ARM) / 12


if __name__ == "__main__":
    for n in (8, 16, 32):
        print(n, *(f"{x:.5f}" for x in opening(n, np.pi / 2)), *(f"{x:.5f}" for x in opening(n, np.pi / 4)))
    angles = np.radians(range(30, 91, 5))
    found = np.array([opening(24, theta) for theta in angles])
    for theta, row in zip(angles, found):
        print(f"{np.degrees(theta):.0f}", *(f"{x:.5f}" for x in row))
    cosine = np.cos(angles)
    powers = np.vander(cosine**2, 4, increasing=True)
    for name, values, scale in (("c", found[:, 0], 1), ("m", found[:, 1], cosine), ("alpha", found[:, 2], 1)):
        fit = np.linalg.lstsq(powers * np.reshape(scale * np.ones_like(cosine), (-1, 1)), values, rcond=None)[0]
        error = np.abs(powers @ fit * scale - values).max()
        print(name, *(f"{x:.4f}" for x in fit), "largest difference", f"{error:.4f}")
