"""The training code: calibration and intervals against known values, and a whole training where PyTorch is installed.

usage: training_test.py TRAINING_FOLDER
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import cv2
import numpy as np

TRAINING = pathlib.Path(sys.argv.pop(1)).resolve()
sys.path.insert(0, str(TRAINING))

import calibration  # noqa: E402
import findings  # noqa: E402
import intervals  # noqa: E402


def write_findings(folder, kinds, seed):
    """Findings whose planes depend on their kind, so that it can be learned."""
    random = np.random.default_rng(seed)
    names = sorted(set(kinds))
    planes = random.normal(0, 0.1, (len(kinds), findings.PLANES, findings.PLANE_PX, findings.PLANE_PX))
    for i, kind in enumerate(kinds):
        planes[i, names.index(kind)] += 1.0
    folder.mkdir()
    planes.astype(np.float16).tofile(folder / 'planes.f16')
    run = {'planes': findings.PLANES, 'plane_px': findings.PLANE_PX}
    (folder / 'findings.json').write_text(json.dumps({'run': run, 'findings': [{'kind': kind} for kind in kinds]}))
    return folder


class Calibration(unittest.TestCase):
    def setUp(self):
        random = np.random.default_rng(1)
        self.outputs = random.normal(0, 2, (4000, 4))
        shares = calibration.probabilities(self.outputs, 1.0)
        self.labels = np.array([random.choice(4, p=share) for share in shares])

    def test_temperature_and_addition_are_recovered(self):
        wrong = 3.0 * self.outputs
        wrong[:, -1] -= 1.4
        temperature, addition = calibration.fitted_calibration(wrong, self.labels, (self.labels == 3).mean())
        self.assertAlmostEqual(temperature, 3.0, delta=0.2)
        self.assertAlmostEqual(addition, 1.4, delta=0.3)

    def test_rarer_others_get_less(self):
        additions = [calibration.fitted_calibration(self.outputs, self.labels, others)[1] for others in (0.05, 0.2, 0.5)]
        self.assertEqual(additions, sorted(additions))
        self.assertLess(additions[0] + 1, additions[2])

    def test_without_others_nothing_is_added(self):
        known = self.labels < 3
        self.assertEqual(calibration.fitted_calibration(self.outputs[known], self.labels[known], 0.1)[1], 0.0)

    def test_probabilities_sum_to_one_and_cool_down(self):
        outputs = np.array([[1000.0, 0.0, -1000.0], [1.0, 2.0, 3.0]])
        shares = calibration.probabilities(outputs, 1.0)
        np.testing.assert_allclose(shares.sum(axis=1), 1.0)
        self.assertGreater(calibration.probabilities(outputs, 0.5)[1, 2], shares[1, 2])

    def test_calibration_error_of_what_is_known(self):
        best = np.full(1000, 0.8)
        self.assertAlmostEqual(calibration.expected_calibration_error(best, np.arange(1000) < 800), 0.0)
        self.assertAlmostEqual(calibration.expected_calibration_error(best, np.zeros(1000)), 0.8)
        self.assertAlmostEqual(calibration.expected_calibration_error(np.ones(10), np.ones(10)), 0.0)

    def test_threshold_keeps_the_share_that_is_asked(self):
        best = np.random.default_rng(2).uniform(size=10001)
        self.assertAlmostEqual((best >= calibration.threshold_that_keeps(best, 0.9)).mean(), 0.9, places=3)


class Intervals(unittest.TestCase):
    def test_clopper_pearson_as_published(self):
        # R's binom.test(), and the rule of three's exact form 1 - 0.025 ** (1 / n).
        for (k, n), (low, high) in {(5, 10): (0.1870860, 0.8129140), (1, 20): (0.0012651, 0.2487328),
                                    (0, 30): (0.0, 1 - 0.025 ** (1 / 30)), (30, 30): (0.025 ** (1 / 30), 1.0)}.items():
            np.testing.assert_allclose(intervals.clopper_pearson(k, n), (low, high), atol=1e-6)

    def test_large_numbers_as_the_normal_approximation(self):
        low, high = intervals.clopper_pearson(9000, 10000)
        self.assertAlmostEqual(low, 0.9 - 1.96 * 0.003, places=3)
        self.assertAlmostEqual(high, 0.9 + 1.96 * 0.003, places=3)


class OfFindings(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def test_kinds_and_names_of_people_become_classes(self):
        folder = write_findings(self.folder / 'a', ['nut-m6', 'fastener', '', 'spray-can'], 1)
        labels = findings.Findings([folder, folder]).labels
        fastener, other = findings.LABELS.index('fastener'), len(findings.LABELS)
        self.assertEqual(labels.tolist(), [fastener, fastener, other, other] * 2)

    def test_each_kind_has_one_class(self):
        kinds = [kind for kinds in findings.CLASSES.values() for kind in kinds]
        self.assertEqual(len(kinds), len(set(kinds)))

    def test_a_whole_training(self):
        try:
            import torch  # noqa: F401
        except ImportError:
            self.skipTest('PyTorch is not installed (python3-torch)')
        kinds = ['wrench', 'pen', 'nut-m6', ''] * 40
        data = write_findings(self.folder / 'data', kinds, 1)
        validation = write_findings(self.folder / 'validation', kinds, 2)
        out = self.folder / 'out'
        command = [sys.executable, str(TRAINING / 'train.py'), '--data', str(data), '--validation', str(validation), '--out',
                   str(out)]
        subprocess.run([*command, '--epochs', '2'], check=True, capture_output=True)
        resumed = subprocess.run([*command, '--epochs', '8', '--resume'], check=True, capture_output=True, text=True)
        self.assertIn('epoch 3:', resumed.stdout)
        self.assertNotIn('epoch 2:', resumed.stdout)
        card = json.loads((out / 'findings.json').read_text())
        net = cv2.dnn.readNetFromONNX(str(out / card['model']))
        shown = findings.Findings([validation])
        named = []
        for planes in shown.planes:
            net.setInput(planes[None].astype(np.float32))
            named.append(int(net.forward()[0].argmax()))
        self.assertGreater((np.array(named) == shown.labels).mean(), 0.9)


if __name__ == '__main__':
    unittest.main()
