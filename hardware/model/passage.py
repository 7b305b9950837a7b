"""Whether the robot passes an access hole along its own axis, foot or head first."""
import numpy as np


def hull(points):
    """Convex hull of 2D points, counterclockwise."""
    points = sorted(map(tuple, np.round(points, 3)))

    def half(ordered):
        found = []
        for point in ordered:
            while len(found) > 1 and np.cross(np.subtract(found[-1], found[-2]), np.subtract(point, found[-2])) <= 0:
                found.pop()
            found.append(point)
        return found[:-1]

    return np.array(half(points) + half(points[::-1]))


def silhouette(robot):
    """The outline along the pan axis, without the tether, at pan 0 and tilt 0."""
    points = [part.mesh.corners.reshape(-1, 3)[:, :2] for part in robot.parts.values() if part.name != 'cables']
    return hull(np.concatenate(points))


def clearance(outline, width, height, turns=36):
    """How much larger, mm all around, the outline could be and still pass an elliptic hole: the best of several
    turns and shifts; negative if it does not pass."""
    semi = np.array([width, height]) / 2
    best = -np.inf
    for angle in np.linspace(0, np.pi, turns, endpoint=False):
        turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        points = outline @ turn.T
        points = points - (points.min(axis=0) + points.max(axis=0)) / 2
        step = 8.0
        shift, here = np.zeros(2), _clearance(points, semi)
        while step > 0.05:
            moves = [shift + step * np.array(d) for d in ((1, 0), (-1, 0), (0, 1), (0, -1))]
            values = [_clearance(points + move, semi) for move in moves]
            if max(values) > here + 1e-9:
                here, shift = max(values), moves[int(np.argmax(values))]
            else:
                step /= 2
        best = max(best, here)
    return best


def _clearance(points, semi):
    """The least distance of the points from the ellipse, estimated along its gradient; negative outside."""
    scaled = points / semi
    radius = np.linalg.norm(scaled, axis=1)
    gradient = np.linalg.norm(points / semi ** 2, axis=1)
    return float(((1 - radius) * radius / np.maximum(gradient, 1e-12)).min())
