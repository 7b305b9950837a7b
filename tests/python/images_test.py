"""Images are the library's own pixels: not copied, not written, and there as long as anyone has them."""
import gc
import subprocess
import sys

import cv2
import numpy as np
import scenes

import rva

WITHOUT_NUMPY = '''
import sys
sys.modules['numpy'] = None  # as if it were not installed
import rva
result = rva.detect(sys.argv[1], sys.argv[2])
print(len(result.findings), rva.open(sys.argv[1]))
try:
    result.changed
except rva.Error as error:
    print(error)
'''


class Images(scenes.Captured):
    def stored(self, name):
        image = cv2.imread(str(self.after / name), cv2.IMREAD_UNCHANGED)
        self.assertIsNotNone(image, name)
        return image

    def test_pixels_are_those_of_the_files(self):
        capture = rva.open(self.after)
        for i in range(len(capture)):
            np.testing.assert_array_equal(capture.depth(i), self.stored(f'depth/{i:06}.png'))
        np.testing.assert_array_equal(capture.depth(-1), capture.depth(len(capture) - 1))
        self.assertEqual(capture.depth(0).dtype, np.uint16)
        np.testing.assert_array_equal(capture.color(0), self.stored('color/000000.png')[:, :, ::-1])
        np.testing.assert_array_equal(capture.color_of(0), capture.color(0))
        self.assertEqual(capture.infrared_of(0, 'right').shape, capture.depth(0).shape)
        self.assertIsNone(rva.open(scenes.ROOT / 'data' / 'bin-tools' / 'initial').infrared_of(0))

    def test_a_view_outlives_its_owner(self):
        capture = rva.open(self.after)
        depth = capture.depth(0)
        result = rva.detect(self.before, capture)
        views = {name: getattr(result, name) for name in ('changed', 'initial_m', 'final_m', 'least_mm')}
        pixels = result.findings[0].pixels
        copies = {name: view.copy() for name, view in views.items()}
        chosen = pixels.copy()
        del capture, result
        gc.collect()
        _ = [np.full((480, 848), 255, np.uint16) for _ in range(20)]  # would take the memory, were it free
        np.testing.assert_array_equal(depth, self.stored('depth/000000.png'))
        np.testing.assert_array_equal(pixels, chosen)
        for name, view in views.items():
            np.testing.assert_array_equal(view, copies[name], name)

    def test_a_finding_outlives_its_result(self):
        findings = rva.detect(self.before, self.after).findings
        gc.collect()
        self.assertEqual(findings[0].area_px, len(findings[0].pixels))
        self.assertIn('added', str(findings[0]))

    def test_nothing_is_copied(self):
        result = rva.detect(self.before, self.after)
        self.assertTrue(np.shares_memory(result.changed, result.changed))
        self.assertFalse(result.changed.flags.owndata)
        self.assertFalse(rva.open(self.after).depth(0).flags.owndata)

    def test_views_are_not_written(self):
        result = rva.detect(self.before, self.after)
        measured = rva.noise(self.before)
        capture = rva.open(self.after)
        for view in (capture.depth(0), capture.color(0), result.changed, result.final_m, result.findings[0].pixels,
                     measured.std_mm, measured.welch_p):
            with self.assertRaisesRegex(ValueError, 'read-only'):
                view[:1] = 0
            with self.assertRaises(ValueError):
                view.setflags(write=True)

    def test_masks_are_of_the_findings(self):
        result = rva.detect(self.before, self.after, within=[(200, 100, 400, 300)])
        height, width = result.changed.shape
        self.assertEqual((height, width), rva.open(self.after).depth(0).shape)
        self.assertTrue((result.changed.reshape(-1)[result.findings[0].pixels] == 255).all())
        self.assertEqual(result.left_out[0, 0], 255)
        self.assertEqual(result.left_out[250, 400], 0)
        self.assertIsNone(rva.detect(self.before, self.after).left_out)
        self.assertIsNone(rva.detect(self.before, self.after, method='constant').least_mm)

    def test_without_numpy(self):
        done = subprocess.run([sys.executable, '-c', WITHOUT_NUMPY, self.before, self.after], capture_output=True,
                              text=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = done.stdout.splitlines()
        self.assertRegex(lines[0], r'^\d+ <rva.Capture .*before: rva-capture, 4 depth and 1 colour images, 848x480>$')
        self.assertEqual(lines[1:], ['numpy: is not installed, and images are its arrays; install the package python3-numpy'])


if __name__ == '__main__':
    scenes.main()
