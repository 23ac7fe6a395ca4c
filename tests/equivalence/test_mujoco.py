"""MuJoCo's tendons are a third opinion on cable lengths and their derivatives.

Cables are spatial tendons through sites; bases slide on joints. MuJoCo takes a tendon whose site
lies on a wrapping cylinder straight through it (google-deepmind/mujoco#2580), so a pulley's cable
begins one `LEAD` before its first contact, outside the cylinder, and where MuJoCo wraps it all the
way from there to the platform, its length is ours and the lead.
"""

import math
from dataclasses import replace
from functools import cache
from typing import Any

import mujoco
import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation
from unmeasured import EVERY_KIND, compiled, geometry, machine_named

from turnbuckle.codegen.bind import Generated
from turnbuckle.model.machine import Machine

Doubles = NDArray[np.float64]
POSES = 200
#: Both sides round in double precision, over distances of the order of a metre.
SLACK = 1e-12
LEAD = 0.2


def in_space(vector: Any) -> Doubles:
    """A planar vector with a third entry."""
    return np.pad(np.asarray(vector, float), (0, 3 - len(vector)))


def text(vector: Any) -> str:
    return " ".join(repr(float(x)) for x in in_space(vector))


def platform(machine: Machine) -> str:
    """A body with the joints of the kind, and a site at every anchor."""
    axes = np.eye(3)[: machine.space]
    joints = [f'<joint type="slide" axis="{text(axis)}"/>' for axis in axes]
    if machine.is_rigid:
        turn = 'type="hinge" axis="0 0 1"' if machine.space == 2 else 'type="ball"'
        joints.append(f"<joint {turn}/>")
    sites = [f'<site name="anchor{i}" pos="{text(p)}"/>' for i, p in enumerate(machine.anchors)]
    return f"<body>{''.join(joints)}{INERTIA}{''.join(sites)}</body>"


INERTIA = '<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>'


def base(machine: Machine, i: int) -> str:
    """The base of a cable: a body that slides, where it moves."""
    motion = machine.base_motions[i]
    joints = [
        f'<joint name="cable{i}rail{k}" type="slide" axis="{text(e)}"/>' for k, e in motion.travel
    ]
    inertia = INERTIA if joints else ""
    held = f'<site name="base{i}"/>{wheel(machine, i)}'
    return f'<body pos="{text(motion.start)}">{"".join(joints)}{inertia}{held}</body>'


def wheel(machine: Machine, i: int) -> str:
    """A planar pulley: a cylinder, the site where the cable comes from, the side it takes."""
    pulley = machine.pulleys[i]
    if pulley is None:
        return ""
    contact = np.asarray(pulley.contact)
    forward = pulley.winds * np.array([-contact[1], contact[0]])
    begin = pulley.radius * contact - LEAD * forward
    side = 3 * pulley.radius * (contact + forward)
    return (
        f'<geom name="wheel{i}" type="cylinder" size="{pulley.radius!r} 0.01" mass="0"/>'
        f'<site name="begin{i}" pos="{text(begin)}"/><site name="side{i}" pos="{text(side)}"/>'
    )


def tendon(machine: Machine, i: int) -> str:
    """A cable from its anchor to its base, or around its pulley to where it comes from."""
    if machine.pulleys[i] is None:
        path = f'<site site="base{i}"/>'
    else:
        path = f'<geom geom="wheel{i}" sidesite="side{i}"/><site site="begin{i}"/>'
    return f'<spatial><site site="anchor{i}"/>{path}</spatial>'


class Twin:
    """A machine in MuJoCo."""

    def __init__(self, machine: Machine) -> None:
        numbers = range(len(machine.cables))
        bodies = platform(machine) + "".join(base(machine, i) for i in numbers)
        cables = "".join(tendon(machine, i) for i in numbers)
        self.machine = machine
        self.model = mujoco.MjModel.from_xml_string(
            f"<mujoco><worldbody>{bodies}</worldbody><tendon>{cables}</tendon></mujoco>"
        )
        self.data = mujoco.MjData(self.model)

    def place(self, pose: Doubles, rails: Doubles) -> None:
        """Move platform and bases."""
        space, qpos = self.machine.space, self.data.qpos
        qpos[:space] = pose[:space]
        if self.machine.is_rigid and space == 2:
            qpos[2] = pose[2]
        elif self.machine.is_rigid:
            qpos[3:7] = Rotation.from_rotvec(pose[3:]).as_quat(scalar_first=True)
        for _, k, joint in self.rail_joints():
            qpos[self.model.jnt_qposadr[joint]] = rails[k]
        mujoco.mj_fwdPosition(self.model, self.data)

    def rail_joints(self) -> list[tuple[int, int, int]]:
        """Cable, rail coordinate and joint of every sliding base."""
        return [
            (i, k, self.model.joint(f"cable{i}rail{k}").id)
            for i, motion in enumerate(self.machine.base_motions)
            for k, _ in motion.travel
        ]

    def lengths(self) -> Doubles:
        """Cable lengths [m] (n)."""
        leads = [LEAD if pulley else 0.0 for pulley in self.machine.pulleys]
        return np.asarray(self.data.ten_length - leads)

    def moment_arms(self) -> Doubles:
        """Derivatives of the tendons by all joint velocities (n, nv)."""
        rows = np.zeros((self.model.ntendon, self.model.nv))
        for i in range(self.model.ntendon):
            begin, count = self.model.ten_J_rowadr[i], self.model.ten_J_rownnz[i]
            entries = slice(begin, begin + count)
            rows[i, self.model.ten_J_colind[entries]] = self.data.ten_J[entries]
        return rows

    def jacobians(self, pose: Doubles) -> tuple[Doubles, Doubles]:
        """dl/dx by the twist in the fixed frame (n, d), dl/ds (n, m)."""
        arms, machine = self.moment_arms(), self.machine
        by_pose = arms[:, : machine.dof]
        if machine.dof == 6:
            # a ball joint turns in the frame of its body
            rotation = Rotation.from_rotvec(pose[3:]).as_matrix()
            by_pose = np.hstack([by_pose[:, :3], by_pose[:, 3:] @ rotation.T])
        by_rails = np.zeros((len(machine.cables), len(machine.rails)))
        for i, k, joint in self.rail_joints():
            by_rails[i, k] += arms[i, self.model.jnt_dofadr[joint]]
        return by_pose, by_rails

    def wrapped(self) -> NDArray[np.bool_]:
        """Where the tendon touches its cylinder (n)."""
        return np.asarray(self.data.ten_wrapnum > 2)


def straightened(machine: Machine) -> Machine:
    """The machine with points in place of pulleys."""
    cables = tuple(cable.model_copy(update={"pulley": None}) for cable in machine.cables)
    return machine.model_copy(update={"pulley": None, "cables": cables})


@cache
def straight(name: str) -> tuple[Twin, Generated]:
    """A machine with straight cables, in MuJoCo and in C."""
    machine = straightened(machine_named(name))
    return Twin(machine), compiled(machine)


def drawn(machine: Machine, seed: int) -> tuple[Doubles, Doubles]:
    """Poses of the frame's inner part, and rail coordinates."""
    random = np.random.default_rng(seed)
    position = (0.1 + 0.8 * random.random((POSES, machine.space))) * machine.frame.size
    angles = random.uniform(-1, 1, (POSES, machine.dof - machine.space)) * machine.rotation
    pose = np.hstack([position, angles / math.sqrt(max(1, angles.shape[1]))])
    rails = random.random((POSES, len(machine.rails))) * [rail.length for rail in machine.rails]
    return pose, rails


@pytest.mark.parametrize("name", ["yoon2023", *EVERY_KIND])
def test_straight_cables_are_mujocos_tendons(name: str) -> None:
    twin, generated = straight(name)
    pose, rails = drawn(twin.machine, 101)
    lengths = np.asarray(generated.cable_lengths(pose, rails))
    by_pose = np.asarray(generated.length_jacobian(pose, rails))
    by_rails = np.asarray(generated.rail_jacobian(pose, rails))
    for k in range(POSES):
        twin.place(pose[k], rails[k])
        theirs = twin.jacobians(pose[k])
        assert np.allclose(lengths[k], twin.lengths(), rtol=0, atol=SLACK)
        assert np.allclose(by_pose[k], theirs[0], rtol=0, atol=SLACK)
        assert np.allclose(by_rails[k], theirs[1], rtol=0, atol=SLACK)


def furthest_apart(twin: Twin, generated: Generated) -> tuple[float, NDArray[np.intp]]:
    """Largest difference where MuJoCo's tendons wrap, and how often each does (n)."""
    pose, rails = drawn(generated.machine, 102)
    lengths = np.asarray(generated.cable_lengths(pose, rails))
    by_pose = np.asarray(generated.length_jacobian(pose, rails))
    by_rails = np.asarray(generated.rail_jacobian(pose, rails))
    apart, compared = 0.0, np.zeros(len(generated.machine.cables), dtype=int)
    for k in range(POSES):
        twin.place(pose[k], rails[k])
        touching, theirs = twin.wrapped(), twin.jacobians(pose[k])
        compared += touching
        pairs = [(lengths[k], twin.lengths()), (by_pose[k], theirs[0]), (by_rails[k], theirs[1])]
        apart = max(apart, *(float(np.max(np.abs(a - b)[touching])) for a, b in pairs))
    return apart, compared


def test_cables_over_planar_pulleys_are_mujocos_wrapped_tendons() -> None:
    generated = geometry("kinematics_planar_pulleys")
    apart, compared = furthest_apart(Twin(generated.machine), generated)
    assert apart < SLACK
    assert np.all(compared > POSES / 2)


def test_a_pulley_wound_the_other_way_is_not_mujocos(monkeypatch: pytest.MonkeyPatch) -> None:
    generated = geometry("kinematics_planar_pulleys")
    first, *rest = generated.machine.pulleys
    assert first is not None
    monkeypatch.setattr(Machine, "pulleys", (replace(first, winds=-first.winds), *rest))
    apart, _ = furthest_apart(Twin(generated.machine), generated)
    assert apart > 1e-3
