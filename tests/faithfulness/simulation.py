"""Runs `rva simulate` and reads what it wrote."""
import json
import pathlib
import subprocess

import cv2
import numpy as np

FOCAL_PX, BASELINE_M = 425.0, 0.050

WALL = '''format: rva-scene
version: 1
solids:
  - {{ name: wall, shape: box, size_mm: [8000, 20, 8000], at_m: [0, {y}, 0.25], turn_deg: [0, 0, {turn}],
      material: {material} }}
{more}light: {{ ambient: 0.0 }}
robot: {{ base: b1, at_m: [0, -0.02, 0], tilt_deg: 0, pan_deg: {pan} }}
'''


def wall_scene(folder, distance_m, material='green-primer', turn_deg=0.0, pan_deg=0.0, more=''):
    """A scene file with a wall ahead, its face at a distance from the camera (which is 20 mm before its foot)."""
    file = pathlib.Path(folder) / f'wall-{distance_m}-{material}-{turn_deg}-{pan_deg}-{len(more)}.yaml'
    file.write_text(WALL.format(y=distance_m + 0.010, turn=turn_deg, material=material, pan=pan_deg, more=more))
    return file


class Capture:
    """A simulated capture in memory: `depth_m` frames x rows x columns, NaN where nothing was measured."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.info = json.loads((self.folder / 'capture.json').read_text())
        unit_m = self.info['depth']['unit_m']
        files = sorted((self.folder / 'depth').glob('*.png'))
        stack = np.stack([cv2.imread(str(file), cv2.IMREAD_UNCHANGED) for file in files])
        self.depth_m = np.where(stack > 0, stack * unit_m, np.nan).astype(np.float64)
        truth = cv2.imread(str(self.folder / 'truth/depth.png'), cv2.IMREAD_UNCHANGED)
        self.true_depth_m = np.where(truth > 0, truth * 1e-4, np.nan)
        self.labels = cv2.imread(str(self.folder / 'truth/labels.png'), cv2.IMREAD_UNCHANGED)
        self.truth = json.loads((self.folder / 'truth/truth.json').read_text())

    @property
    def disparity_px(self):
        return FOCAL_PX * BASELINE_M / self.depth_m

    @property
    def true_disparity_px(self):
        return FOCAL_PX * BASELINE_M / self.true_depth_m

    def infrared(self, side):
        return cv2.imread(str(self.folder / f'infrared/{side}.png'), cv2.IMREAD_UNCHANGED)

    def objects(self, role):
        return [o for o in self.truth['objects'] if o['role'] == role]


def simulate(rva, scene, out, *options, frames=10, seed=1):
    subprocess.run([str(rva), 'simulate', str(scene), '--out', str(out), '--frames', str(frames), '--seed', str(seed),
                    '--overwrite', *map(str, options)], check=True, stdout=subprocess.DEVNULL)
    return Capture(out)
