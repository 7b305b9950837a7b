#!/usr/bin/python3
"""Kills every command and the server at random moments, and reports the data that each kill lost or left behind.

usage: attack.py [--kills 100] [--seed S] [--only STAGE] [--number N] [--rva build/rva] [--console DIR] [--work DIR]

In each stage, about two thirds of the kills happen at a random time within the stage's duration without a kill, and one
third before or after a system call that renames, writes or syncs a file. After each kill, the results are checked, and the
command or the inspection is continued to its end. The exit status is 1 if anything was wrong.
"""
import argparse
import pathlib
import shutil
import signal
import sys
import tempfile

from command_stages import command_stages
from inspection_stages import inspection_stages
from setting import LOST, STUCK, UNEXPLAINED, Attempt, Problem, Setting, Unusable

ROOT = pathlib.Path(__file__).resolve().parents[2]
MOST_EVIDENCE = 20


def shares(stages, kills):
    """The number of kills for each stage, in proportion to its weight, by the method of largest remainders."""
    total = sum(stage.weight for stage in stages)
    exact = [kills * stage.weight / total for stage in stages]
    given = [int(share) for share in exact]
    by_remainder = sorted(range(len(stages)), key=lambda i: given[i] - exact[i])
    for i in by_remainder[:kills - sum(given)]:
        given[i] += 1
    return list(zip(stages, given))


class Campaign:
    """All attempts of a run, and the folders of those that failed."""

    def __init__(self, setting, seed):
        self.setting, self.seed = setting, seed
        self.attempts, self.kept = [], {}  # kept: folders by stage and number

    def attack(self, stage, kills):
        """Makes the given number of kills. A run that ends before its kill is repeated, up to a limit."""
        number = killed = 0
        while killed < kills and number < 2 * kills + 3:
            number += 1
            attempt = self.attempt(stage, number)
            killed += attempt.killed
            if attempt.moment is None:
                return

    def attempt(self, stage, number):
        evidence = self.setting.fresh(f'{stage.name}-{number}')
        try:
            attempt = stage.attempt(self.setting, number, self.seed, evidence)
        except Unusable as reason:
            attempt = Attempt(stage.name, number, None, False, [Problem(STUCK, f'cannot be attacked: {reason}')])
        self.attempts.append(attempt)
        print(*lines_of(attempt), sep='\n  ', file=sys.stderr, flush=True)
        self._keep_or_remove(attempt, evidence)
        return attempt

    def failed(self):
        return [attempt for attempt in self.attempts if attempt.problems]

    def _keep_or_remove(self, attempt, evidence):
        if not attempt.problems:
            shutil.rmtree(evidence, ignore_errors=True)
            return
        (evidence / 'report.txt').write_text('\n  '.join(lines_of(attempt)) + '\n')
        self.kept[attempt.stage, attempt.number] = evidence
        if len(self.kept) > MOST_EVIDENCE:
            shutil.rmtree(self.kept.pop(self._most_dispensable()), ignore_errors=True)

    def _most_dispensable(self):
        """The last folder of the stage with the most kept folders."""
        stages = [stage for stage, _ in self.kept]
        return max(self.kept, key=lambda key: (stages.count(key[0]), key[1]))


def lines_of(attempt):
    if attempt.killed:
        what = f'killed {attempt.moment}'
    else:
        what = 'not attacked' if attempt.moment is None else f'ended before it could be killed {attempt.moment}'
    return [f'{attempt.stage} {attempt.number}, {what}', *(f'{problem.kind}: {problem.text}' for problem in attempt.problems)]


def print_table(attempts):
    print(f'{"":25} {"killed":^19}   {"of these"}')
    print(f'{"stage":25} {"at a time":>9} {"at a call":>9}   {"went on":>7} {"lost":>5} {"unexplained":>11} {"stuck":>5}')
    rows = {}
    for attempt in attempts:
        rows.setdefault(attempt.stage, []).append(attempt)
    for name, of_stage in [*rows.items(), ('all', attempts)]:
        killed = [attempt for attempt in of_stage if attempt.killed]
        at_call = sum(attempt.moment.at_call for attempt in killed)
        count = {kind: sum(attempt.has(kind) for attempt in killed) for kind in (LOST, UNEXPLAINED, STUCK)}
        print(f'{name:25} {len(killed) - at_call:9} {at_call:9}   {len(killed) - count[STUCK]:7} {count[LOST]:5} '
              f'{count[UNEXPLAINED]:11} {count[STUCK]:5}')
    print('went on: the command ran again, or the inspection was completed; lost: acknowledged data or an earlier result is '
          'gone;\nunexplained: incomplete or left-over data was not reported; stuck: the stage could not be continued')
    early = sum(not attempt.killed for attempt in attempts)
    if early:
        print(f'{early} more were not killed, most because they ended first; their results were checked as well')


def print_failures(campaign):
    for attempt in campaign.failed():
        print()
        print(*lines_of(attempt), f'again: script/attack --seed {campaign.seed} --only {attempt.stage} --number {attempt.number}',
              sep='\n  ')
        folder = campaign.kept.get((attempt.stage, attempt.number))
        if folder:
            print(f'  evidence: {folder} (after-kill: as the kill left it)')


def arguments_of():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--kills', type=int, default=100)
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--only', default='', metavar='STAGE', help='only stages whose names begin with STAGE')
    parser.add_argument('--number', type=int, help='only this attempt of a stage, as given in the report of a failure')
    parser.add_argument('--rva', type=pathlib.Path, default=ROOT / 'build' / 'rva')
    parser.add_argument('--console', type=pathlib.Path, help="folder of the console's files, if not beside the program")
    parser.add_argument('--work', type=pathlib.Path, help='an empty folder for the work, which is kept')
    return parser.parse_args()


def stages_named(only):
    """The stages whose names begin with `only`, or the single stage with exactly that name."""
    stages = command_stages() + inspection_stages()
    chosen = [stage for stage in stages if stage.name == only] or [stage for stage in stages if stage.name.startswith(only)]
    if not chosen:
        sys.exit(f'attack: no stage is named {only}; stages are ' + ', '.join(stage.name for stage in stages))
    return chosen


def work_folder(given):
    if given is None:
        return pathlib.Path(tempfile.mkdtemp(prefix='rva-attack-')).resolve()
    given.mkdir(parents=True, exist_ok=True)
    if any(given.iterdir()):
        sys.exit(f'attack: {given} is not empty; give another folder')
    return given.resolve()


def main():
    arguments = arguments_of()
    stages = stages_named(arguments.only)
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # ends running programs, as Ctrl-C does
    work = work_folder(arguments.work)
    campaign = Campaign(Setting(arguments.rva.resolve(), arguments.console and arguments.console.resolve(), work), arguments.seed)
    interrupted = False
    try:
        for stage, kills in shares(stages, arguments.kills):
            if arguments.number:
                campaign.attempt(stage, arguments.number)
            elif kills:
                campaign.attack(stage, kills)
    except KeyboardInterrupt:
        interrupted = True
    finally:
        if not arguments.work and not campaign.kept:
            shutil.rmtree(work, ignore_errors=True)
    print_table(campaign.attempts)
    print_failures(campaign)
    sys.exit(130 if interrupted else 1 if campaign.failed() else 0)


if __name__ == '__main__':
    main()
