"""A bracket of solid elements by a finite-element program, scikit-fem, and its frequencies and deflection by scipy.

pip install scikit-fem scipy
python3 solid_elements.py FOLDER        writes FOLDER/solid.npz and prints the references

A bar of steel, 0.4 m x 40 mm x 20 mm, in 8 x 1 x 1 hexahedra of second order, free in space. It is held at all nodes of the face
x = 0, and pulled along z by 100 N at the middle of the face x = 0.4 m.
"""

import sys

import numpy as np
import scipy.linalg
import scipy.sparse
import skfem
from skfem.helpers import ddot, dot, eye, sym_grad, trace

LENGTH, HIGH, WIDE = 0.4, 0.04, 0.02
YOUNG, POISSON, DENSITY = 210e9, 0.3, 7850.0
PULL = 100.0

lame = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
shear = YOUNG / (2 * (1 + POISSON))


def assembled():
    """Nodes (n x 3), and M and K with the three displacements of each node one after another."""
    places = [np.linspace(0, LENGTH, 9), np.array([0, HIGH]) - HIGH / 2, np.array([0, WIDE]) - WIDE / 2]
    basis = skfem.Basis(skfem.MeshHex.init_tensor(*places), skfem.ElementVector(skfem.ElementHex2()), intorder=4)
    stiffness = skfem.BilinearForm(
        lambda u, v, _: ddot(lame * eye(trace(sym_grad(u)), 3) + 2 * shear * sym_grad(u), sym_grad(v))
    )
    mass = skfem.BilinearForm(lambda u, v, _: DENSITY * dot(u, v))
    k, m = stiffness.assemble(basis), mass.assemble(basis)
    # The program numbers freedoms by corners, edges, faces and insides; each place has three.
    order = np.lexsort((np.tile(np.arange(3), basis.N // 3), *np.round(basis.doflocs[::-1], 9)))
    same = basis.doflocs[:, order].T.reshape(-1, 3, 3)
    assert np.allclose(same, same[:, :1]), "three freedoms at every place"
    # Of one place the freedoms come in the order of x, y, z, which their shapes tell: a shift along an axis is one of the three.
    axes = np.empty(basis.N, int)
    for axis in range(3):
        unit = [1.0 if i == axis else 0.0 for i in range(3)]
        shift = basis.project(lambda x: np.stack([0 * x[0] + value for value in unit]))
        axes[np.abs(shift) > 0.5] = axis
    order = np.lexsort((axes, *np.round(basis.doflocs[::-1], 9)))
    return basis.doflocs[:, order].T[::3], m.tocsr()[order][:, order], k.tocsr()[order][:, order]


def references(nodes, m, k):
    """The lowest six frequencies (rad/s) of the held bar, those of the free one, and the deflection where it is pulled (m)."""
    root = np.flatnonzero(np.abs(nodes[:, 0]) < 1e-9)
    tip = np.argmin(np.linalg.norm(nodes - [LENGTH, 0, 0], axis=1))
    held = np.concatenate([3 * root + axis for axis in range(3)])
    free = np.setdiff1d(np.arange(3 * len(nodes)), held)
    m, k = m.toarray(), k.toarray()
    values = scipy.linalg.eigh(k[np.ix_(free, free)], m[np.ix_(free, free)], eigvals_only=True)[:6]
    unheld = scipy.linalg.eigh(k, m, eigvals_only=True)[6:12]
    force = np.zeros(3 * len(nodes))
    force[3 * tip + 2] = PULL
    bent = np.zeros(3 * len(nodes))
    bent[free] = np.linalg.solve(k[np.ix_(free, free)], force[free])
    return np.sqrt(values), np.sqrt(unheld), bent[3 * tip + 2], root, tip


if __name__ == "__main__":
    nodes, m, k = assembled()
    held, unheld, bent, root, tip = references(nodes, m, k)
    parts = {}
    for name, matrix in (("M", m), ("K", k)):
        matrix = scipy.sparse.csr_matrix(matrix)
        matrix.sum_duplicates()
        parts |= {f"{name}_data": matrix.data, f"{name}_indices": matrix.indices, f"{name}_indptr": matrix.indptr}
        parts[f"{name}_shape"] = np.array(matrix.shape)
    np.savez_compressed(f"{sys.argv[1]}/solid.npz", nodes=nodes, **parts)
    print("nodes", len(nodes), "mass", m.sum() / 3)
    print("root", (root + 1).tolist())
    print("tip", tip + 1)
    print("held, rad/s", held.tolist())
    print("free, rad/s", unheld.tolist())
    print("deflection, m", bent)
