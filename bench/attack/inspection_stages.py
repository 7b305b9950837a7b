"""Stages that kill the server at each step of an inspection and start it again: nothing acknowledged may be lost, and the
inspection must be completed."""
import copy
import dataclasses
import random
import shutil
import threading
import time

from checks import check_captures, check_restarted, check_stopped
from inspection_steps import PASSWORD, Steps
from killing import Moment, Unkilled, draw_moment
from ledger import Ledger
from server import BROKEN_OFF, Refused, Server
from setting import CAMERA, STUCK, Attempt, Problem, Unusable


@dataclasses.dataclass(frozen=True)
class Step:
    """A step that is attacked: its name, the method of Steps that performs it, and its share of the kills with and without a
    robot."""
    name: str
    act: str
    weight_with_robot: int
    weight_without: int


STORY = (Step('begin', 'begin', 1, 2), Step('views', 'views', 1, 0), Step('initial', 'initial', 2, 3),
         Step('regions', 'regions', 0, 2), Step('final', 'final', 2, 4), Step('compare', 'compare', 1, 4),
         Step('decide', 'decide', 1, 3), Step('retake', 'final', 3, 4), Step('decide-again', 'decide', 0, 1),
         Step('retake-again', 'final', 2, 3), Step('mark', 'mark', 2, 3), Step('decide-last', 'decide', 0, 0),
         Step('decide-marks', 'decide_marks', 1, 2), Step('close', 'close', 1, 3), Step('delete', 'delete', 1, 2),
         Step('accounts', 'accounts', 0, 2), Step('sign', 'sign', 0, 3))
WORK_BEGINS = 'final'  # from this step on, the bay is in its state after the work


class WithRobot:
    name = 'robot'

    def arguments(self, setting, work_done):
        return '--camera', CAMERA, '--robot', 'sim'

    def begin(self, server, work_done):
        server.ask('POST', 'simulation', {'done': work_done})


class WithoutRobot:
    """The server replays a recording without a pose, like that of a real camera without a robot."""
    name = 'none'

    def arguments(self, setting, work_done):
        return '--camera', f'replay:{setting.input("standing-after" if work_done else "standing-before")}', '--robot', 'none'

    def begin(self, server, work_done):
        pass


class Story:
    """An inspection without a kill. Before each step, copies of its data folder and ledger are kept, from which killed
    inspections start."""

    def __init__(self, rig):
        self.rig = rig
        self.steps = [step for step in STORY if step.name != 'views' or isinstance(rig, WithRobot)]
        self.kept = {}  # by step: data folder, ledger, Unkilled
        self.data, self.ledger = None, Ledger()

    def before(self, setting, step):
        """The data folder and ledger before a step, and the duration and calls of the step. Advances as far as needed."""
        while step.name not in self.kept:
            self._advance(setting, self.steps[len(self.kept)])
        return self.kept[step.name]

    def work_done(self, step):
        names = [each.name for each in self.steps]
        return names.index(step.name) >= names.index(WORK_BEGINS)

    def _advance(self, setting, step):
        if self.data is None:
            self.data = setting.fresh(f'story-{self.rig.name}')
            self._begin_another(setting)
        kept = setting.fresh(f'story-{self.rig.name}-{step.name}')
        shutil.copytree(self.data, kept, dirs_exist_ok=True)
        ledger = copy.deepcopy(self.ledger)
        control = setting.killer.control()
        server = start(setting, self.rig, self.data, setting.folder / 'story.log', self.work_done(step), self.ledger,
                       setting.killer.environment(control))
        try:
            steps = Steps(setting, server, self.ledger, self.data)
            control.arm()
            began = time.monotonic()
            getattr(steps, step.act)()
            unkilled = Unkilled(time.monotonic() - began, control.calls())
            steps.look()
        finally:
            server.stop()
            control.close()
        self.kept[step.name] = kept, ledger, unkilled

    def _begin_another(self, setting):
        """Begins an inspection on which nothing is done, and which must not change."""
        server = start(setting, self.rig, self.data, setting.folder / 'story.log', False, self.ledger)
        try:
            Steps(setting, server, self.ledger, self.data).begin_another()
        finally:
            server.stop()


def start(setting, rig, data, log, work_done, ledger, environment=None):
    server = Server(setting, data, rig.arguments(setting, work_done), log, environment, ('ann', PASSWORD))
    try:
        rig.begin(server, work_done)
    except BaseException:
        server.kill()
        raise
    return server


class InspectionStage:
    def __init__(self, rig, story, step, weight):
        self.name, self.rig, self.story, self.step, self.weight = f'serve-{rig.name}-{step.name}', rig, story, step, weight

    def attempt(self, setting, number, seed, evidence):
        """Kills the server once at this step; the files are kept in the folder `evidence`."""
        try:
            kept, ledger, unkilled = self.story.before(setting, self.step)
        except (Refused, *BROKEN_OFF) as error:
            raise Unusable(f'without a kill: {error}') from error
        moment = draw_moment(random.Random(f'{seed} {self.name} {number}'), unkilled)
        data = evidence / 'data'
        shutil.copytree(kept, data)
        ledger = copy.deepcopy(ledger)
        moment, problems = self._kill(setting, data, ledger, moment, evidence)
        ledger.note_captures(data, acknowledged=bool(ledger.owed))
        shutil.copytree(data, evidence / 'after-kill')
        problems += check_captures(ledger, data, 'just after the kill')
        problems += self._go_on(setting, data, ledger, evidence)
        return Attempt(self.name, number, moment, True, list(dict.fromkeys(problems)))

    def _kill(self, setting, data, ledger, moment, evidence):
        """Kills the server at the given moment, or after the step if it ends before, in which case it was acknowledged.

        Returns the moment of the kill, and problems."""
        control = setting.killer.control()
        server = start(setting, self.rig, data, evidence / 'killed.log', self.story.work_done(self.step), ledger,
                       setting.killer.environment(control, moment))
        timer = threading.Timer(moment.seconds or 0.0, server.process.kill)
        problems = []
        began = time.monotonic()
        control.arm()
        if not moment.at_call:
            timer.start()
        try:
            getattr(Steps(setting, server, ledger, data), self.step.act)()
        except BROKEN_OFF as error:
            if not server.is_dead():
                problems = [Problem(STUCK, f'not killed, and yet: {error!r}')]
        except Refused as refused:
            problems = [Problem(STUCK, f'not killed, and yet: {refused}')]
        finally:
            timer.cancel()
            server.kill()
        if moment.at_call and not control.struck():
            moment = Moment(seconds=time.monotonic() - began)
        control.close()
        return moment, problems

    def _go_on(self, setting, data, ledger, evidence):
        """Starts the server again and performs the missing steps, then takes the final side once more."""
        problems, logs = [], []

        def started(work_done):
            logs.append(evidence / f'restarted-{len(logs)}.log')
            return start(setting, self.rig, data, logs[-1], work_done, ledger)

        try:
            work_done = self.story.work_done(self.step)
            server = started(work_done)
            try:
                problems += check_restarted(setting, server, ledger, data)
                steps = Steps(setting, server, ledger, data)
                if not work_done:
                    steps.to_the_work()
                    server.stop()
                    server = steps.server = started(True)
                steps.to_the_end()
            finally:
                if not server.stop():
                    problems.append(Problem(STUCK, 'the server does not end'))
        except (Refused, *BROKEN_OFF) as error:
            return [*problems, Problem(STUCK, f'cannot be carried to its end: {error!r}')]
        if ledger.known()['stage'] != 'done':
            problems.append(Problem(STUCK, f'it was closed, but its stage is {ledger.known()["stage"]}'))
        said = ''.join(log.read_text(errors='replace') for log in logs)
        return problems + check_captures(ledger, data, 'at the end') + check_stopped(ledger, data, said)


def inspection_stages():
    stages = []
    for rig, weight_of in ((WithRobot(), lambda step: step.weight_with_robot), (WithoutRobot(), lambda step: step.weight_without)):
        story = Story(rig)
        stages += [InspectionStage(rig, story, step, weight_of(step)) for step in story.steps if weight_of(step) > 0]
    return stages
