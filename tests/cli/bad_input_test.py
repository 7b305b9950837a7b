"""What is wrong with an input or an output is reported in one line, at once, and nothing is left behind.

usage: bad_input_test.py RVA
"""
import copy
import itertools
import json
import os
import resource
import shutil
import signal
import struct
import subprocess
import time
import zlib

import cv2
import numpy as np

import program
from captures import (CAMERA, IDENTITY, TUM_INTRINSICS, Camera, depth_fields, depth_png, empty_depth_png, noisy, plain_color,
                      record_again, write_capture, write_image, write_open3d, write_tum)

FRAMES = 4
COMMANDS = ('info', 'noise', 'detect')
MISSING = object()
AT_ONCE_S = 60


def frames(count=FRAMES, camera=CAMERA, seed=1):
    return noisy(camera.plane(1000), count, 1.0, seed=seed)


def with_field(description, path, value):
    """The description with one field, named like 'depth.fx', changed or taken out."""
    changed = copy.deepcopy(description)
    *parents, key = path.split('.')
    holder = changed
    for parent in parents:
        holder = holder.setdefault(parent, {})
    if value is MISSING:
        del holder[key]
    else:
        holder[key] = value
    return changed


def replace(path, content):
    if path.is_dir():
        shutil.rmtree(path)
    else:
        path.unlink()
    if content is not None:
        path.write_bytes(content)


def encoded(ending, pixels):
    return cv2.imencode(ending, pixels)[1].tobytes()


def limit(what, size):
    def in_the_child():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(what, (size, size))
    return in_the_child


class BadInputTest(program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.good = write_capture(self.folder / 'good', frames(), pictures=[self.picture()], color=CAMERA.fields(),
                                  color_from_depth=IDENTITY)
        self.bad = self.folder / 'bad'
        self.outs = (self.folder / f'out{i}' for i in itertools.count())

    @property
    def twin(self):
        """The good capture, recorded again."""
        twin = self.folder / 'twin'
        return twin if twin.exists() else record_again(self.good, twin)

    def picture(self):
        return plain_color(CAMERA.width, CAMERA.height, (200, 100, 50))

    def spoil(self, name, content):
        """The good capture, recorded again, with one file replaced."""
        shutil.rmtree(self.bad, ignore_errors=True)
        record_again(self.good, self.bad)
        replace(self.bad / name, content)

    def check_compared_without_colour(self, *names, **run):
        """Depth is sound: it is compared, and what is wrong with colour is a warning."""
        out = next(self.outs)
        done = self.rva('detect', self.good, self.bad, '--out', out, **run)
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in ('there is no overlay.png', *names):
            self.assertIn(name, done.stderr)
        self.assertFalse((out / 'overlay.png').exists())
        self.assertTrue((out / 'detections.json').exists())

    def check_refused(self, *names, commands=COMMANDS, initial=None, options=(), **run):
        """Every command that reads the bad capture reports what is wrong with it."""
        arguments = {'info': ['info', self.bad], 'noise': ['noise', self.bad, '--out', next(self.outs)],
                     'detect': ['detect', initial or self.good, self.bad, '--out', next(self.outs)]}
        for command in commands:
            with self.subTest(command):
                self.check_fails(*arguments[command], *options, names=names, **run)


class BadDescription(BadInputTest):
    def test_what_is_no_capture(self):
        self.check_refused(self.bad, 'no such')
        self.bad.mkdir()
        self.check_refused(self.bad, 'capture.json')
        self.bad.rmdir()
        self.bad.write_text('a file')
        self.check_refused(self.bad, 'not a ROS bag')

    def test_capture_json_gone(self):
        self.spoil('capture.json', None)
        self.check_refused(self.bad, 'no description of the camera')

    def test_capture_json_that_is_a_folder(self):
        self.spoil('capture.json', None)
        (self.bad / 'capture.json').mkdir()
        self.check_refused(self.bad / 'capture.json', 'not a file')

    def test_capture_json_that_is_no_json(self):
        good = (self.good / 'capture.json').read_bytes()
        table = {'empty': b'', 'cut': good[:100], 'binary': bytes(range(256)), 'list': b'[]', 'null': b'null',
                 'latin 1': good.replace(b'{', b'{"room": "K\xfcche", ', 1), 'two': good + good,
                 'deep': b'[' * 100_000, 'huge number': good.replace(b'60.0', b'1e999')}
        self.assertNotEqual(table['huge number'], good)
        for name, content in table.items():
            with self.subTest(name):
                self.spoil('capture.json', content)
                self.check_refused(self.bad / 'capture.json')

    def test_line_of_broken_json_is_named(self):
        self.spoil('capture.json', b'{\n"format": "rva-capture",\n"version": }\n')
        self.check_refused(self.bad / 'capture.json', 'line 3')

    def test_fields_that_make_no_sense(self):
        good = json.loads((self.good / 'capture.json').read_text())
        table = {
            'format': [MISSING, 'rva-detections', 1, None],
            'version': [MISSING, 2, 0, '1', 1.5],
            'depth': [MISSING, [], 'none'],
            'depth.width': [MISSING, 0, -64, 64.5, '64', 1e12, True],
            'depth.height': [MISSING, 0],
            'depth.fx': [MISSING, -60.0, 0, '60', [60]],
            'depth.fy': [MISSING, -60.0, 0, None],
            'depth.cx': [MISSING, '30', {}],
            'depth.cy': [MISSING],
            'depth.distortion_model': ['fisheye', 7, 'two\nlines'],
            'depth.distortion': [[0, 0, 0, 0], 'none', [0, 0, 0, 0, '0']],
            'color': [[], {}, 'rgb', {**CAMERA.fields(), 'fx': -1}],
            'color_from_depth': [IDENTITY[:15], [2, *IDENTITY[1:]], [0] * 16, 'none', [*IDENTITY[:15], 'x']],
            'pose': ['b1', 3],
            'pose.base': [3],
            'pose.pan_deg': ['12'],
            'pose.world_from_camera': [[1, 2, 3]],
            'camera': ['D435'],
            'camera.model': [435],
            'camera.baseline_m': [0, -0.05, '0.05'],
            'captured_at': [20260101],
        }
        for path, values in table.items():
            for value in values:
                with self.subTest(path, value='missing' if value is MISSING else value):
                    content = json.dumps(with_field(good, path, value)).encode()
                    self.spoil('capture.json', content)
                    self.check_refused(self.bad, path.split('.')[-1], commands=['info', 'detect'])

    def test_depth_units_that_make_no_sense(self):
        good = json.loads((self.good / 'capture.json').read_text())
        for value in (MISSING, 0, -0.001, 1000, '0.001'):
            with self.subTest(value='missing' if value is MISSING else value):
                self.spoil('capture.json', json.dumps(with_field(good, 'depth.unit_m', value)).encode())
                self.check_refused(self.bad, 'unit')

    def test_open3d_description(self):
        matrix = [CAMERA.fx, 0, 0, 0, CAMERA.fy, 0, CAMERA.cx, CAMERA.cy, 1]
        negative = [-1, *matrix[1:]]
        table = {'intrinsic_matrix': [None, matrix[:8], [matrix[:3], matrix[3:6], matrix[6:]], negative],
                 'width': [None, 0, '64'], 'height': [None, -1], 'depth_scale': [0, -1000, '1000']}
        for key, values in table.items():
            for value in values:
                with self.subTest(key, value=value):
                    shutil.rmtree(self.bad, ignore_errors=True)
                    write_open3d(self.bad, frames(), **{key: value})
                    field = 'fx' if value is negative else key
                    self.check_refused(self.bad / 'intrinsic.json', field)

    def test_tum_needs_intrinsics(self):
        write_tum(self.bad, frames() * 5)
        self.check_refused(self.bad, 'intrinsics')

    def test_tum_lists(self):
        picture = self.picture()
        table = {
            'malformed': ('depth.txt', '# list\n10.0 depth/10.png\nten depth/11.png\n', ['depth.txt:3']),
            'no file': ('depth.txt', '10.0\n', ['depth.txt:1']),
            'not a time': ('depth.txt', 'nan depth/10.000000.png\n', ['depth.txt:1']),
            'empty': ('depth.txt', '', ['depth.txt']),
            'comments only': ('depth.txt', '# depth maps\n', ['depth.txt']),
            'above': ('depth.txt', '10.0 ../good/depth/000000.png\n', ['depth.txt', '../good']),
            'above in the end': ('depth.txt', '10.0 depth/../../good/depth/000000.png\n', ['depth.txt']),
            'absolute': ('depth.txt', '10.0 /etc/passwd\n', ['depth.txt', '/etc/passwd']),
            'not there': ('depth.txt', '10.0 depth/none.png\n', ['depth/none.png']),
            'a folder': ('depth.txt', '10.0 depth\n', ['depth', 'not a file']),
            'colour malformed': ('rgb.txt', 'ten rgb/x.png\n', ['rgb.txt:1']),
            'colour above': ('rgb.txt', '10.0 ../x.png\n', ['rgb.txt', '../x.png']),
        }
        for name, (file, text, names) in table.items():
            with self.subTest(name):
                shutil.rmtree(self.bad, ignore_errors=True)
                write_tum(self.bad, frames() * 5, pictures=[(10, picture)])
                (self.bad / file).write_text(text)
                self.check_refused(*names, commands=['info', 'detect'], initial=self.bad,
                                   options=TUM_INTRINSICS)


class BadImages(BadInputTest):
    def test_truncated_depth(self):
        whole = (self.good / 'depth' / '000001.png').read_bytes()
        of_end = (16, 12, 8)  # the last 4 bytes are the end mark's checksum, which guards nothing
        for length in [0, 4, 8, 20, 33, 41, len(whole) // 2, *(len(whole) - cut for cut in of_end)]:
            with self.subTest(length=length, of=len(whole)):
                self.spoil('depth/000001.png', whole[:length])
                self.check_refused('depth/000001.png')

    def test_damaged_depth(self):
        """One bit of one depth; PNG's check sums know."""
        row = b'\0' + b'\x03\xe8' * CAMERA.width
        whole = depth_png(CAMERA.width, CAMERA.height, zlib.compress(row * CAMERA.height, 0))
        self.spoil('depth/000001.png', whole)
        self.succeed('info', self.bad)
        for share in (0.1, 0.5, 0.9):
            with self.subTest(share):
                damaged = bytearray(whole)
                damaged[int(share * len(whole))] ^= 0x10
                self.spoil('depth/000001.png', bytes(damaged))
                self.check_refused('depth/000001.png')

    def test_what_is_no_depth(self):
        depth = frames()[1]
        table = {
            '8 bit': encoded('.png', (depth // 8).astype(np.uint8)),
            'colour of 8 bit': encoded('.png', self.picture()),
            'colour of 16 bit': encoded('.png', np.dstack([depth] * 3)),
            'alpha': encoded('.png', np.dstack([depth] * 4)),
            'jpeg': encoded('.jpg', self.picture()),
            'text': b'10 20 30\n',
            'higher': encoded('.png', np.vstack([depth, depth])),
            'narrower': encoded('.png', depth[:, :-1]),
            'turned': encoded('.png', depth.T),
        }
        for name, content in table.items():
            with self.subTest(name):
                self.spoil('depth/000001.png', content)
                self.check_refused('depth/000001.png')

    def test_all_frames_of_another_size_than_stated(self):
        write_capture(self.bad, frames(camera=Camera(width=32)))
        self.check_refused('depth/000000.png', '32x48', '64x48')

    def test_no_frames(self):
        self.spoil('depth', None)
        self.check_refused(self.bad, 'no depth frame')
        (self.bad / 'depth').mkdir()
        self.check_refused(self.bad, 'no depth frame')

    def test_frame_that_is_no_file(self):
        path = self.bad / 'depth' / '000001.png'
        table = {'folder': path.mkdir, 'dangling link': lambda: path.symlink_to('nowhere'),
                 'pipe': lambda: os.mkfifo(path)}
        for name, make in table.items():
            with self.subTest(name):
                self.spoil('depth/000001.png', None)
                make()
                self.check_refused(path, commands=['info', 'detect'], timeout=AT_ONCE_S)

    def test_bad_colour(self):
        png, jpeg = (encoded(ending, self.picture()) for ending in ('.png', '.jpg'))
        table = {'empty': b'', 'text': b'no picture', 'truncated header': png[:30], 'truncated png': png[:len(png) // 2],
                 'png without an end': png[:-12], 'truncated jpeg header': jpeg[:20],
                 'truncated jpeg': jpeg[:len(jpeg) - 40], 'jpeg without an end': jpeg[:-2]}
        for name, content in table.items():
            with self.subTest(name):
                self.spoil('color/000000.png', content)
                self.check_refused('color/000000.png', commands=['info'])
                self.check_compared_without_colour('color/000000.png')

    def test_colour_of_another_size_than_stated(self):
        write_capture(self.bad, frames(seed=2), pictures=[self.picture()], color=Camera(width=80).fields())
        self.check_refused('color/000000.png', '64x48', '80x48', commands=['info'])
        self.check_compared_without_colour('color/000000.png', '64x48', '80x48')

    def check_refused_without_memory(self, *names, **run):
        """With less memory than an image of 100 megapixels takes, but enough for a sound capture."""
        # Address sanitizer reserves terabytes, which no limit would let it have.
        memory = None if program.is_sanitized() else limit(resource.RLIMIT_DATA, 150 << 20)
        sound = self.rva('info', self.good, preexec=memory)
        self.assertEqual(sound.returncode, 0, sound.stderr)
        self.check_refused(*names, preexec=memory, timeout=AT_ONCE_S, **run)

    def test_depth_of_100_megapixels(self):
        giant = empty_depth_png(10_000, 10_000)
        for name in ('depth/000000.png', 'depth/000001.png'):
            with self.subTest(name):
                self.spoil(name, giant)
                self.check_refused_without_memory(name, '10000x10000')
        description = {'depth': depth_fields(Camera(width=10_000, height=10_000))}
        write_capture(self.bad, [], **description)
        for path in (self.bad / 'depth').iterdir():
            path.write_bytes(giant)
        with self.subTest('stated too'):
            self.check_refused_without_memory(self.bad, '10000x10000', initial=self.bad)

    def test_stated_size_that_no_camera_has(self):
        for side in (10_000, 100_000, 1_000_000_000):
            with self.subTest(side):
                write_capture(self.bad, frames(), depth=depth_fields(Camera(width=side, height=side)))
                self.check_refused_without_memory(self.bad, initial=self.bad)

    def test_colour_of_100_megapixels(self):
        memory = None if program.is_sanitized() else limit(resource.RLIMIT_DATA, 300 << 20)
        self.spoil('color/000000.png', empty_depth_png(10_000, 10_000))
        self.check_refused_without_memory('color/000000.png', commands=['info'])
        self.check_compared_without_colour('color/000000.png', preexec=memory)
        jpeg = bytearray(encoded('.jpg', self.picture()))
        start_of_frame = jpeg.index(b'\xff\xc0')
        jpeg[start_of_frame + 5:start_of_frame + 9] = struct.pack('>HH', 10_000, 10_000)
        self.spoil('color/000000.png', bytes(jpeg))
        self.check_refused_without_memory('color/000000.png', '10000x10000', commands=['info'])
        self.check_compared_without_colour('color/000000.png', '10000x10000', preexec=memory)

    def test_header_of_any_size(self):
        nothing = zlib.compress(b'')
        for width, height in [(0, 0), (0, 48), (2**31 - 1, 2**31 - 1), (65_536, 65_536), (2**32 - 1, 1)]:
            with self.subTest(width=width, height=height):
                self.spoil('depth/000001.png', depth_png(width, height, nothing))
                self.check_refused_without_memory('depth/000001.png')


class BadPair(BadInputTest):
    def test_captures_that_do_not_match(self):
        table = {
            'size': (Camera(width=32), 0.001, ['32x48', '64x48']),
            'focal length': (Camera(fx=61.0), 0.001, ['intrinsics']),
            'principal point': (Camera(cy=25.0), 0.001, ['intrinsics']),
        }
        for name, (camera, unit_m, names) in table.items():
            with self.subTest(name):
                shutil.rmtree(self.bad, ignore_errors=True)
                write_capture(self.bad, frames(camera=camera, seed=2), depth=depth_fields(camera, unit_m))
                for method in ('constant', 'gaussian', 'calibrated'):
                    for pair in ([self.good, self.bad], [self.bad, self.good]):
                        self.check_fails('detect', *pair, '--method', method, '--out', self.out,
                                         names=['initial and final', *names])

    def test_gaussian_needs_two_frames(self):
        write_capture(self.bad, frames(1, seed=2))
        for pair in ([self.good, self.bad], [self.bad, self.good]):
            self.check_fails('detect', *pair, '--method', 'gaussian', '--out', self.out,
                             names=['gaussian', 'frame'])
        self.check_fails('detect', self.good, self.twin, '--method', 'gaussian', '--frames', 1, '--out', self.out,
                         names=['gaussian'])

    def test_noise_needs_four_frames(self):
        write_capture(self.bad, frames(3))
        self.check_fails('noise', self.bad, '--out', self.out, names=['3 frame'])


class BadOutput(BadInputTest):
    def check_output(self, *names, out=None, **run):
        out = self.out if out is None else out
        self.check_fails('detect', self.good, self.twin, '--out', out, names=names, **run)
        self.check_fails('noise', self.good, '--out', out, names=names, **run)

    def test_folder_that_is_not_empty(self):
        self.out.mkdir()
        (self.out / 'notes.txt').write_text('mine')
        self.check_output(self.out, '--overwrite')
        self.assertEqual((self.out / 'notes.txt').read_text(), 'mine')

    def test_file(self):
        self.out.write_text('mine')
        self.check_output(self.out)
        self.check_output(self.out, out=self.out / 'below')
        self.assertEqual(self.out.read_text(), 'mine')

    def test_dangling_link(self):
        self.out.symlink_to('nowhere')
        self.check_output(self.out)

    def test_path_at_which_no_folder_can_be_written(self):
        for path in ('/proc/rva-out', '/proc/none/rva-out', '/dev/null/rva-out'):
            with self.subTest(path):
                self.check_output(os.path.dirname(path), out=path)

    def test_name_that_is_too_long(self):
        self.check_output('x' * 300, out=self.folder / ('x' * 300))

    def test_parents_made_for_nothing_go_too(self):
        self.check_fails('detect', self.good, self.bad, '--out', self.folder / 'x' / 'y', names=['no such'])

    def write_loud_capture(self):
        """Pictures of it hardly compress."""
        depth = np.random.default_rng(5).integers(500, 5000, (FRAMES, 120, 160), np.uint16)
        shutil.rmtree(self.good)
        write_capture(self.good, depth, depth=depth_fields(Camera(160, 120)))

    def test_file_size_limit(self):
        self.write_loud_capture()
        self.check_output(self.out, preexec=limit(resource.RLIMIT_FSIZE, 4096))

    def test_full_disk(self):
        self.write_loud_capture()
        disk = self.folder / 'disk'
        disk.mkdir()
        mount = subprocess.run(['mount', '-t', 'tmpfs', '-o', 'size=32k', 'tmpfs', disk], capture_output=True,
                               encoding='utf-8', check=False)
        if mount.returncode != 0:
            self.skipTest(f'no small disk can be mounted here: {mount.stderr.strip()}')
        self.addCleanup(subprocess.run, ['umount', disk], check=True)
        self.check_output(disk, 'space', out=disk / 'out')


class BadPaths(BadInputTest):
    def test_paths_that_are_not_utf8(self):
        latin = os.fsencode(self.folder) + b'/caf\xe9'
        self.check_fails('detect', self.good, self.twin, '--out', latin, names=['caf\\xE9', 'UTF-8'])
        self.check_fails('noise', self.good, '--out', latin + b'/out', names=['caf\\xE9', 'UTF-8'])
        shutil.copytree(os.fsencode(self.good), latin)
        self.check_fails('info', latin, names=['caf\\xE9', 'UTF-8'])
        self.check_fails('detect', self.good, latin, '--out', self.out, names=['caf\\xE9', 'UTF-8'])

    def test_path_of_two_lines(self):
        self.check_fails('info', 'two\nlines', names=['two\\x0Alines'])

    def test_empty_paths(self):
        for arguments in (['info', ''], ['detect', self.good, self.twin, '--out', '']):
            with self.subTest(arguments[0]):
                done = self.rva(*arguments)
                self.assertIn(done.returncode, (1, 2))
                self.check_line(done.stderr)


class BadStdout(BadInputTest):
    def check_unprinted(self, *arguments):
        with open('/dev/full', 'w') as full:
            done = self.rva(*arguments, stdout=full)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.check_line(done.stderr, ['stdout'])
        closed = self.rva(*arguments, stdout=None, preexec=lambda: os.close(1))
        self.assertEqual(closed.returncode, 1, closed.stderr)

    def test_full_or_closed(self):
        for arguments in (['info', self.good], ['info', self.good, '--json'], ['options'],
                          ['--version'], ['--help']):
            with self.subTest(arguments[0]):
                self.check_unprinted(*arguments)

    def check_whole_or_nothing(self, *arguments, files):
        out = next(self.outs)
        before = self.names()
        with open('/dev/full', 'w') as full:
            done = self.rva(*arguments, '--out', out, stdout=full)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.check_line(done.stderr, ['stdout'])
        whole = [os.fsencode(path) for path in [out, *(out / file for file in files)]]
        self.assertIn(set(self.names()) - set(before), [set(), set(whole)])

    def test_result_that_cannot_be_printed(self):
        dots = np.full((CAMERA.height, CAMERA.width), 1000, np.uint16)
        dots[::4, ::4] = 900
        write_capture(self.bad, [dots] * FRAMES, pictures=[self.picture()], color=CAMERA.fields(), color_from_depth=IDENTITY)
        pictures = ['changes.png', 'depth_overlay.png', 'overlay.png']
        many = ['detect', self.good, self.bad, '--method', 'constant', '--join', 0]
        for arguments in (many, [*many, '--json'], ['detect', self.good, self.twin, '--method', 'gaussian']):
            with self.subTest(arguments=arguments[3:]):
                self.check_whole_or_nothing(*arguments, files=pictures + ['detections.json'])
        with self.subTest('noise'):
            self.check_whole_or_nothing('noise', self.good, '--json',
                                        files=['std.png', 'drift.png', 'noise.json'])


class Interruption(BadInputTest):
    LINKS = 4000
    ENOUGH_BYTES = 5_000_000

    def setUp(self):
        super().setUp()
        self.long = self.folder / 'long'
        noise = np.random.default_rng(6).integers(500, 5000, (2, 240, 320), np.uint16)
        self.camera = Camera(320, 240)
        write_capture(self.long, noise, depth=depth_fields(self.camera))

    def long_again(self):
        return record_again(self.long, self.folder / 'long-again', copy_function=os.link)

    def repeat(self, image):
        for i in range(2, self.LINKS):
            os.link(image, image.with_name(f'{i:06d}.png'))

    def check_interrupted(self, sent, *arguments):
        """Sends the signal once the program has read more than a few frames."""
        before = self.names()
        process = subprocess.Popen(self.command(*arguments), stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   encoding='utf-8')
        try:
            self.wait_until_it_has_read(process, self.ENOUGH_BYTES)
            process.send_signal(sent)
            stdout, stderr = process.communicate(timeout=program.TIMEOUT_S)
        finally:
            process.kill()
            process.wait()
        self.assertEqual(process.returncode, 128 + sent, stderr)
        self.assertEqual(stdout, '')
        self.assertNotIn('internal error', stderr)
        self.assertEqual(self.names(), before)

    def wait_until_it_has_read(self, process, size):
        deadline = time.monotonic() + program.TIMEOUT_S
        while process.poll() is None and time.monotonic() < deadline:
            with open(f'/proc/{process.pid}/io') as figures:
                if int(figures.readline().removeprefix('rchar:')) > size:
                    return
            time.sleep(0.001)
        self.fail('it never came to the frames')

    def test_while_depth_is_read(self):
        self.repeat(self.long / 'depth' / '000000.png')
        detect = ['detect', self.long, self.long_again(), '--out', self.out]
        self.check_interrupted(signal.SIGINT, *detect)
        self.check_interrupted(signal.SIGTERM, *detect)
        self.check_interrupted(signal.SIGINT, 'noise', self.long, '--out', self.out)
        self.check_interrupted(signal.SIGINT, 'info', self.long)

    def test_earlier_result_stays(self):
        self.repeat(self.long / 'depth' / '000000.png')
        self.succeed('detect', self.good, self.twin, '--out', self.out)
        before = (self.out / 'detections.json').read_bytes()
        detect = ['detect', self.long, self.long_again(), '--out', self.out]
        self.check_interrupted(signal.SIGINT, *detect, '--overwrite')
        self.assertEqual((self.out / 'detections.json').read_bytes(), before)

    def test_while_colour_is_read(self):
        image = self.long / 'color' / '000000.png'
        write_image(image, np.random.default_rng(7).integers(0, 255, (240, 320, 3), np.uint8))
        self.repeat(image)
        self.check_interrupted(signal.SIGINT, 'info', self.long)


class WrongUsage(BadInputTest):
    def check_usage(self, *arguments, name):
        before = self.names()
        done = self.rva(*arguments)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stdout, '')
        self.assertIn(name, done.stderr)
        self.assertEqual(self.names(), before)
        return done.stderr

    def test_numbers_out_of_range(self):
        table = {
            'detect': {'--threshold': [-1, 'nan', 'inf', 101], '--sigmas': ['nan', -0.5, 1001],
                       '--frames': [-3, 32768], '--min-blob': [-1], '--join': [-1, 'nan'], '--clip': [-1],
                       '--intrinsics': ['-60,60,30,20', '60,0,30,20', 'nan,60,30,20', '60,60,nan,20']},
            'noise': {'--alpha': [0, 0.6, 'nan', -1], '--welch-frames': [1, 0, -1], '--bin': [0, 'nan', 11],
                      '--frames': [-1]},
        }
        captures = {'detect': [self.good, self.twin], 'noise': [self.good]}
        for command, options in table.items():
            for option, values in options.items():
                for value in values:
                    with self.subTest(command, option=option, value=value):
                        self.check_line(self.check_usage(command, *captures[command], '--out', self.out,
                                                         f'{option}={value}', name=option))

    def test_what_the_command_line_does_not_support(self):
        pair = [self.good, self.twin]
        out = ['--out', self.out]
        table = {
            'no command': ([], 'subcommand'),
            'command': (['inspect-all'], 'inspect-all'),
            'option': (['detect', *pair, *out, '--fast'], '--fast'),
            'method': (['detect', *pair, *out, '--method', 'magic'], 'magic'),
            'method by number': (['detect', *pair, *out, '--method', '1'], '--method'),
            'no output of detect': (['detect', *pair], '--out'),
            'no output of noise': (['noise', self.good], '--out'),
            'one capture': (['detect', self.good, *out], 'FINAL'),
            'no capture': (['info'], 'PATH'),
            'three captures': (['detect', *pair, self.bad, *out], str(self.bad)),
            'part of a frame': (['detect', *pair, *out, '--frames', '1.5'], '--frames'),
            'frames beyond counting': (['detect', *pair, *out, '--frames', '99999999999'], '--frames'),
            'text for a number': (['detect', *pair, *out, '--threshold', 'much'], '--threshold'),
            'three intrinsics': (['info', self.good, '--intrinsics', '1,2,3'], '--intrinsics'),
            'text for intrinsics': (['info', self.good, '--intrinsics', '1,2,3,x'], '--intrinsics'),
        }
        for name, (arguments, named) in table.items():
            with self.subTest(name):
                self.check_usage(*arguments, name=named)

    def test_help_is_no_error(self):
        for arguments in (['--help'], ['detect', '--help'], ['noise', '--help'], ['info', '--help'],
                          ['options', '--help'], ['--version']):
            with self.subTest(arguments[0]):
                done = self.succeed(*arguments)
                self.assertTrue(done.stdout)
                self.assertEqual(done.stderr, '')


if __name__ == '__main__':
    program.main()
