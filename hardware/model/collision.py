"""Whether parts of the robot overlap, at rest and over the range of both joints; screws in their holes."""
import numpy as np

from mesh import Mesh
from printing import turned

INSET_MM = 0.15  # parts may touch, and faceted cylinders lie this much inside round ones
SPACING_MM = 4.0
SLIVER_MM = 0.001  # triangles of less height, left by the export


class Samples:
    """Points just below the surface of a part."""

    def __init__(self, mesh, spacing=SPACING_MM):
        # The direction of a sliver is not known: a point below it may lie on the surface.
        broad = Mesh(mesh.corners[mesh.heights > SLIVER_MM])
        points, owners = broad.samples(spacing)
        centres = broad.corners.mean(axis=1)[owners]
        # Away from edges, where two facets meet that the point must both be below.
        points = points + (centres - points) * np.minimum(
            0.5, 2 * INSET_MM / np.maximum(np.linalg.norm(centres - points, axis=1, keepdims=True), 1e-9))
        self.points = points - INSET_MM * broad.normals[owners]
        self.points = self.points[mesh.contains(self.points)]


def overlap(one, other, samples_of_one, samples_of_other, pose=None):
    """A point of both meshes, None if none was found. `pose`: rotation and translation of `one` to `other`."""
    rotation, translation = pose or (np.eye(3), np.zeros(3))
    (low, high), (other_low, other_high) = one.bounds, other.bounds
    middle, half = rotation @ ((low + high) / 2) + translation, np.abs(rotation) @ ((high - low) / 2)
    if (middle + half < other_low).any() or (middle - half > other_high).any():
        return None
    for mesh, points in ((other, samples_of_one.points @ rotation.T + translation),
                         (one, (samples_of_other.points - translation) @ rotation)):
        low, high = mesh.bounds
        near = points[((points >= low) & (points <= high)).all(axis=1)]
        if len(near) and (inside := mesh.contains(near)).any():
            return near[inside][0]
    return None


def relative(pose, other):
    """The pose of a group in the frame of another, given both in the robot's frame."""
    (rotation, translation), (other_rotation, other_translation) = pose, other
    return other_rotation.T @ rotation, other_rotation.T @ (translation - other_translation)


class Clashes:
    def __init__(self, robot):
        self.robot = robot
        self.samples = {name: Samples(part.mesh) for name, part in robot.parts.items()}

    def between(self, one, other, pose=None):
        return overlap(one.mesh, other.mesh, self.samples[one.name], self.samples[other.name], pose)

    def at_rest(self):
        """All pairs of parts that overlap at pan 0, tilt 0."""
        parts = list(self.robot.parts.values())
        return [(one.name, other.name) for i, one in enumerate(parts) for other in parts[i + 1:]
                if self.between(one, other) is not None]

    def at(self, pan_deg, tilt_deg):
        """Pairs of parts of different groups that overlap at a pose; also what is below the ground."""
        poses = {group: self.robot.pose(group, pan_deg, tilt_deg) for group in ('fixed', 'pan', 'tilt')}
        found = []
        for group, other_group in (('tilt', 'pan'), ('tilt', 'fixed'), ('pan', 'fixed')):
            pose = relative(poses[group], poses[other_group])
            found += [(one.name, other.name) for one in self.robot.named(group=group)
                      for other in self.robot.named(group=other_group) if self.between(one, other, pose) is not None]
        return found

    def range_of(self, joint, step_deg, limit_deg=180):
        """The angles around 0, in steps, between which the joint is free while the other is at 0."""
        ends = []
        for sign in (-1, 1):
            free = 0
            while abs(free) < limit_deg:
                joints = {'pan_deg': 0, 'tilt_deg': 0, joint: free + sign * step_deg}
                if self.at(**joints):
                    break
                free += sign * step_deg
            ends.append(free)
        return tuple(ends)


def _across(away):
    """Two directions across a screw's axis."""
    first = np.cross(away, [1.0, 0, 0] if abs(away[0]) < 0.5 else [0, 1.0, 0])
    return first, np.cross(away, first)


def cylinder_points(at, away, radius, start, end):
    """Points on a cylinder about a screw's axis; start and end are along the direction of the head."""
    first, second = _across(away)
    angles = np.radians(np.arange(0, 360, 15))
    ring = radius * (np.cos(angles)[:, None] * first + np.sin(angles)[:, None] * second)
    along = np.arange(start, end, 0.5 if end > start else -0.5)
    return (at + along[:, None, None] * away + ring).reshape(-1, 3)


def screw_fits(screw, parts):
    """What the shank would cut (names), and the parts that it joins: those that surround it."""
    reach = 0.6 * screw.thread_mm if screw.sunk else 0.0
    shank = cylinder_points(screw.at, screw.away, screw.thread_mm / 2, -screw.length_mm, -reach)
    around = cylinder_points(screw.at, screw.away, screw.thread_mm / 2 + 1.3, -screw.length_mm, 0)
    cut = [part.name for part in parts if part.mesh.contains(shank).any()]
    joined = [part.name for part in parts if part.mesh.contains(around).mean() * screw.length_mm > 1.0]
    return cut, joined


def blocked_driver(screw, parts, diameter, length):
    """The parts that are in the way of a screwdriver."""
    start = 0.3 if screw.sunk else screw.thread_mm + 0.3
    points = np.concatenate([cylinder_points(screw.at, screw.away, radius, start, length)
                             for radius in (0.0, diameter / 4, diameter / 2 - 0.1)])
    return [part.name for part in parts if part.mesh.contains(points).any()]


def first_self_view(robot, field_deg, lowest_deg=-90):
    """The tilt, to a degree, below which the depth image shows the robot itself."""
    low, high = lowest_deg, 0
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if self_view(robot, field_deg, middle) > 0 else (low, middle)
    return high


def self_view(robot, field_deg, tilt_deg, grid=(13, 9)):
    """The share of the depth image's rays that meet the robot itself at a tilt."""
    horizontal, vertical = (np.tan(np.radians(value / 2)) for value in field_deg)
    u, v = np.meshgrid(np.linspace(-horizontal, horizontal, grid[0]), np.linspace(-vertical, vertical, grid[1]))
    rays = np.stack([u.ravel(), np.ones(u.size), -v.ravel()], axis=1)
    rotation = turned([tilt_deg, 0, 0])
    origin = robot.tilt_axis + rotation @ np.array(robot.chain_mm[2:])
    steps = np.arange(8.0, 350.0, 3.0)
    points = (origin + steps[:, None, None] * (rays @ rotation.T)).reshape(-1, 3)
    hit = np.zeros(len(points), bool)
    for part in robot.parts.values():
        if part.group != 'tilt':
            hit |= part.mesh.contains(points)
    return hit.reshape(len(steps), -1).any(axis=0).mean()
