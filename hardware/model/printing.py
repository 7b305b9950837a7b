"""Whether a part can be printed without support: bed, overhangs, walls."""
import numpy as np

from mesh import Mesh

ON_BED_MM = 0.05


def turned(degrees):
    """The rotation of OpenSCAD's rotate([x, y, z])."""
    x, y, z = np.radians(degrees)
    about_x = [[1, 0, 0], [0, np.cos(x), -np.sin(x)], [0, np.sin(x), np.cos(x)]]
    about_y = [[np.cos(y), 0, np.sin(y)], [0, 1, 0], [-np.sin(y), 0, np.cos(y)]]
    about_z = [[np.cos(z), -np.sin(z), 0], [np.sin(z), np.cos(z), 0], [0, 0, 1]]
    return np.array(about_z) @ about_y @ about_x


def on_bed(mesh, degrees):
    """The mesh as it is printed: turned, its lowest point on z = 0, its middle over the origin."""
    mesh = mesh.moved(turned(degrees))
    low, high = mesh.bounds
    return mesh.moved(np.eye(3), [-(low[0] + high[0]) / 2, -(low[1] + high[1]) / 2, -low[2]])


def bed_area(mesh):
    """Area that lies on the bed, mm2."""
    flat = (mesh.corners[:, :, 2].max(axis=1) < ON_BED_MM) & (mesh.normals[:, 2] < -0.99)
    return np.linalg.norm(mesh.area_vectors[flat], axis=1).sum()


def overhangs(mesh, overhang_deg, bridge_mm):
    """Places that need support: facets that face down more than `overhang_deg` from vertical, neither on the bed
    nor between two supported edges that are at most `bridge_mm` apart. A list of their centres."""
    normals, height = mesh.normals, mesh.corners[:, :, 2].max(axis=1)
    steep = (normals[:, 2] < -np.sin(np.radians(overhang_deg + 1))) & (height > ON_BED_MM)
    if not steep.any():
        return []
    _, triangles = mesh.indexed()
    owner = {}
    for index, (a, b, c) in enumerate(triangles):
        owner.update({(a, b): index, (b, c): index, (c, a): index})
    supported = []
    for index in np.flatnonzero(steep):
        for k in range(3):
            a, b = triangles[index][k], triangles[index][(k + 1) % 3]
            other = owner.get((b, a))
            if other is None or steep[other]:
                continue
            start, end = mesh.corners[index][k], mesh.corners[index][(k + 1) % 3]
            if mesh.corners[other][:, 2].min() < min(start[2], end[2]) - 1e-3:
                steps = max(2, int(np.linalg.norm(end - start) / 0.5))
                supported.append(start + np.linspace(0, 1, steps)[:, None] * (end - start))
    supported = np.concatenate(supported) if supported else np.empty((0, 3))
    points, _ = Mesh(mesh.corners[steep]).samples(2.0)
    return [point for point in points if _span(point, supported) > bridge_mm]


def _span(point, supported):
    """The shortest distance, along a horizontal line through the point, between two supports of its height."""
    near = supported[np.abs(supported[:, 2] - point[2]) < 2.0][:, :2] - point[:2]
    if len(near) == 0:
        return np.inf
    shortest = np.inf
    for angle in np.radians(np.arange(0, 180, 15)):
        along, across = near @ [np.cos(angle), np.sin(angle)], near @ [-np.sin(angle), np.cos(angle)]
        along = along[np.abs(across) < 0.6]
        ahead, behind = along[along >= -0.1], along[along <= 0.1]
        if len(ahead) and len(behind):
            shortest = min(shortest, ahead.min() - behind.max())
    return shortest


def thinnest(mesh, limit, spacing=4.0):
    """The least thickness of the walls, mm, and where it is; infinite where all are thicker than the limit."""
    mesh = Mesh(mesh.corners[np.linalg.norm(mesh.area_vectors, axis=1) > 1e-3])
    points, owners = mesh.samples(spacing)
    centres = mesh.corners.mean(axis=1)
    points, owners = np.concatenate([points, centres]), np.concatenate([owners, np.arange(len(centres))])
    towards = centres[owners] - points  # a ray that starts on an edge could run along the adjacent facet
    length = np.linalg.norm(towards, axis=1, keepdims=True)
    points = points + towards * np.minimum(0.5, 0.05 / np.maximum(length, 1e-9))
    normals = mesh.normals[owners]
    thickness = mesh.thickness(points - 1e-3 * normals, -normals, limit)
    return thickness.min() + 1e-3, points[thickness.argmin()]
