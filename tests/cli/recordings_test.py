"""What the calibrated detector makes of real recordings. Skipped where there are none.

usage: recordings_test.py RVA SHARED
"""
import pathlib
import sys
import unittest

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


if __name__ == '__main__':
    SHARED = pathlib.Path(sys.argv.pop(2)).resolve()
    program.main()
