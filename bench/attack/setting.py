"""The setting that all stages share: the program, the work folder, and captures and maps that are made once and only read."""
import dataclasses
import json
import pathlib
import shutil

from killing import Killer, run

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENE = ROOT / 'data' / 'scenes' / 'three-tools.yaml'
CAMERA = f'sim:{SCENE}'
FEW_VIEWS = '--grid=-12,12,3,-30,-30,1'
VIEWS_TO_CALIBRATE = '--grid=-20,20,3,-32,-14,2'

LOST, UNEXPLAINED, STUCK = 'lost', 'unexplained', 'stuck'


@dataclasses.dataclass(frozen=True)
class Problem:
    """LOST: acknowledged data is gone or changed. UNEXPLAINED: incomplete or left-over data was not reported. STUCK: the stage
    cannot be continued."""
    kind: str
    text: str


@dataclasses.dataclass(frozen=True)
class Attempt:
    """One run that was to be killed at `moment`. `killed` is false if it ended before; without a moment, it could not be run
    at all."""
    stage: str
    number: int
    moment: object
    killed: bool
    problems: list

    def has(self, kind):
        return any(problem.kind == kind for problem in self.problems)


class Unusable(Exception):
    """A prerequisite of the stages fails even without a kill."""


class Setting:
    def __init__(self, rva, console, folder):
        self.rva, self.console, self.folder = rva, console, folder
        self.killer = Killer(folder)
        self.inputs = folder / 'inputs'
        self.inputs.mkdir()

    def succeed(self, *arguments, said=''):
        ended = run([self.rva, *arguments], self.inputs, said)
        if ended.status != 0:
            raise Unusable(f'rva {" ".join(str(argument) for argument in arguments)}: {ended.last_line()}')
        return ended

    def input(self, name):
        """The path of a capture or map by name, which is made on first use."""
        path = self.inputs / name
        if not path.exists():
            getattr(self, '_make_' + name.partition('.')[0].replace('-', '_'))(path)
        return path

    def fresh(self, name):
        """An empty folder for one attempt."""
        path = self.folder / name
        shutil.rmtree(path, ignore_errors=True)
        path.mkdir()
        return path

    def _make_before(self, path):
        self.succeed('simulate', SCENE, '--debris', 'none', '--frames', 4, '--out', path)

    def _make_after(self, path):
        self.succeed('simulate', SCENE, '--seed', 2, '--frames', 4, '--out', path)

    def _make_earlier_capture(self, path):
        self.succeed('simulate', SCENE, '--seed', 3, '--frames', 3, '--out', path)

    def _make_earlier_recording(self, path):
        self.succeed('record', '--camera', CAMERA, '--seed', 3, '--frames', 3, '--out', path)

    def _make_earlier_detection(self, path):
        self.succeed('detect', self.input('after'), self.input('before'), '--out', path)

    def _make_earlier_map(self, path):
        """Uses another seed and voxel size, so that all of its files differ from those of the map that replaces it."""
        self.succeed('map', '--camera', CAMERA, '--robot', 'sim', FEW_VIEWS, '--frames', 1, '--seed', 2, '--voxel', 6,
                     '--out', path / 'map.ply')

    def _make_views(self, path):
        self.succeed('map', '--camera', CAMERA, '--robot', 'sim', VIEWS_TO_CALIBRATE, '--frames', 1, '--out',
                     path / 'map.ply')

    def _make_accounts(self, path):
        for name in ('ann', 'bob'):
            self.succeed('account', 'add', name, '--data', path, said='correct horse\n')

    def _make_standing_before(self, path):
        self._make_standing(path, '--debris', 'none')

    def _make_standing_after(self, path):
        self._make_standing(path, '--seed', 2)

    def _make_standing(self, path, *options):
        """A recording of a static camera, without a pose, like that of a camera without a robot."""
        self.succeed('simulate', SCENE, '--frames', 8, '--all-colors', '--out', path, *options)
        description = json.loads((path / 'capture.json').read_text())
        del description['pose']
        (path / 'capture.json').write_text(json.dumps(description))
