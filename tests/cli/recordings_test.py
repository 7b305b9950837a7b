"""What the detectors make of real recordings. Skipped where there are none.

usage: recordings_test.py RVA SHARED
"""
import json
import math
import pathlib
import sys
import unittest

import numpy as np

import program

# left, top, right, bottom in the depth image, read off the colour images.
OBJECTS = {'camera0': {'whisk': (290, 85, 415, 290), 'torch': (260, 295, 355, 330),
                       'scissors and glass': (200, 355, 475, 465)},
           'camera1': {'glass': (190, 85, 400, 170), 'torch': (265, 185, 360, 235), 'whisk': (200, 210, 335, 450)}}
IN_THE_BIN = (110, 520)  # beside it, other things changed too


def overlap(box, area):
    x, y, width, height = box
    left, top, right, bottom = area
    return x < right and left < x + width and y < bottom and top < y + height


class RecordingsTest(program.ProgramTest):
    def findings(self, *names):
        initial, final = (SHARED / 'data' / pathlib.Path(*names) / side for side in ('initial', 'final'))
        if not initial.exists():
            self.skipTest(f'{initial} is not there')
        return self.detect(initial, final)['detections']

    def test_one_frame_of_a_bin_shows_what_was_put_into_it_and_nothing_else(self):
        for camera, objects in OBJECTS.items():
            with self.subTest(camera):
                boxes = [finding['bbox'] for finding in self.findings('bin-tools', camera)]
                for name, area in objects.items():
                    self.assertTrue(any(overlap(box, area) for box in boxes), f'{name} is missed')
                in_the_bin = [box for box in boxes if IN_THE_BIN[0] < box[0] + box[2] / 2 < IN_THE_BIN[1]]
                for box in in_the_bin:
                    self.assertTrue(any(overlap(box, area) for area in objects.values()), f'{box} is nothing')
                self.out = self.folder / 'other'

    def test_where_an_arm_moves_while_recording_no_depth_within_reach_is_called_changed(self):
        for finding in self.findings('arm-realsense'):
            self.assertGreater(finding['position_m'][2], 5.0)

    def test_of_a_room_in_which_nothing_changes_views_are_registered_or_refused(self):
        room = SHARED / 'data' / 'room-kinect'
        if not room.exists():
            self.skipTest(f'{room} is not there')
        # Published poses are no better than about 10 mm and 0.4 degree.
        limits = {'frame040': (0.015, 0.6), 'frame080': (0.040, 1.5), 'frame160': (0.040, 1.5),
                  'frame300': (0.040, 1.5)}
        laid = []
        for frame, (most_m, most_deg) in limits.items():
            with self.subTest(frame):
                out = self.folder / frame
                done = self.rva('detect', room / 'frame000', room / frame, '--method', 'spatial', '--out', out)
                if done.returncode == 1:
                    self.check_line(done.stderr, ['could not be registered'])
                    continue
                laid.append(frame)
                found = json.loads((out / 'detections.json').read_text())
                self.assertLessEqual(len(found['detections']), 2)
                off = np.linalg.inv(published(room, frame)) @ np.array(found['final_from_initial']).reshape(4, 4)
                self.assertLess(np.linalg.norm(off[:3, 3]), most_m)
                self.assertLess(math.degrees(math.acos(min(1.0, (np.trace(off[:3, :3]) - 1) / 2))), most_deg)
        self.assertIn('frame040', laid)


def published(room, frame):
    """frame_from_frame000 by the recording's own poses."""
    initial, final = (np.array(json.loads((room / name / 'capture.json').read_text())['pose']['world_from_camera'])
                      .reshape(4, 4) for name in ('frame000', frame))
    return np.linalg.inv(final) @ initial


if __name__ == '__main__':
    SHARED = pathlib.Path(sys.argv.pop(2)).resolve()
    program.main()
