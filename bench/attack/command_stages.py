"""The stages that kill commands."""
import shutil

from command_stage import CommandStage
from contents import contents, faults, few
from killing import run
from setting import CAMERA, FEW_VIEWS, LOST, SCENE, STUCK, UNEXPLAINED, Problem
from stored import integrity

MAP = ('map', '--camera', CAMERA, '--robot', 'sim', FEW_VIEWS, '--frames', 1, '--out', 'map.ply')
MAP_FILES = ('map.ply', 'map.pcd', 'map.json')


def earlier(name, target):
    """Returns a function that puts an earlier result, a folder or a file, where the command will write."""
    def prepare(setting, place):
        source = setting.input(name)
        if source.is_dir():
            shutil.copytree(source, place / target, dirs_exist_ok=True)
        else:
            shutil.copy(source, place / target)
    return prepare


class MapStage(CommandStage):
    """A map consists of three files and a folder of views. Views may exist before the map does, for use by --resume. If there
    was no earlier map, the .ply is written last, and its presence means that the map is complete."""

    def judge(self, setting, place, acknowledged):
        present = contents(place)
        files, old, new = ({name: tree[name] for name in MAP_FILES if name in tree} for tree in (present, self.old, self.new))
        if not old and 'map.ply' not in files:
            files = {}
        problems = self.judge_files(files, old, new, acknowledged)
        problems += self._judge_views(present, is_new=bool(files) and files.get('map.ply') != old.get('map.ply'))
        for path in [place / name for name in files] + sorted((place / 'map.views').glob('[0-9][0-9][0-9]')):
            problems += [Problem(UNEXPLAINED, fault) for fault in faults(setting.rva, path)]
        return problems

    def _judge_views(self, present, is_new):
        in_views = {name: digest for name, digest in present.items() if name.startswith('map.views/')}
        if is_new:
            missing = {name for name in self.new if name.startswith('map.views/')} - set(in_views)
            return [Problem(UNEXPLAINED, f'the map is there, but not all of its views: no {few(missing)}')] if missing else []
        earlier_views = {name: digest for name, digest in self.old.items()
                         if name.startswith('map.views/') and '.partial' not in name and digest}
        changed = {name for name, digest in earlier_views.items() if in_views.get(name) != digest}
        if not changed:
            return []
        if {earlier_views[name] for name in changed} - set(present.values()):
            return [Problem(LOST, f'earlier views are gone: {few(changed)}')]
        return [Problem(UNEXPLAINED, f'the earlier map is there, but its views are not in their place: {few(changed)}')]


def interrupted_map(setting, place):
    """The files of a killed `rva map`: two of three views, and remains of the third."""
    shutil.copytree(setting.input('earlier-map'), place, dirs_exist_ok=True)
    for name in MAP_FILES:
        (place / name).unlink()
    (place / 'map.views' / '002').rename(place / 'map.views' / '002.partial-1-0')


def map_without_a_view(setting, place):
    shutil.copytree(setting.input('earlier-map'), place, dirs_exist_ok=True)
    shutil.rmtree(place / 'map.views' / '002')


class AccountStage(CommandStage):
    """Accounts are rows of a database, whose bytes cannot be compared, so the program lists them."""

    def __init__(self, name, weight, arguments, names_before, names_after, prepare=None):
        super().__init__(name, weight, arguments, prepare, said='correct horse\n')
        self.names_before, self.names_after = names_before, names_after

    def judge(self, setting, place, acknowledged):
        names = self._names(setting, place)
        expected = [self.names_after] if acknowledged else [self.names_before, self.names_after]
        problems = [Problem(LOST, fault) for fault in integrity(place / 'data' / 'rva.db')]
        if names is None:
            problems.append(Problem(STUCK, 'rva account list fails'))
        elif names not in expected:
            problems.append(Problem(LOST, f'accounts are {names}, not one of {expected}'))
        return problems

    def accepts(self, setting, place, ended):
        return 'is not an account' in ended.stderr and self._names(setting, place) == self.names_after

    def run_again(self, setting, place):
        problems = super().run_again(setting, place)
        names = self._names(setting, place)
        return problems if names == self.names_after else [*problems, Problem(STUCK, f'run again, accounts are {names}')]

    def _names(self, setting, place):
        ended = run([setting.rva, 'account', 'list', '--data', 'data'], place)
        return sorted(line.split()[1] for line in ended.stdout.splitlines()) if ended.status == 0 else None


def command_stages():
    account = ('account', 'add', 'cid', '--role', 'operator', '--data', 'data')
    simulate = ('simulate', SCENE, '--frames', 2, '--out', 'out')
    record = ('record', '--camera', CAMERA, '--frames', 2, '--out', 'out')

    def detect(setting):
        return ['detect', setting.input('before'), setting.input('after'), '--out', 'out']

    def always(*arguments):
        return lambda setting: arguments

    return [
        CommandStage('simulate', 3, always(*simulate)),
        CommandStage('simulate-overwrite', 3, always(*simulate, '--overwrite'), earlier('earlier-capture', 'out')),
        CommandStage('record', 4, always(*record)),
        CommandStage('record-overwrite', 4, always(*record, '--overwrite'), earlier('earlier-recording', 'out')),
        CommandStage('detect', 3, detect),
        CommandStage('detect-overwrite', 4, lambda setting: [*detect(setting), '--overwrite'],
                     earlier('earlier-detection', 'out')),
        CommandStage('export-open3d', 3, lambda setting: ['export', setting.input('after'), '--to', 'open3d', '--out', 'out']),
        CommandStage('export-ply', 3, lambda setting: ['export', setting.input('after'), '--to', 'ply', '--out', 'out.ply']),
        CommandStage('noise', 3, lambda setting: ['noise', setting.input('after'), '--out', 'out']),
        CommandStage('calibrate', 2, lambda setting: [
            'calibrate', *sorted((setting.input('views') / 'map.views').iterdir()), '--out', 'robot.json']),
        MapStage('map', 5, always(*MAP)),
        MapStage('map-overwrite', 5, always(*MAP, '--overwrite'), earlier('earlier-map', '.')),
        MapStage('map-resume', 4, always(*MAP, '--resume'), interrupted_map),
        MapStage('map-resume-overwrite', 4, always(*MAP, '--resume', '--overwrite'), map_without_a_view),
        AccountStage('account-add-first', 3, always(*account), [], ['cid']),
        AccountStage('account-add', 3, always(*account), ['ann', 'bob'], ['ann', 'bob', 'cid'], earlier('accounts', 'data')),
        AccountStage('account-remove', 3, always('account', 'remove', 'bob', '--data', 'data'), ['ann', 'bob'], ['ann'],
                     earlier('accounts', 'data')),
    ]
