"""Plane-strain stiffness of square arrays of discs on meshes that follow the circles (quartic displacements)."""
import gmsh, numpy as np, scipy.sparse as sp, scipy.sparse.linalg as spl, ufl
from mpi4py import MPI
from dolfinx import fem
from dolfinx.io import gmshio


def mesh(side, radius, count, size):
    """count x count discs in a box; geometry of second order, equal nodes on opposite sides."""
    gmsh.initialize(); gmsh.option.setNumber("General.Terminal", 0)
    occ, pitch = gmsh.model.occ, side / count
    box = occ.addRectangle(0, 0, 0, side, side)
    discs = [(2, occ.addDisk((i + .5) * pitch, (j + .5) * pitch, 0, radius, radius))
             for i in range(count) for j in range(count)]
    occ.fragment([(2, box)], discs); occ.synchronize()
    tags = [t for _, t in discs]
    gmsh.model.addPhysicalGroup(2, [t for _, t in gmsh.model.getEntities(2) if t not in tags], 1)
    gmsh.model.addPhysicalGroup(2, tags, 2)
    e = 1e-6 * side
    for axis in (0, 1):
        low, high = [0, 0], [side, side]; high[axis] = 0
        a = gmsh.model.getEntitiesInBoundingBox(-e, -e, -e, high[0] + e, high[1] + e, e, 1)[0][1]
        low[axis] = side
        b = gmsh.model.getEntitiesInBoundingBox(low[0] - e, low[1] - e, -e, side + e, side + e, e, 1)[0][1]
        shift = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]; shift[4 * axis + 3] = side
        gmsh.model.mesh.setPeriodic(1, [b], [a], shift)
    gmsh.option.setNumber("Mesh.MeshSizeMin", size); gmsh.option.setNumber("Mesh.MeshSizeMax", size)
    gmsh.model.mesh.generate(2); gmsh.model.mesh.setOrder(2)
    result = gmshio.model_to_mesh(gmsh.model, MPI.COMM_SELF, 0, gdim=2)
    gmsh.finalize()
    return result[0], result[1]


class Composite:
    """Stiffness parts at unit modulus: volumetric and deviatoric, matrix (1) and filler (2)."""

    def __init__(self, side, radius, count, size, degree=4):
        domain, cells = mesh(side, radius, count, size)
        V = fem.VectorFunctionSpace(domain, ("Lagrange", degree))
        u, v = ufl.TrialFunction(V), ufl.TestFunction(V)
        dx = ufl.Measure("dx", domain=domain, subdomain_data=cells, metadata={"quadrature_degree": 2 * degree + 2})
        eps = lambda w: ufl.sym(ufl.grad(w))
        vol = ufl.div(u) * ufl.div(v)
        dev = 2 * (ufl.inner(eps(u), eps(v)) - vol / 3)

        def matrix(form):
            m = fem.petsc.assemble_matrix(fem.form(form)); m.assemble()
            ptr, col, val = m.getValuesCSR()
            return sp.csr_matrix((val, col, ptr), shape=m.getSize())
        self.vol = [matrix(vol * dx(k)) for k in (1, 2)]
        self.dev = [matrix(dev * dx(k)) for k in (1, 2)]
        self.x, self.side, self.area = V.tabulate_dof_coordinates()[:, :2], side, side * side
        tol = 1e-7 * side
        self.edge = np.any((self.x < tol) | (self.x > side - tol), axis=1)
        self.tol = tol

    def affine(self, load):
        x, y = (self.x - self.side / 2).T
        return np.stack({"xy": (y, x), "xx-yy": (x, -y), "bulk": (x, y)}[load], 1).ravel() / 2

    def reduction(self, boundary):
        """Columns: the displacements that the boundary leaves free."""
        n = len(self.x)
        if boundary == "displacement":
            keep = np.flatnonzero(~self.edge); rows, cols, m = keep, np.arange(len(keep)), len(keep)
        else:  # periodic: opposite nodes move together, one node is held
            key = np.round(np.where(self.x > self.side - self.tol, 0, self.x) / self.tol / 10).astype(int)
            _, owner = np.unique(key, axis=0, return_inverse=True)
            owner = owner.ravel() - 1; rows = np.flatnonzero(owner >= 0); cols, m = owner[rows], owner.max() + 1
        return sp.kron(sp.csr_matrix((np.ones(len(rows)), (rows, cols)), (n, m)), sp.eye(2)).tocsc()

    def modulus(self, load, boundary, K, G):
        """Effective modulus (shear, or K + G/3) for moduli (matrix, filler)."""
        S = sum(k * m for k, m in zip(K, self.vol)) + sum(g * m for g, m in zip(G, self.dev))
        T, a = self.reduction(boundary), self.affine(load)
        u = a - T @ spl.splu((T.T @ S @ T).tocsc(), permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True},
                             diag_pivot_thresh=0.0).solve(T.T @ (S @ a))
        return u @ (S @ u) / self.area, u
