"""The thesis' experiments on simulated captures: what its methods find, and what they find that is not there."""
import json
import pathlib
import subprocess

import cv2
import numpy as np

# Where the depth image lies inside the colour image's view: the thesis counts false positives there only.
COLOR_ROWS, COLOR_COLUMNS = slice(74, 406), slice(132, 716)
# Edges of depth are this ragged, and a shadow of the projector lies beside each object: changed pixels this near
# to an object are its own.
NEAR_PX = 12
FOUND_SHARE = 0.1  # of an object's visible pixels: less would be a stray pixel beside it
SEEN_PX = 5  # fewer visible pixels than this are hidden, not missed


def detect(rva, initial, final, out, *options):
    subprocess.run([str(rva), 'detect', str(initial), str(final), '--out', str(out), '--overwrite', *map(str, options)],
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return Result(out, final)


class Result:
    """Findings held against the truth of the final capture."""

    def __init__(self, out, final):
        out, final = pathlib.Path(out), pathlib.Path(final)
        self.json = json.loads((out / 'detections.json').read_text())
        changes = cv2.imread(str(out / 'changes.png'), cv2.IMREAD_UNCHANGED) > 0
        labels = cv2.imread(str(final / 'truth/labels.png'), cv2.IMREAD_UNCHANGED)
        truth = json.loads((final / 'truth/truth.json').read_text())
        self.found, debris = {}, np.zeros(labels.shape, np.uint8)
        for thing in truth['objects']:
            if thing['role'] != 'debris' or thing['visible_px'] < SEEN_PX:
                continue
            mask = (labels == thing['label']).astype(np.uint8)
            debris |= mask
            around = cv2.dilate(mask, np.ones((3, 3), np.uint8)) > 0
            self.found[thing['name']] = int((changes & around).sum()) >= max(2, FOUND_SHARE * thing['visible_px'])
        near = cv2.dilate(debris, np.ones((2 * NEAR_PX + 1, 2 * NEAR_PX + 1), np.uint8)) > 0
        self.false_sizes_px = []
        _, components, stats, _ = cv2.connectedComponentsWithStats(
            (changes & ~near).astype(np.uint8)[COLOR_ROWS, COLOR_COLUMNS], connectivity=8)
        self.false_sizes_px = sorted(int(s) for s in stats[1:, cv2.CC_STAT_AREA])

    @property
    def false_findings(self):
        """Blobs of changed pixels that are no debris, in the colour image's view."""
        return len(self.false_sizes_px)

    @property
    def statistics_ms(self):
        return self.json['runtime_ms']['statistics']
