#!/usr/bin/env python3
"""Writes the finite-element bodies of the tests: beams of Bernoulli and Euler in space, and a block of bricks.

Nothing here knows rncf. Usage: python3 tests/reference/data/finite_elements.py (numpy)
"""

import os

import numpy as np

FOLDER = os.path.dirname(os.path.abspath(__file__))


def beam(length, axial, bending_y, bending_z, torsion, mass, polar, count):
    """Nodes, mass and stiffness of a straight beam along x: EA, EI about y and z, GJ, mass and polar inertia per length;
    consistent mass, six degrees of freedom a node."""
    size = 6 * (count + 1)
    m, k = np.zeros((size, size)), np.zeros((size, size))
    h = length / count
    bar = np.array([[1, -1], [-1, 1]]) / h
    rod = np.array([[2, 1], [1, 2]]) * h / 6
    bend = np.array([[12, 6 * h, -12, 6 * h], [6 * h, 4 * h * h, -6 * h, 2 * h * h],
                     [-12, -6 * h, 12, -6 * h], [6 * h, 2 * h * h, -6 * h, 4 * h * h]]) / h**3
    hermite = np.array([[156, 22 * h, 54, -13 * h], [22 * h, 4 * h * h, 13 * h, -3 * h * h],
                        [54, 13 * h, 156, -22 * h], [-13 * h, -3 * h * h, -22 * h, 4 * h * h]]) * h / 420
    other = np.diag([1, -1, 1, -1])  # w' = -theta_y
    for element in range(count):
        first = 6 * element

        def add(places, stiffness, inertia):
            index = np.ix_([first + p for p in places], [first + p for p in places])
            k[index] += stiffness
            m[index] += inertia

        add([0, 6], axial * bar, mass * rod)
        add([3, 9], torsion * bar, polar * rod)
        add([1, 5, 7, 11], bending_z * bend, mass * hermite)
        add([2, 4, 8, 10], bending_y * other @ bend @ other, mass * other @ hermite @ other)
    nodes = np.zeros((count + 1, 3))
    nodes[:, 0] = np.linspace(0, length, count + 1)
    return nodes, m, k


def brick(sizes, counts, young, poisson, density):
    """Nodes, mass and stiffness of a block of eight-node bricks from its corner at the origin, three degrees of freedom a node."""
    h = np.array(sizes) / np.array(counts)
    gauss = np.array([-1, 1]) / np.sqrt(3)
    corners = np.array([[x, y, z] for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)])
    lame = young * poisson / ((1 + poisson) * (1 - 2 * poisson))
    shear = young / (2 * (1 + poisson))
    law = np.diag([2 * shear] * 3 + [shear] * 3)
    law[:3, :3] += lame
    own_k, own_m = np.zeros((24, 24)), np.zeros((24, 24))
    volume = np.prod(h) / 8
    for at in ((x, y, z) for x in gauss for y in gauss for z in gauss):
        shape = np.prod(1 + corners * at, axis=1) / 8
        slopes = np.array([corners[:, i] * np.prod(np.delete(1 + corners * at, i, axis=1), axis=1) / 8 * 2 / h[i]
                           for i in range(3)])
        strain = np.zeros((6, 24))
        for i in range(3):
            strain[i, i::3] = slopes[i]
        for row, (i, j) in zip((3, 4, 5), ((0, 1), (1, 2), (2, 0))):
            strain[row, i::3], strain[row, j::3] = slopes[j], slopes[i]
        own_k += strain.T @ law @ strain * volume
        own_m += np.kron(np.outer(shape, shape), np.eye(3)) * density * volume
    nx, ny, nz = (c + 1 for c in counts)
    number = lambda x, y, z: x + nx * (y + ny * z)
    nodes = np.array([[x, y, z] * h for z in range(nz) for y in range(ny) for x in range(nx)])
    size = 3 * len(nodes)
    m, k = np.zeros((size, size)), np.zeros((size, size))
    for x in range(counts[0]):
        for y in range(counts[1]):
            for z in range(counts[2]):
                own = [number(x + (c[0] + 1) // 2, y + (c[1] + 1) // 2, z + (c[2] + 1) // 2) for c in corners]
                index = np.array([[3 * n, 3 * n + 1, 3 * n + 2] for n in own]).ravel()
                k[np.ix_(index, index)] += own_k
                m[np.ix_(index, index)] += own_m
    return nodes, m, k


def sparse(name, matrix):
    """The parts of a matrix in compressed rows, as scipy.sparse.save_npz has them, behind a name."""
    rows = [np.flatnonzero(row) for row in matrix]
    return {
        f"{name}_data": np.concatenate([matrix[i, row] for i, row in enumerate(rows)]),
        f"{name}_indices": np.concatenate(rows).astype(np.int32),
        f"{name}_indptr": np.cumsum([0] + [len(row) for row in rows]).astype(np.int32),
        f"{name}_shape": np.array(matrix.shape),
    }


def main():
    # 2 m long, 40 mm x 20 mm of aluminium along y and z.
    b, t, young, shear, density = 0.04, 0.02, 70e9, 26e9, 2700.0
    area, iy, iz = b * t, b * t**3 / 12, t * b**3 / 12
    torsion = 0.229 * b * t**3
    nodes, m, k = beam(2.0, young * area, young * iy, young * iz, shear * torsion, density * area, density * (iy + iz), 8)
    ids = 10 * np.arange(1, 10)
    np.savez_compressed(os.path.join(FOLDER, "beam.npz"), nodes=nodes, node_ids=ids, M=m, K=k)
    # The same in mm, t, s (MPa): stored, in parts, big-endian and in the order of Fortran.
    scale = np.tile([1, 1, 1, 1e3, 1e3, 1e3], 9)
    m_mm, k_mm = (np.outer(scale, scale) * matrix * 1e-3 for matrix in (m, k))
    np.savez(os.path.join(FOLDER, "beam_mm.npz"), nodes=np.asfortranarray(1e3 * nodes).astype(">f8"), node_ids=ids,
             **sparse("M", m_mm), **sparse("K", k_mm))
    # A block of 1.2 m x 0.1 m x 0.1 m.
    nodes, m, k = brick([1.2, 0.1, 0.1], [6, 1, 1], 70e9, 0.3, 2700.0)
    np.savez_compressed(os.path.join(FOLDER, "block.npz"), nodes=nodes, **sparse("M", m), **sparse("K", k))


if __name__ == "__main__":
    main()
