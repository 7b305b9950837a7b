"""`rva simulate` from end to end: captures of scenes, and the truth beside them.

usage: simulate_test.py RVA
"""
import math
import pathlib
import signal

import numpy as np

import program
from captures import read_image
from simulations import (CHEAP, TOOLS, WALL, SimulationTest, contents, depth_frames, description, frame_files,
                         object_named, truth)

FRAMES = 5
TRUTH_UNIT_M = 0.0001
TOOL_NAMES = ['flashlight', 'screwdriver', 'key']


def bounding_box(mask):
    rows, columns = np.flatnonzero(mask.any(1)), np.flatnonzero(mask.any(0))
    return [columns[0], rows[0], columns[-1] - columns[0] + 1, rows[-1] - rows[0] + 1]


def overlap(a, b):
    return all(a[i] < b[i] + b[i + 2] and b[i] < a[i] + a[i + 2] for i in (0, 1))


class Tools(SimulationTest):
    """The same bay before and after three tools were left in it."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.final = cls.make('final', TOOLS, '--frames', FRAMES)
        cls.initial = cls.make('initial', TOOLS, '--frames', FRAMES, '--seed', 2, '--debris', 'none')
        cls.labels = read_image(cls.final / 'truth' / 'labels.png')
        cls.true_m = read_image(cls.final / 'truth' / 'depth.png') * TRUTH_UNIT_M

    def test_same_seed_gives_same_bytes(self):
        again = self.make('again', TOOLS, '--frames', FRAMES)
        self.assertEqual(contents(again), contents(self.final))

    def test_other_seed_differs_in_noise_alone(self):
        other = contents(self.make('other', TOOLS, '--frames', 2, '--seed', 7))
        first = contents(self.final)
        same = {path.as_posix() for path, content in other.items() if content == first[path]}
        self.assertEqual(same, {'truth/labels.png', 'truth/depth.png', 'truth/truth.json'})

    def test_contains_what_was_asked_for(self):
        self.assertEqual([path.name for path in frame_files(self.final)],
                         [f'{i:06d}.png' for i in range(FRAMES)])
        self.assertEqual([path.name for path in frame_files(self.final, 'color')], ['000000.png'])
        frames = depth_frames(self.final)
        self.assertTrue(all((a != b).any() for a, b in zip(frames, frames[1:])), 'a frame is like another')

    def test_is_a_sound_capture(self):
        info = self.info(self.final)
        self.assertEqual((info['format'], info['depth_frames']), ('rva-capture', FRAMES))
        self.assertGreater(info['fill_rate'], 0.5)

    def test_says_how_to_make_it_again(self):
        made = description(self.final)['simulation']
        self.assertEqual((made['scene'], made['seed']), ('three-tools', 1))
        self.assertEqual(made['options']['baseline_mm'], description(self.final)['camera']['baseline_m'] * 1000)
        self.assertNotIn('debris', made)
        self.assertEqual(description(self.initial)['simulation']['debris'], 'none')

    def test_labels_are_those_of_truth_json(self):
        labels, pixels = np.unique(self.labels, return_counts=True)
        seen = dict(zip(labels.tolist(), pixels.tolist()))
        objects = truth(self.final)['objects']
        self.assertEqual([entry['label'] for entry in objects], list(range(1, len(objects) + 1)))
        self.assertEqual(len({entry['name'] for entry in objects}), len(objects))
        self.assertLessEqual(set(seen) - {0}, {entry['label'] for entry in objects})
        for entry in objects:
            with self.subTest(entry['name']):
                self.assertEqual(entry['visible_px'], seen.get(entry['label'], 0))
                box = bounding_box(self.labels == entry['label']) if entry['visible_px'] else None
                self.assertEqual(entry.get('bbox'), box)

    def test_roles(self):
        objects = truth(self.final)['objects']
        debris = [entry['name'] for entry in objects if entry['role'] == 'debris']
        self.assertEqual(debris, TOOL_NAMES)
        self.assertEqual({entry['role'] for entry in objects}, {'debris', 'structure', 'room'})

    def test_debris_has_its_true_size_and_position(self):
        key = object_named(self.final, 'key')
        np.testing.assert_allclose(key['size_mm'], [57, 25, 2.2], rtol=1e-3)
        pose = np.reshape(key['world_from_object'], (4, 4))
        np.testing.assert_allclose(pose[:3, :3] @ pose[:3, :3].T, np.eye(3), atol=1e-6)
        np.testing.assert_allclose(pose[:2, 3], [0.05, 0.47], atol=1e-6)
        self.assertAlmostEqual(pose[2, 3], 0.0011, delta=0.0005)

    def test_truth_has_the_pose_of_the_capture(self):
        np.testing.assert_allclose(truth(self.final)['world_from_camera'],
                                   description(self.final)['pose']['world_from_camera'], atol=1e-9)

    def test_true_depth_lies_on_the_skin(self):
        """Every pixel of the lower skin, taken back into the world, is at height 0."""
        skin = self.labels == object_named(self.final, 'skin-lower')['label']
        v, u = np.nonzero(skin)
        z = self.true_m[skin]
        camera = description(self.final)['depth']
        points = np.stack([(u - camera['cx']) / camera['fx'] * z, (v - camera['cy']) / camera['fy'] * z, z,
                           np.ones_like(z)])
        pose = np.reshape(truth(self.final)['world_from_camera'], (4, 4))
        height = (pose @ points)[2]
        # Rivets stick out of it.
        self.assertLess(np.quantile(abs(height), 0.99), TRUTH_UNIT_M)
        self.assertLess(abs(height).max(), 0.003)

    def test_depth_is_the_truth_and_noise(self):
        frames = depth_frames(self.final).astype(float)
        frames[frames == 0] = np.nan
        skin = self.labels == object_named(self.final, 'skin-lower')['label']
        skin &= np.isfinite(frames).all(0) & (self.true_m > 0.4)
        measured_m = np.median(frames[:, skin], axis=0) * description(self.final)['depth']['unit_m']
        error = measured_m / self.true_m[skin] - 1
        self.assertGreater(skin.sum(), 10_000)
        self.assertLess(abs(np.median(error)), 0.01)
        self.assertGreater(np.mean(abs(error) < 0.02), 0.95)

    def test_debris_none_is_the_bay_before_the_work(self):
        before, after = (truth(capture)['objects'] for capture in (self.initial, self.final))
        self.assertEqual([entry['name'] for entry in before],
                         [entry['name'] for entry in after if entry['role'] != 'debris'])
        labels = read_image(self.initial / 'truth' / 'labels.png')
        self.assertLessEqual(labels.max(), len(before))
        changed = labels != self.labels
        tools = [object_named(self.final, name)['label'] for name in TOOL_NAMES]
        np.testing.assert_array_equal(changed, np.isin(self.labels, tools))

    def test_detection_finds_the_flashlight(self):
        found = self.detect(self.initial, self.final)['detections']
        box = object_named(self.final, 'flashlight')['bbox']
        self.assertTrue(any(entry['kind'] == 'added' and overlap(entry['bbox'], box) for entry in found), found)


class Changes(SimulationTest):
    """What a command changes of a scene."""

    def simulate(self, scene, *options):
        self.succeed('simulate', scene, '--out', self.out, '--frames', 1, *CHEAP, *options)
        return self.out

    def test_pan_and_tilt(self):
        pose = description(self.simulate(WALL, '--pan', 25, '--tilt', -10))['pose']
        self.assertEqual((pose['pan_deg'], pose['tilt_deg']), (25, -10))
        forward = np.reshape(pose['world_from_camera'], (4, 4))[:3, 2]
        pan, tilt = math.radians(25), math.radians(-10)
        np.testing.assert_allclose(
            forward, [-math.sin(pan) * math.cos(tilt), math.cos(pan) * math.cos(tilt), math.sin(tilt)], atol=1e-9)

    def test_position(self):
        """The true depth of a wall across the view shows how far the robot stepped back."""
        capture = self.simulate(WALL, '--position', '0.1,-0.32,0.05')
        position = np.reshape(description(capture)['pose']['world_from_camera'], (4, 4))[:3, 3]
        # The camera's position above the foot is that of docs/scenes.md: some 0.25 m up.
        np.testing.assert_allclose(position, [0.0825, -0.30, 0.30], atol=1e-6)
        depth_m = read_image(capture / 'truth' / 'depth.png') * TRUTH_UNIT_M
        np.testing.assert_allclose(depth_m[200:280, 380:460], 1.30, atol=TRUTH_UNIT_M)

    def test_negative_numbers_after_an_equals_sign(self):
        capture = self.simulate(WALL, '--tilt=-7.5', '--position=-0.1,-0.02,0')
        self.assertEqual(description(capture)['pose']['tilt_deg'], -7.5)

    def test_debris_of_another_scene(self):
        other = self.folder / 'other.yaml'
        other.write_text('format: rva-scene\nversion: 1\ndebris: [{ kind: rivet, on: [0, 0.46] }]\n')
        objects = truth(self.simulate(TOOLS, '--debris', other))['objects']
        self.assertEqual([entry['name'] for entry in objects if entry['role'] == 'debris'], ['rivet'])

    def test_debris_seed(self):
        scene = self.folder / 'random.yaml'
        scene.write_text('format: rva-scene\nversion: 1\nwing: {}\n'
                         'debris: [{ random: 3, kinds: [nut-m6, rivet], seed: 4 }]\n')
        placed = []
        for options in ([], ['--debris-seed', 4], ['--debris-seed', 5]):
            objects = truth(self.simulate(scene, '--overwrite', *options))['objects']
            placed.append([entry for entry in objects if entry['role'] == 'debris'])
            self.assertEqual(len(placed[-1]), 3)
        self.assertEqual(placed[0], placed[1])
        self.assertNotEqual(placed[0], placed[2])

    def test_more_frames_and_colours_go_on_from_the_first_ones(self):
        one = contents(self.make('one', WALL, '--frames', 1, *CHEAP))
        self.succeed('simulate', WALL, '--out', self.out, '--frames', 3, *CHEAP, '--all-colors')
        three = contents(self.out)
        lines = pathlib.Path('frames.jsonl')
        self.assertTrue(three[lines].startswith(one.pop(lines)))
        # Infrared images are means of all frames, and the description states of how many.
        one = {path: bytes for path, bytes in one.items() if path.parts[0] in ('depth', 'color', 'truth')}
        self.assertEqual([path for path in one if one[path] != three[path]], [])
        self.assertEqual(len(frame_files(self.out, 'color')), 3)

    def test_options_reach_the_sensor(self):
        made = description(self.simulate(WALL, '--focal', 500, '--baseline', 95, '--depth-unit', 1))
        self.assertEqual((made['depth']['fx'], made['depth']['unit_m'], made['camera']['baseline_m']),
                         (500, 0.001, 0.095))
        self.assertAlmostEqual(np.median(depth_frames(self.out)), 1000, delta=20)

    def test_names_of_any_kind(self):
        scene = self.folder / 'dårlig søm\n1.yaml'
        scene.write_bytes(WALL.read_bytes())
        self.out = self.folder / 'two words' / 'größer\n'
        self.assertEqual(truth(self.simulate(scene))['scene'], scene.stem)
        self.assertEqual(self.info(self.out)['depth_frames'], 1)


class Running(SimulationTest):
    """How the command behaves."""

    def arguments(self, *options):
        return ['simulate', WALL, '--out', self.out, '--frames', 2, *CHEAP, *options]

    def test_prints_where_the_capture_lies(self):
        done = self.succeed(*self.arguments())
        self.assertEqual((done.stdout, done.stderr), (f'{self.out}\n', ''))

    def test_progress_is_for_terminals(self):
        seen = self.on_a_terminal(*self.arguments())
        self.assertIn('recording 1/2', seen)
        self.assertTrue(seen.endswith('\r\033[K'), repr(seen))

    def test_interruption_leaves_nothing(self):
        self.check_interrupted(signal.SIGINT, 'simulate', WALL, '--out', self.out, '--frames', 2000, *CHEAP)

    def test_existing_folder_is_kept_or_replaced(self):
        self.succeed(*self.arguments())
        made = contents(self.out)
        self.check_fails(*self.arguments('--seed', 3), names=[self.out, 'already exists'])
        self.assertEqual(contents(self.out), made)
        self.succeed('simulate', WALL, '--out', self.out, '--frames', 1, *CHEAP, '--seed', 3, '--overwrite')
        self.assertEqual(len(frame_files(self.out)), 1)
        self.assertNotEqual(contents(self.out), made)

    def test_what_others_put_there_is_never_replaced(self):
        self.succeed(*self.arguments())
        (self.out / 'truth' / 'notes.txt').write_text('mine')
        made = contents(self.out)
        self.check_fails(*self.arguments('--overwrite'), names=['notes.txt'])
        self.assertEqual(contents(self.out), made)

    def test_failure_keeps_an_earlier_capture(self):
        self.succeed(*self.arguments())
        made = contents(self.out)
        self.check_fails('simulate', self.folder / 'none.yaml', '--out', self.out, '--overwrite')
        self.assertEqual(contents(self.out), made)

    def test_wrong_usage(self):
        for options in (['--frames', 0], ['--frames', -1], ['--frames', 'many'], ['--frames', 1_000_001],
                        ['--seed', -1], ['--seed', 2**64], ['--focal', 49], ['--focal', 'nan'],
                        ['--baseline', 1001], ['--supersampling', 9], ['--dots', 1.5], ['--depth-unit', 0],
                        ['--exposure', 'inf'], ['--position', '1,2'], ['--position', 'nan,0,0'],
                        ['--position', '0,0,101'], ['--pan', 'nan'], ['--pan', 181], ['--tilt', -91],
                        ['--pan', 'left'], ['--nonsense']):
            with self.subTest(options=options):
                done = self.rva('simulate', WALL, '--out', self.out, *options)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.check_line(done.stderr, options[:1])
                self.assertEqual(self.names(), [])


class BadScene(SimulationTest):
    HEAD = 'format: rva-scene\nversion: 1\n'

    def check_refused(self, text, *names, options=()):
        scene = self.folder / 'scene.yaml'
        scene.write_text(text)
        for command in (['simulate', scene, *options], ['record', '--camera', f'sim:{scene}']):
            if not options or command[0] == 'simulate':
                self.check_fails(*command, '--out', self.out, names=[scene, *names])

    def check_table(self, table):
        """Each entry: the text that follows format and version, the line that is wrong, and the field."""
        for name, (text, line, *names) in table.items():
            with self.subTest(name):
                self.check_refused(self.HEAD + text, f'scene.yaml:{line}:', *names)

    def test_files_that_are_no_scene(self):
        self.check_fails('simulate', self.folder / 'none.yaml', '--out', self.out, names=['none.yaml'])
        self.check_fails('simulate', self.folder, '--out', self.out, names=[self.folder])
        (self.folder / 'binary.yaml').write_bytes(bytes(range(256)))
        self.check_fails('simulate', self.folder / 'binary.yaml', '--out', self.out, names=['binary.yaml'])
        for text in ('', '# nothing\n', '[1, 2]\n', 'text\n', 'format: rva-capture\nversion: 1\n'):
            with self.subTest(text):
                self.check_refused(text, 'scene.yaml:1')

    def test_version(self):
        self.check_refused('format: rva-scene\nversion: 2\n', 'scene.yaml:2', 'version', 'newer RVA')
        self.check_refused('format: rva-scene\n', 'scene.yaml:1', 'version')

    def test_syntax(self):
        for name, text, line in (('bracket', 'wing: {\n', 4), ('tab', 'wing:\n\tskin: {}\n', 4),
                                 ('alias', 'wing: *nowhere\n', 3), ('depth', 'wing: ' + '[' * 100_000, 3)):
            with self.subTest(name):
                self.check_refused(self.HEAD + text, f'scene.yaml:{line}', 'not YAML')

    def test_keys(self):
        self.check_table({
            'unknown': ('wings: {}\n', 3, '"wings"', 'wing,'),
            'unknown inside': ('wing:\n  skin: { color: red }\n', 4, 'wing.skin', '"color"', 'material'),
            'twice': ('wing: {}\nwing: {}\n', 4, '"wing"', 'twice'),
            'missing': ('debris: [{ on: [0, 0] }]\n', 3, 'debris[0]', '"kind"'),
        })

    def test_values(self):
        self.check_table({
            'negative size': ('solids:\n- { name: a, shape: box, at_m: [0, 1, 0], material: steel,\n'
                              '    size_mm: [10, -10, 10] }\n', 5, 'solids[0].size_mm[1]', '"-10"'),
            'not a number': ('wing: { span_m: .nan }\n', 3, 'wing.span_m', '".nan"'),
            'too large': ('wing:\n  span_m: 1e9\n', 4, 'wing.span_m', '0.1 to 20'),
            'material': ('wing:\n  ribs: { material: cheese }\n', 4, 'wing.ribs.material', '"cheese"', 'steel'),
            'kind': ('wing: {}\ndebris:\n- { kind: banana, on: [0, 0.46] }\n', 5, 'debris[0].kind', '"banana"',
                     'flashlight'),
            'shape': ('solids: [{ name: a, shape: ball }]\n', 3, 'solids[0].shape', '"ball"', 'cylinder'),
            'name': ('solids: [&a { name: a, shape: plane, size_mm: [1, 1], at_m: [0, 1, 0], material: steel },'
                     ' *a]\n', 3, 'name', '"a"'),
            'count': ('debris: [{ random: 1001, within_m: [[0, 0], [1, 1]] }]\n', 3, 'debris[0].random', '1001'),
        })

    def test_positions(self):
        self.check_table({
            'outside the bay': ('wing: {}\ndebris:\n- { kind: key, on: [2, 0.46] }\n', 5, 'debris[0].on'),
            'cut into the rib': ('wing: {}\ndebris:\n- { kind: key, at_m: [0.375, 0.46, 0.1] }\n', 5,
                                 'debris[0].at_m', 'outside the bay'),
            'over an edge': ('wing: {}\ndebris:\n- { kind: screwdriver, on: [0, 0.40], turn_deg: 90 }\n', 5,
                             'debris[0].on', 'rest'),
            'no room': ('wing: {}\ndebris:\n- { random: 900, kinds: [rag] }\n', 5, 'debris[0].random'),
            'camera in a solid': ('solids:\n- { name: block, shape: box, size_mm: [500, 500, 900],\n'
                                  '    at_m: [0, 0, 0], material: steel }\nrobot:\n  at_m: [0, 0, 0]\n', 7, 'robot',
                                  '"block"'),
        })

    def test_camera_moved_into_a_solid(self):
        self.check_fails('simulate', WALL, '--out', self.out, '--position', '0,0.985,0',
                         names=['position: the camera', '"wall"'])

    def test_meshes(self):
        text = self.HEAD + ('meshes:\n- name: part\n  file: part.stl\n  unit: mm\n  at_m: [0, 1, 0]\n'
                            '  material: steel\n')
        self.check_refused(text, 'scene.yaml:5', 'meshes[0].file', 'part.stl')
        for name, content in {'empty': b'', 'no triangles': bytes(84), 'cut': bytes(80) + b'\x09\0\0\0' + bytes(50),
                              'not finite': bytes(80) + b'\x01\0\0\0' + b'\xff' * 48 + bytes(2)}.items():
            with self.subTest(name):
                (self.folder / 'part.stl').write_bytes(content)
                self.check_refused(text, 'scene.yaml:5', 'meshes[0].file', 'part.stl')

    def test_debris_of_a_file_that_is_wrong(self):
        other = self.folder / 'other.yaml'
        self.check_fails('simulate', TOOLS, '--debris', other, '--out', self.out, names=[other])
        other.write_text(self.HEAD + 'debris: [{ kind: banana, on: [0, 0.46] }]\n')
        self.check_fails('simulate', TOOLS, '--debris', other, '--out', self.out,
                         names=['other.yaml:3', 'debris[0].kind'])


if __name__ == '__main__':
    program.main()
