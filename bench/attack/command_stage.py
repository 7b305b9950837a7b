"""Stages that kill a command: the result must be the earlier one or complete, and the command must succeed if run again."""
import random
import shutil

from contents import contents, faults, few, topmost
from killing import Unkilled, draw_moment, run
from setting import LOST, STUCK, UNEXPLAINED, Attempt, Problem, Unusable

OPTIONS_THAT_MESSAGES_NAME = ('--resume', '--overwrite')


class CommandStage:
    """
    arguments: function from the setting to the arguments of rva, which runs in a separate folder
    prepare:   function that puts earlier files into that folder
    said:      text for the standard input of the command
    """

    def __init__(self, name, weight, arguments, prepare=None, said=''):
        self.name, self.weight, self.arguments, self.said = name, weight, arguments, said
        self.prepare = prepare or (lambda setting, place: None)
        self.unkilled = None
        self.old, self.new = {}, {}  # contents of the folder before and after an unkilled run

    def measure(self, setting):
        """Runs the command once without a kill, to measure its duration, its system calls and its results."""
        if self.unkilled:
            return
        place = setting.fresh('unkilled')
        self.prepare(setting, place)
        self.old = contents(place)
        control = setting.killer.control()
        control.arm()
        ended = self._run(setting, place, environment=setting.killer.environment(control))
        if ended.status != 0:
            raise Unusable(f'{self.name}: {ended.last_line()}')
        self.unkilled = Unkilled(ended.seconds, control.calls())
        self.new = contents(place)
        control.close()

    def attempt(self, setting, number, seed, evidence):
        """Kills the command once and checks the results, which are kept in the folder `evidence`."""
        self.measure(setting)
        moment = draw_moment(random.Random(f'{seed} {self.name} {number}'), self.unkilled)
        place = evidence / 'place'
        place.mkdir()
        self.prepare(setting, place)
        control = setting.killer.control()
        control.arm()
        ended = self._run(setting, place, environment=setting.killer.environment(control, moment),
                          kill_after_s=moment.seconds)
        control.close()
        shutil.copytree(place, evidence / 'after-kill', symlinks=True)
        problems = self.judge(setting, evidence / 'after-kill', acknowledged=bool(ended.stdout))
        if not ended.killed and ended.status != 0:
            problems.append(Problem(STUCK, f'it was not killed, and fails: {ended.last_line()}'))
        problems += self.run_again(setting, place)
        return Attempt(self.name, number, moment, ended.killed, problems)

    def judge(self, setting, place, acknowledged):
        """Problems with the result just after the kill. `acknowledged`: the command had reported that it was done."""
        results = {name.partition('/')[0] for name in (*self.old, *self.new)}
        present = {name: digest for name, digest in contents(place).items() if name.partition('/')[0] in results}
        problems = self.judge_files(present, self.old, self.new, acknowledged)
        return problems + [Problem(UNEXPLAINED, fault) for name in sorted(results) if (place / name).exists()
                           for fault in faults(setting.rva, place / name)]

    def judge_files(self, present, old, new, acknowledged=False):
        if present == old:
            return [Problem(LOST, 'it reported that it was done, but the result is missing')] if acknowledged else []
        stale = self._stale(present, old, new)
        if not stale and set(present) == set(new):
            return []
        if old and not present:
            wrong = 'the earlier result is gone, and there is no new one'
        elif stale:
            wrong = f'a mixture: {few(stale)} of the earlier result among {few(set(present) - stale)}'
        else:
            missing, added = set(new) - set(present), set(present) - set(new)
            wrong = f'incomplete: {few(missing) or "nothing"} is missing, {few(added) or "nothing"} is there beyond it'
        return [Problem(LOST if old else UNEXPLAINED, wrong)]

    def run_again(self, setting, place):
        """Runs the command again and, if it refuses, once more with the option that its message names, as a user would."""
        ended = self._run(setting, place)
        said = ended.stderr
        if ended.status not in (0, None):
            option = self._option_named(setting, ended.stderr)
            if option:
                ended = self._run(setting, place, option)
                said += ended.stderr
        if ended.status != 0 and not self.accepts(setting, place, ended):
            return [Problem(STUCK, f'run again, it fails: {ended.last_line()}')]
        return self._judge_end(setting, place, said)

    def accepts(self, setting, place, ended):
        """Whether it is acceptable that the command failed when run again."""
        return False

    def _judge_end(self, setting, place, said):
        left = contents(place)
        extra = topmost(set(left) - set(self.new))
        problems = [Problem(UNEXPLAINED, f'{name} is left over, and the program did not report it') for name in extra
                    if name.rstrip('/').rpartition('/')[2] not in said]
        present = {name: digest for name, digest in left.items() if name in self.new}
        if set(present) != set(self.new):
            problems.append(Problem(STUCK, f'run again, it does not write {few(set(self.new) - set(present))}'))
        stale = self._stale(present, self.old, self.new)
        if stale:
            problems.append(Problem(STUCK, f'run again, it leaves {few(stale)} of the earlier result'))
        for name in sorted({name.partition('/')[0] for name in present}):
            problems += [Problem(STUCK, f'run again: {fault}') for fault in faults(setting.rva, place / name)]
        return problems

    def _stale(self, present, old, new):
        """Files of the earlier result that a run without a kill replaces."""
        return {name for name, digest in present.items() if digest and digest == old.get(name) and digest != new.get(name)}

    def _option_named(self, setting, message):
        named = [option for option in OPTIONS_THAT_MESSAGES_NAME if option in message]
        return next((option for option in named if option not in self.arguments(setting)), None)

    def _run(self, setting, place, *options, environment=None, kill_after_s=None):
        return run([setting.rva, *self.arguments(setting), *options], place, self.said, environment, kill_after_s)
