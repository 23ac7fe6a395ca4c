"""The map as one writes it first: for every pose a quadratic program and a convex hull."""

from itertools import product

import numpy as np
import quadprog
from scipy.spatial import ConvexHull

from turnbuckle.lab.benchmark.map.scene import Scene
from turnbuckle.lab.benchmark.tension_problems import Reals


def loop_map(scene: Scene, poses: Reals) -> tuple[Reals, Reals]:
    """Margin [N] and factor (count) of poses (count, 2)."""
    points = np.moveaxis(scene.base_points(poses), -1, 0)
    bounds = scene.machine.tension
    vertices = np.array(list(product((bounds.min, bounds.max), repeat=points.shape[-1])))
    margin, factor = np.empty(len(poses)), np.zeros(len(poses))
    for k, pose in enumerate(poses):
        vectors = points[k] - pose[:, None]
        structure = vectors / np.linalg.norm(vectors, axis=0)
        margin[k] = hull_margin(vertices @ structure.T)
        if margin[k] >= 0:
            factor[k] = tension_factor(structure, bounds.min, bounds.max)
    return margin, factor


def hull_margin(wrenches: Reals) -> float:
    """Least distance of the origin from a facet of the hull of wrenches (count, 2) [N]."""
    return float(-np.max(ConvexHull(wrenches).equations[:, -1]))


def tension_factor(structure: Reals, low: float, high: float) -> float:
    """TF of the least-norm tensions that exert no wrench with structure (2, n)."""
    dof, cables = structure.shape
    identity = np.eye(cables)
    sides = np.hstack([structure.T, identity, -identity])
    limits = np.concatenate([np.zeros(dof), np.full(cables, low), np.full(cables, -high)])
    tension = quadprog.solve_qp(identity, np.zeros(cables), sides, limits, dof)[0]
    return float(np.min(tension) / np.max(tension))
