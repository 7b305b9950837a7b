"""Kills a program at a random moment: at a time within its duration, or at one of its system calls."""
import dataclasses
import mmap
import os
import pathlib
import struct
import subprocess
import time

HERE = pathlib.Path(__file__).resolve().parent
KINDS = ('rename', 'write', 'fsync')
SHARE_AT_CALLS = 1 / 3
COMMAND_LIMIT_S = 90
FIELDS = struct.Struct(f'={2 + len(KINDS)}Q')  # the layout of struct control in kill_at.c


@dataclasses.dataclass(frozen=True)
class Unkilled:
    """The duration and system calls of a stage without a kill."""
    seconds: float
    calls: dict  # number of calls by kind


@dataclasses.dataclass(frozen=True)
class Moment:
    """The moment of a kill: after some seconds, or before or after the call of this kind and number."""
    seconds: float | None = None
    kind: str | None = None
    number: int = 0
    when: str = ''

    @property
    def at_call(self):
        return self.kind is not None

    def __str__(self):
        if self.at_call:
            return f'{self.when} {self.kind} {self.number}'
        return f'after {self.seconds:.3f} s'


def draw_moment(rng, unkilled):
    kinds = [kind for kind in KINDS if unkilled.calls[kind] > 0]
    if kinds and rng.random() < SHARE_AT_CALLS:
        kind = rng.choice(kinds)
        return Moment(kind=kind, number=rng.randint(1, unkilled.calls[kind]), when=rng.choice(('before', 'after')))
    return Moment(seconds=rng.uniform(0.0, unkilled.seconds))


class Control:
    """The memory shared with a program that has kill_at.c loaded; it outlives the program."""

    def __init__(self, file):
        self.file = file
        file.write_bytes(bytes(FIELDS.size))
        with file.open('r+b') as opened:
            self.memory = mmap.mmap(opened.fileno(), FIELDS.size)

    def arm(self):
        """Starts the counting of calls."""
        self.memory[:8] = struct.pack('=Q', 1)

    def struck(self):
        return FIELDS.unpack(self.memory)[1] != 0

    def calls(self):
        return dict(zip(KINDS, FIELDS.unpack(self.memory)[2:]))

    def close(self):
        self.memory.close()


class Killer:
    """The library that is loaded into the programs under attack, and the files that control it."""

    def __init__(self, folder):
        self.folder = folder
        self.library = folder / 'kill_at.so'
        subprocess.run(['cc', '-shared', '-fPIC', '-O2', '-o', self.library, HERE / 'kill_at.c', '-ldl'], check=True)

    def control(self):
        return Control(self.folder / 'control')

    def environment(self, control, moment=None):
        added = {'LD_PRELOAD': str(self.library), 'KILL_AT_FOLDER': os.path.realpath(self.folder),
                 'KILL_AT_CONTROL': str(control.file)}
        if moment and moment.at_call:
            added |= {'KILL_AT_KIND': str(KINDS.index(moment.kind)), 'KILL_AT_NUMBER': str(moment.number),
                      'KILL_AT_WHEN': moment.when}
        return os.environ | added


@dataclasses.dataclass(frozen=True)
class Ended:
    """How a command ended: its status is negative if a signal ended it, and None if it exceeded the time limit."""
    status: int | None
    stdout: str
    stderr: str
    seconds: float

    @property
    def killed(self):
        return self.status == -9

    def last_line(self):
        lines = self.stderr.strip().splitlines()
        if self.status is None:
            return f'did not end within {COMMAND_LIMIT_S} s'
        return lines[-1] if lines else f'status {self.status}'


def run(arguments, folder, said='', environment=None, kill_after_s=None):
    """Runs a command to its end, or until it is killed."""
    start = time.monotonic()
    with subprocess.Popen([str(argument) for argument in arguments], cwd=folder, env=environment, encoding='utf-8',
                          errors='replace', stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        too_long = False
        try:
            stdout, stderr = process.communicate(said, timeout=COMMAND_LIMIT_S if kill_after_s is None else kill_after_s)
        except subprocess.TimeoutExpired:
            too_long = kill_after_s is None
            process.kill()
            stdout, stderr = process.communicate()
        finally:
            process.kill()
    return Ended(None if too_long else process.returncode, stdout, stderr, time.monotonic() - start)
