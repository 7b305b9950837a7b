"""Findings as rva_simulated_findings and `rva export-crops` write them."""
import json
import pathlib

import numpy as np

PLANES, PLANE_PX = 14, 48
RED, GREEN, BLUE, COLOR, INFRARED = range(5)
CLASSES = json.loads((pathlib.Path(__file__).parent / 'classes.json').read_text())
LABELS = list(CLASSES)
CLASS_OF = {kind: label for label, kinds in CLASSES.items() for kind in kinds}


class Findings:
    """Planes of N findings (N x 14 x 48 x 48, 16-bit floats), and for each what it is."""

    def __init__(self, folders):
        parts, self.described = [], []
        for folder in map(pathlib.Path, folders):
            content = json.loads((folder / 'findings.json').read_text())
            run = content['run']
            if (run['planes'], run['plane_px']) != (PLANES, PLANE_PX):
                raise SystemExit(f'{folder}: its findings have {run["planes"]} planes of {run["plane_px"]} pixels, not '
                                 f'{PLANES} of {PLANE_PX}: simulate them again')
            found = content['findings']
            planes = np.memmap(folder / 'planes.f16', dtype=np.float16, mode='r')
            parts.append(planes[:len(found) * PLANES * PLANE_PX ** 2].reshape(len(found), PLANES, PLANE_PX, PLANE_PX))
            self.described += found
        self.planes = np.concatenate(parts)
        self.labels = np.array([self.number_of(one['kind']) for one in self.described])
        self.lit = self.planes[:, COLOR, 0, 0] > 0.5

    @staticmethod
    def number_of(kind):
        """The number of a kind's class, or of a class itself; the last one for false findings and other objects."""
        label = CLASS_OF.get(kind, kind)
        return LABELS.index(label) if label in LABELS else len(LABELS)

    def __len__(self):
        return len(self.labels)
