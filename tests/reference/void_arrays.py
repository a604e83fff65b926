"""Writes void_arrays.csv: one circular or spherical void in a periodic square or cube, by symmetry an eighth (quarter) of
it, with Lagrange elements of high degree that follow the void."""
import itertools
import math
import sys

import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg as linalg

LOADS = {"xy": "shear", "xx-yy": "stretch", "bulk": "stretch"}


def lobatto(degree):
    """The points of Gauss and Lobatto in [0, 1], among them 0 and 1."""
    inner = np.polynomial.legendre.Legendre.basis(degree).deriv().roots()
    return (np.concatenate([[-1.0], inner, [1.0]]) + 1.0) / 2.0


def lagrange(nodes, x):
    """Values and derivatives of the Lagrange polynomials of the nodes at the points x, each of shape (points, nodes)."""
    values, slopes = np.ones((len(x), len(nodes))), np.zeros((len(x), len(nodes)))
    for i, node in enumerate(nodes):
        others = np.delete(nodes, i)
        factors = (x[:, None] - others) / (node - others)
        values[:, i] = factors.prod(axis=1)
        for k in range(len(others)):
            slopes[:, i] += np.delete(factors, k, axis=1).prod(axis=1) / (node - others[k])
    return values, slopes


class Mesh:
    """Blocks between the void around the origin and the outer faces of [0, 1/2]^dim."""

    def __init__(self, dim, radius, degree, elements):
        self.dim, self.degree = dim, degree
        line = (np.arange(elements)[:, None] + lobatto(degree)[None, :]) / elements
        self.elements, points = [], []
        for axis in range(dim):
            others = [a for a in range(dim) if a != axis]
            for element in itertools.product(range(elements), repeat=dim):
                r, *face = np.meshgrid(*(line[i] for i in element), indexing="ij")
                outer = np.empty(r.shape + (dim,))
                outer[..., axis] = 0.5
                for a, x in zip(others, face):
                    outer[..., a] = 0.5 * x
                inner = radius * outer / np.linalg.norm(outer, axis=-1, keepdims=True)
                points.append((inner + r[..., None] * (outer - inner)).reshape(-1, dim))
        every = np.concatenate(points)
        _, first, number = np.unique(np.round(every, 9), axis=0, return_index=True, return_inverse=True)
        self.nodes = every[first]
        self.elements = number.reshape(len(points), -1)

    def stiffness(self, bulk, shear):
        """The stiffness matrix of K and G."""
        dim, nodes = self.dim, lobatto(self.degree)
        x, w = np.polynomial.legendre.leggauss(self.degree + 2)
        value, slope = lagrange(nodes, (x + 1.0) / 2.0)
        gradients = []
        for axis in range(dim):
            factor = np.ones((1, 1))
            for a in range(dim):
                factor = np.kron(factor, slope if a == axis else value)
            gradients.append(factor)
        gradients = np.stack(gradients, axis=-1)  # points, nodes, axes
        weights = np.array([math.prod(p) for p in itertools.product(w / 2.0, repeat=dim)])
        lame = bulk - 2.0 * shear / 3.0
        rows, columns, entries = [], [], []
        for element in self.elements:
            jacobian = np.einsum("pni,nj->pij", gradients, self.nodes[element])
            local = np.einsum("pij,pnj->pni", np.linalg.inv(jacobian), gradients)
            volume = weights * np.abs(np.linalg.det(jacobian))
            laplace = np.einsum("p,pni,pmi->nm", volume, local, local)
            mixed = np.einsum("p,pni,pmj->nimj", volume, local, local)
            block = lame * mixed + shear * mixed.transpose(0, 3, 2, 1)
            for i in range(dim):
                block[:, i, :, i] += shear * laplace
            numbers = (dim * element[:, None] + np.arange(dim)).ravel()
            rows.append(np.repeat(numbers, len(numbers)))
            columns.append(np.tile(numbers, len(numbers)))
            entries.append(block.reshape(-1))
        size = dim * len(self.nodes)
        return sparse.csr_matrix((np.concatenate(entries), (np.concatenate(rows), np.concatenate(columns))), (size, size))

    def prescribed(self, load):
        """The prescribed displacements under a unit load, nan where a component is free."""
        u = np.full(self.nodes.shape, np.nan)
        shears = LOADS[load] == "shear"
        strain = {"xx-yy": [0.5, -0.5, 0.0], "bulk": [1.0 / self.dim] * 3}.get(load)
        for axis in range(self.dim):
            for at in (0.0, 0.5):
                on_face = np.abs(self.nodes[:, axis] - at) < 1e-7
                if not shears or axis == 2:
                    u[on_face, axis] = at * (0.0 if shears else strain[axis])
                    continue
                u[on_face, 1 - axis] = 0.5 * at
                u[on_face, 2:] = 0.0
        return u.ravel()

    def modulus(self, stiffness, load):
        """The modulus: G under the shears, and K (in plane strain K + G/3) under the bulk load."""
        u = self.prescribed(load)
        free = np.isnan(u)
        u[free] = 0.0
        held = stiffness @ u
        u[free] = linalg.spsolve(stiffness[free][:, free].tocsc(), -held[free])
        return u @ (stiffness @ u) * 2.0**self.dim  # twice the energy of the whole cell, under a strain of size one


def radius_of(dim, fraction):
    return math.sqrt(fraction / math.pi) if dim == 2 else (3.0 * fraction / (4.0 * math.pi)) ** (1.0 / 3.0)


def main():
    print("""\
# Effective moduli of a square array of circular voids (plane strain) and of a simple cubic array of spherical voids,
# over the shear modulus of the matrix. load xy: G, xx-yy: (C11 - C12)/2, bulk: K, in plane strain K + G/3. bulk_ratio:
# K/G of the matrix. Made by void_arrays.py: elements that follow the void; relative_error is the change from elements
# of one degree less.
dimensions,fraction,load,bulk_ratio,modulus,relative_error""")
    for dim, fractions, degree, elements in ((2, (0.2, 0.5), 10, 3), (3, (0.1, 0.3, 0.45), 5, 2)):
        for fraction in fractions:
            meshes = [Mesh(dim, radius_of(dim, fraction), p, elements) for p in (degree - 1, degree)]
            for bulk_ratio in (3, 3600) if dim == 2 else (2, 100):
                parts = [mesh.stiffness(bulk_ratio, 1.0) for mesh in meshes]
                for load in LOADS:
                    coarse, fine = (mesh.modulus(part, load) for mesh, part in zip(meshes, parts))
                    print(f"{dim},{fraction},{load},{bulk_ratio},{fine:.9g},{abs(coarse / fine - 1):.1e}", flush=True)


if __name__ == "__main__":
    sys.exit(main())
