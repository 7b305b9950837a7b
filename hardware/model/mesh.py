"""Triangle meshes: STL files, soundness, volume, points inside, thickness."""
import functools
import pathlib

import numpy as np

ROTATION = np.linalg.qr(np.random.default_rng(7).normal(size=(3, 3)))[0]  # rays along no edge of a part


class Mesh:
    """Triangles in millimetres: `corners` is N x 3 x 3."""

    def __init__(self, corners):
        self.corners = np.asarray(corners, float)
        self._columns = None

    @property
    def edges(self):
        return np.roll(self.corners, -1, axis=1) - self.corners

    @property
    def area_vectors(self):
        a, b, c = self.corners[:, 0], self.corners[:, 1], self.corners[:, 2]
        return np.cross(b - a, c - a) / 2

    @property
    def normals(self):
        areas = self.area_vectors
        return areas / np.maximum(np.linalg.norm(areas, axis=1, keepdims=True), 1e-12)

    @property
    def heights(self):
        """Of each triangle above its longest edge."""
        return 2 * np.linalg.norm(self.area_vectors, axis=1) / np.maximum(np.linalg.norm(self.edges, axis=2).max(axis=1), 1e-12)

    @functools.cached_property
    def bounds(self):
        points = self.corners.reshape(-1, 3)
        return points.min(axis=0), points.max(axis=0)

    @property
    def volume(self):
        a, b, c = self.corners[:, 0], self.corners[:, 1], self.corners[:, 2]
        return np.einsum('ij,ij->i', a, np.cross(b, c)).sum() / 6

    @property
    def second_moment(self):
        """The integral of x x' over the volume, mm5."""
        a, b, c = self.corners[:, 0], self.corners[:, 1], self.corners[:, 2]
        signed = np.einsum('ij,ij->i', a, np.cross(b, c)) / 6
        total = a + b + c
        return sum(np.einsum('i,ij,ik->jk', signed, v, v) for v in (a, b, c, total)) / 20

    @property
    def centroid(self):
        a, b, c = self.corners[:, 0], self.corners[:, 1], self.corners[:, 2]
        signed = np.einsum('ij,ij->i', a, np.cross(b, c)) / 6
        return ((a + b + c) / 4 * signed[:, None]).sum(axis=0) / signed.sum()

    def moved(self, rotation, translation=(0, 0, 0)):
        return Mesh(self.corners @ np.asarray(rotation).T + np.asarray(translation))

    def indexed(self):
        """Vertices, with those that coincide to a micrometre joined, and three indices for each triangle."""
        keys = np.round(self.corners.reshape(-1, 3) * 1000).astype(np.int64)
        _, first, inverse = np.unique(keys, axis=0, return_index=True, return_inverse=True)
        return self.corners.reshape(-1, 3)[first], inverse.reshape(-1, 3)

    def faults(self):
        """Why this mesh is not the surface of a solid; empty if it is."""
        found, (_, triangles) = [], self.indexed()
        if len(triangles) == 0:
            return ['no triangles']
        if (triangles == np.roll(triangles, 1, axis=1)).any():
            found.append('a triangle without area')
        edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
        directed, uses = np.unique(edges, axis=0, return_counts=True)
        if (uses > 1).any():
            found.append(f'{(uses > 1).sum()} edges are used twice in one direction')
        there = {tuple(edge) for edge in directed}
        if open_edges := sum((b, a) not in there for a, b in there):
            found.append(f'{open_edges} edges belong to one triangle only')
        if self.volume <= 0:
            found.append('the volume is not positive')
        return found

    def samples(self, spacing):
        """Points on the surface, about `spacing` apart, edges included, and the triangle of each."""
        longest = np.linalg.norm(self.edges, axis=2).max(axis=1)
        steps = np.maximum(1, np.ceil(longest / spacing)).astype(int)
        points, owners = [], []
        for step in np.unique(steps):
            chosen = np.flatnonzero(steps == step)
            corner = self.corners[chosen]
            i, j = np.meshgrid(np.arange(step + 1), np.arange(step + 1))
            i, j = i[i + j <= step] / step, j[i + j <= step] / step
            points.append((corner[:, None, 0] + i[None, :, None] * (corner[:, 1] - corner[:, 0])[:, None]
                           + j[None, :, None] * (corner[:, 2] - corner[:, 0])[:, None]).reshape(-1, 3))
            owners.append(np.repeat(chosen, len(i)))
        points, owners = np.concatenate(points), np.concatenate(owners)
        cells = np.round(np.concatenate([points / (spacing / 2), self.normals[owners] * 2], axis=1)).astype(np.int64)
        _, first = np.unique(cells, axis=0, return_index=True)
        return points[first], owners[first]

    def contains(self, points):
        """For each point whether it is inside: the parity of the triangles above it, in a turned frame."""
        if self._columns is None:
            self._columns = _Columns(self.corners @ ROTATION.T)
        return self._columns.odd_above(np.asarray(points) @ ROTATION.T)

    def thickness(self, points, rays, limit):
        """Distance from points along their rays to the surface, infinite beyond the limit."""
        low, high = self.bounds
        size = 2 * limit
        cells = np.maximum(1, np.ceil((high - low) / size)).astype(int)
        grid = _Grid(self.corners.min(axis=1) - limit, self.corners.max(axis=1) + limit, low, np.full(3, size), cells)
        which, triangles = grid.pairs(points)
        a, b, c = (self.corners[triangles, i] for i in range(3))
        ray, e1, e2, t = rays[which], b - a, c - a, points[which] - a
        p, q = np.cross(ray, e2), np.cross(t, e1)
        det = np.einsum('ij,ij->i', p, e1)
        with np.errstate(divide='ignore', invalid='ignore'):
            u, v = np.einsum('ij,ij->i', t, p) / det, np.einsum('ij,ij->i', ray, q) / det
            distance = np.einsum('ij,ij->i', e2, q) / det
            hit = (np.abs(det) > 1e-9) & (u >= 0) & (v >= 0) & (u + v <= 1) & (distance > 0) & (distance < limit)
        found = np.full(len(points), np.inf)
        np.minimum.at(found, which[hit], distance[hit])
        return found


class _Grid:
    """Boxes sorted into the cells of a grid of two or three dimensions."""

    def __init__(self, low, high, origin, size, cells):
        self.origin, self.size, self.cells = origin, size, np.asarray(cells)
        first, last = self._cell(low), self._cell(high)
        counts = (last - first + 1).prod(axis=1)
        boxes = np.repeat(np.arange(len(low)), counts)
        offset = np.arange(len(boxes)) - np.repeat(np.cumsum(counts) - counts, counts)
        index = np.zeros(len(boxes), int)
        for axis in range(len(self.cells)):
            extent = (last - first + 1)[boxes, axis]
            index = index * self.cells[axis] + first[boxes, axis] + offset % extent
            offset //= extent
        self.boxes = boxes[np.argsort(index, kind='stable')]
        self.counts = np.bincount(index, minlength=self.cells.prod())
        self.starts = np.cumsum(self.counts) - self.counts

    def _cell(self, points):
        return np.clip(np.floor((points - self.origin) / self.size).astype(int), 0, self.cells - 1)

    def pairs(self, points):
        """Indices of points and of boxes that may contain them."""
        cell = np.zeros(len(points), int)
        for axis, column in enumerate(self._cell(points).T):
            cell = cell * self.cells[axis] + column
        counts = self.counts[cell]
        which = np.repeat(np.arange(len(points)), counts)
        offset = np.arange(len(which)) - np.repeat(np.cumsum(counts) - counts, counts)
        return which, self.boxes[self.starts[cell][which] + offset]


class _Columns:
    """Triangles sorted by x and y."""

    def __init__(self, corners, cells=48):
        self.corners = corners
        low, high = corners[:, :, :2].min(axis=1), corners[:, :, :2].max(axis=1)
        size = (high.max(axis=0) - low.min(axis=0)) / cells * (1 + 1e-9) + 1e-12
        self.grid = _Grid(low, high, low.min(axis=0), size, [cells, cells])

    def odd_above(self, points):
        which, triangles = self.grid.pairs(points[:, :2])
        corners = self.corners[triangles]
        x, y = points[which, 0], points[which, 1]
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (corners[:, i].T for i in range(3))
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        with np.errstate(divide='ignore', invalid='ignore'):
            v = ((x - ax) * (cy - ay) - (y - ay) * (cx - ax)) / area
            w = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / area
            z = az + v * (bz - az) + w * (cz - az)
            above = (v >= 0) & (w >= 0) & (v + w <= 1) & (z > points[which, 2])
        return np.bincount(which[above], minlength=len(points)) % 2 == 1


def read_stl(path):
    """A binary STL file, or a text one."""
    data = pathlib.Path(path).read_bytes()
    if data[:5] == b'solid' and b'facet' in data[:300]:
        rows = [line.split()[1:] for line in data.decode().splitlines() if line.strip().startswith('vertex')]
        return Mesh(np.array(rows, float).reshape(-1, 3, 3))
    record = np.dtype([('normal', '<f4', 3), ('corners', '<f4', (3, 3)), ('attribute', '<u2')])
    return Mesh(np.frombuffer(data[84:], record)['corners'])


def write_stl(path, mesh):
    record = np.zeros(len(mesh.corners), np.dtype([('normal', '<f4', 3), ('corners', '<f4', (3, 3)), ('attribute', '<u2')]))
    record['normal'], record['corners'] = mesh.normals, mesh.corners
    pathlib.Path(path).write_bytes(bytes(80) + np.uint32(len(record)).tobytes() + record.tobytes())


def box(low, high):
    """A box between two corners."""
    low, high = np.asarray(low, float), np.asarray(high, float)
    corner = np.array([[low, high][i >> k & 1][k] for i in range(8) for k in range(3)]).reshape(8, 3)
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return Mesh([corner[[a, b, c]] for a, b, c, _ in quads] + [corner[[a, c, d]] for a, _, c, d in quads])
