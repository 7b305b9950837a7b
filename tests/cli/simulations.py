"""Scenes and simulated captures, shared by the tests of one class."""
import json
import pathlib
import subprocess
import tempfile
import time

import numpy as np

import program
from captures import read_image

SCENES = pathlib.Path(__file__).resolve().parents[2] / 'data' / 'scenes'
TOOLS = SCENES / 'three-tools.yaml'
WALL = SCENES / 'wall.yaml'
CHEAP = ('--supersampling', 1)


COLLARS = [('0.53', 0.135, 0.378), ('0.36', -0.085, 0.562), ('0.27', -0.195, 0.562), ('0.44', 0.025, 0.745),
           ('0.53', 0.135, 0.745)]


def write_bays(folder, light):
    """Scenes of one bay in this light: before the work, the same unchanged, and with five collars."""
    head = f'format: rva-scene\nversion: 1\nwing: {{}}\nlight: {light}\nrobot: {{ at_m: [0, 0.10, 0], tilt_deg: -20 }}\n'
    debris = 'debris:\n' + ''.join(f'  - {{ kind: collar-{inches}, on: [{x}, {y}] }}\n' for inches, x, y in COLLARS)
    scenes = {}
    for side, text in {'before': head, 'unchanged': head, 'after': head + debris}.items():
        scenes[side] = folder / f'{side}.yaml'
        scenes[side].write_text(text)
    return scenes


def description(capture):
    return json.loads((capture / 'capture.json').read_text())


def truth(capture):
    return json.loads((capture / 'truth' / 'truth.json').read_text())


def object_named(capture, name):
    return next(entry for entry in truth(capture)['objects'] if entry['name'] == name)


def frame_files(capture, kind='depth'):
    return sorted((capture / kind).glob('*.png'))


def depth_frames(capture):
    return np.stack([read_image(path) for path in frame_files(capture)])


def contents(folder):
    """Every file of a folder, by its path inside."""
    return {path.relative_to(folder): path.read_bytes() for path in folder.rglob('*') if path.is_file()}


class SimulationTest(program.ProgramTest):
    """Gives a class of tests a folder for captures that all of them read."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        temporary = tempfile.TemporaryDirectory(prefix='rva-test-')
        cls.addClassCleanup(temporary.cleanup)
        cls.shared = pathlib.Path(temporary.name).resolve()

    @classmethod
    def make(cls, name, scene, *options):
        """A capture in the shared folder."""
        made = subprocess.run([program.PROGRAM, 'simulate', scene, '--out', cls.shared / name,
                               *(str(option) for option in options)],
                              stdin=subprocess.DEVNULL, capture_output=True, encoding='utf-8',
                              timeout=program.TIMEOUT_S, check=False)
        assert made.returncode == 0, made.stderr
        return cls.shared / name

    def check_interrupted(self, sent, *arguments):
        """Sends the signal as soon as a frame is written."""
        before = self.names()
        process = subprocess.Popen(self.command(*arguments), stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   stdin=subprocess.DEVNULL, encoding='utf-8', cwd=self.folder)
        try:
            self.wait_for_a_frame(process)
            process.send_signal(sent)
            stdout, stderr = process.communicate(timeout=program.TIMEOUT_S)
        finally:
            process.kill()
            process.wait()
        self.assertEqual((process.returncode, stdout, stderr), (128 + sent, '', ''))
        self.assertEqual(self.names(), before)

    def wait_for_a_frame(self, process):
        deadline = time.monotonic() + program.TIMEOUT_S
        while process.poll() is None and time.monotonic() < deadline:
            if any(self.folder.glob('*.partial-*/depth/*.png')):
                return
            time.sleep(0.01)
        self.fail('it never came to the frames')
