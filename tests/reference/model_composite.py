"""Writes model_composite.csv: G(t) of the model composite, exact in time through the poles of a reduced basis."""
from conforming import Composite
import numpy as np, scipy.linalg as la

G0, TAU, K, KF, GF = 0.5, 10.0, 1.0, 50.0, 18.8  # MPa, ms
TIMES = (0, 1, 3, 10, 30, 50, 70, 100)  # ms


def relaxation(c, boundary, load, snapshots):
    """G(t) [MPa]: with the matrix modulus G z / (1 + z), z = s tau, the stiffness is A + G z / (1 + z) B."""
    A = K * c.vol[0] + KF * c.vol[1] + GF * c.dev[1]
    B, a = c.dev[0], c.affine(load)
    moduli = np.geomspace(1e-6, 1.0, snapshots) * G0
    W = np.stack([c.modulus(load, boundary, (K, KF), (g, GF))[1] - a for g in moduli], 1)
    W = la.qr(W / la.norm(W, axis=0), mode="economic")[0]
    mu, phi = la.eigh(W.T @ (B @ W), W.T @ ((A + B) @ W))  # A -> 1 - mu, B -> mu
    W = W @ phi
    p, q, lam = W.T @ (A @ a), W.T @ (B @ a), 1 - mu
    z = -lam / (lam + mu * G0)
    t = np.array(TIMES)[:, None] / TAU
    at_zero = a @ (A @ a) - np.sum(p**2 / lam)
    matrix = np.exp(-t[:, 0]) * G0 * (a @ (B @ a) - np.sum(q**2 / mu))
    own = (p * (1 + z) + q * G0 * z) ** 2 / (z * (1 + z) * (lam + mu * G0))
    return (at_zero + matrix - np.exp(z * t) @ own) / c.area


def main():
    print("""# Relaxation modulus of the model composite, four discs of 2 mm in a 6 mm box, conforming mesh. Made by
# model_composite.py: quartic triangles with second-order geometry, 10 snapshots; relative_error is the larger change
# from mesh size 0.45 to 0.3 mm and from 8 to 10 snapshots.
boundary,load,time_ms,modulus_MPa,relative_error""")
    coarse, fine = (Composite(6.0, 1.0, 2, size) for size in (0.45, 0.3))
    for boundary in ("displacement", "periodic"):
        for load in ("xy", "xx-yy"):
            best = relaxation(fine, boundary, load, 10)
            error = np.maximum(abs(relaxation(coarse, boundary, load, 10) / best - 1),
                               abs(relaxation(fine, boundary, load, 8) / best - 1))
            for t, g, e in zip(TIMES, best, error):
                print(f"{boundary},{load},{t},{g:.9g},{e:.1e}", flush=True)


if __name__ == "__main__":
    main()
