"""Checks relaxation() by steps in time (exact exponentials for strains linear in a step), without Laplace or reduction."""
from conforming import Composite
from model_composite import *
import scipy.sparse.linalg as spl


def stepped(c, boundary, load, step, end=50):
    A = K * c.vol[0] + KF * c.vol[1] + GF * c.dev[1]
    B, a, T = c.dev[0], c.affine(load), c.reduction(boundary)
    e, phi = np.exp(-step / TAU), -np.expm1(-step / TAU) * TAU / step
    solve = spl.splu((T.T @ (A + G0 * phi * B) @ T).tocsc()).solve
    u = c.modulus(load, boundary, (K, KF), (G0, GF))[1]
    H, values = G0 * u, {}
    for n in range(1, round(end / step) + 1):
        du = -T @ solve(T.T @ (A @ u + e * (B @ H)))
        u, H = u + du, e * H + G0 * phi * du
        values[round(n * step, 6)] = a @ (A @ u + B @ H) / c.area
    return np.array([values[t] for t in TIMES if 0 < t <= end])


if __name__ == "__main__":
    c = Composite(6.0, 1.0, 2, 0.6)
    print("elastic at 5e-4 MPa", c.modulus("xy", "displacement", (K, KF), (5e-4, GF))[0], flush=True)
    exact = relaxation(c, "displacement", "xy", 10)[1:6]
    for step in (1.0, 0.5):
        print(step, stepped(c, "displacement", "xy", step) / exact - 1, flush=True)
