"""The robot as OpenSCAD exports it: parts with their meshes, screws, kinematic chain, dimensions."""
import concurrent.futures
import hashlib
import json
import pathlib
import re
import shutil
import subprocess
import tempfile

import numpy as np

from mesh import read_stl
from printing import turned

HARDWARE = pathlib.Path(__file__).resolve().parent.parent
CAMERAS = ('D435', 'D435i', 'D405', 'D455')
SAME_BODY = {'D435i': 'D435'}
DIMENSION = re.compile(r'^(\w+) = ([^;]+);\s*//\s*(\S.*)$')


class Part:
    def __init__(self, name, group, kind, print_turn):
        self.name, self.group, self.kind, self.print_turn = name, group, kind, print_turn
        self.mesh = None


class Screw:
    """`at` is where the head bears (its top, if it is sunk), `away` the direction of its head."""

    def __init__(self, name, thread_mm, length_mm, sunk, at, away):
        self.name, self.thread_mm, self.length_mm, self.sunk = name, thread_mm, length_mm, sunk
        self.at, self.away = np.array(at, float), np.array(away, float)


class Robot:
    def __init__(self, camera='D435'):
        self.camera = camera
        self.parts, self.screws, self.chain_mm = {}, [], None
        for key, value in listed(camera):
            if key == 'part':
                self.parts[value[0]] = Part(*value)
            elif key == 'screw':
                self.screws.append(Screw(*value))
            else:
                self.chain_mm = value

    def load(self, folder):
        for part in self.parts.values():
            part.mesh = read_stl(pathlib.Path(folder) / f'{part.name}.stl')
        return self

    def named(self, kind=None, group=None):
        return [part for part in self.parts.values() if kind in (None, part.kind) and group in (None, part.group)]

    @property
    def tilt_axis(self):
        return np.array([0, 0, self.chain_mm[0] + self.chain_mm[1]])

    def pose(self, group, pan_deg, tilt_deg):
        """Rotation and translation of a group from pan 0, tilt 0."""
        if group == 'fixed':
            return np.eye(3), np.zeros(3)
        pan = turned([0, 0, pan_deg])
        if group == 'pan':
            return pan, np.zeros(3)
        tilt = turned([tilt_deg, 0, 0])
        return pan @ tilt, pan @ (self.tilt_axis - tilt @ self.tilt_axis)

    def geometry(self):
        """The settings file of docs/mapping.md, in metres."""
        servo1, bracket, x, y, z = (round(value / 1000, 6) for value in self.chain_mm)
        return {'format': 'rva-robot-geometry', 'version': 1,
                'servo1': {'at_m': [0.0, 0.0, servo1], 'axis': [0, 0, 1]},
                'bracket': {'at_m': [0.0, 0.0, bracket], 'axis': [1, 0, 0]},
                'camera': {'at_m': [x, y, z], 'right': [1, 0, 0], 'down': [0, 0, -1], 'forward': [0, 1, 0]}}


def openscad():
    return shutil.which('openscad')


def run(file, out, settings, *flags):
    """Runs OpenSCAD; its warnings are errors."""
    values = [f'-D{name}={json.dumps(value)}' for name, value in settings.items()]
    command = [openscad(), '-o', str(out), *flags, *values, str(HARDWARE / file)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=1800, check=False)
    if done.returncode or 'WARNING' in done.stderr:
        raise RuntimeError(f'{" ".join(command)}\n{done.stderr}')


def listed(camera):
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / 'list.echo'
        run('robot.scad', out, {'part': 'list', 'camera': camera})
        rows = re.findall(r'^ECHO: (\w+) = (.*)$', out.read_text(), re.MULTILINE)
    return [(key, json.loads(value.replace('undef', 'null'))) for key, value in rows]


def export(robot, folder, jobs=2):
    """Writes each part as a binary STL file, in the robot's frame at pan 0 and tilt 0, and loads them. Parts that are
    there already, made from the same sources, remain."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    sources = hashlib.sha256(b''.join(path.read_bytes() for path in sorted(HARDWARE.glob('*.scad')) if path.name != 'view.scad'))
    stamp = folder / 'sources.txt'
    text = f'{robot.camera} {sources.hexdigest()}\n'
    if not stamp.exists() or stamp.read_text() != text:
        for old in folder.glob('*.stl'):
            old.unlink()
        stamp.write_text(text)

    def write(name):
        out = folder / f'{name}.stl'
        if not out.exists():
            new = folder / f'{name}.new.stl'
            run('robot.scad', new, {'part': name, 'camera': robot.camera}, '--export-format', 'binstl')
            new.replace(out)

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        list(pool.map(write, robot.parts))
    return robot.load(folder)


def dimensions():
    """Name, value and source of each dimension; lists are tuples."""
    found = {}
    for number, line in enumerate((HARDWARE / 'dimensions.scad').read_text().splitlines(), 1):
        if not line or line.startswith(('//', 'camera = ')):
            continue
        match = DIMENSION.match(line)
        if not match:
            raise ValueError(f'dimensions.scad:{number}: no "name = value;  // source"')
        value = json.loads(match[2])
        found[match[1]] = (tuple(value) if isinstance(value, list) else value, match[3])
    return found
