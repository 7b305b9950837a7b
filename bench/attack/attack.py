#!/usr/bin/python3
"""Kills every command and the server at random moments, and reports what each kill lost or left behind.

usage: attack.py [--kills 100] [--seed S] [--only STAGE] [--number N] [--rva build/rva] [--console DIR] [--work DIR]

Of each stage, about two thirds of the kills come at a moment between its start and the end that it has when nobody kills
it, and one third before or after a system call that renames, writes or syncs a file. After each kill, results are looked
at, and the command or the inspection goes on to its end. The status is 1 if anything was wrong.
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
    """How many of the kills each stage gets, by its weight; the largest remainders get what is left."""
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
        self.attempts, self.kept = [], {}  # the folders kept, by stage and number

    def attack(self, stage, kills):
        """As many kills as asked for; a run that ends before its kill is followed by another, within reason."""
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
        """The last one of the stage of which most are kept."""
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
    print('went on: it was run again, or the inspection went to its end; lost: something that was acknowledged, or an earlier '
          'result;\nunexplained: something that is left or half done, and nobody was told; stuck: it could not go on')
    early = sum(not attempt.killed for attempt in attempts)
    if early:
        print(f'{early} more were not killed, most since they ended first; what they left was looked at, too')


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
    parser.add_argument('--only', default='', metavar='STAGE', help='stages whose names begin so')
    parser.add_argument('--number', type=int, help='only this attempt of a stage, as a failure names it')
    parser.add_argument('--rva', type=pathlib.Path, default=ROOT / 'build' / 'rva')
    parser.add_argument('--console', type=pathlib.Path, help="folder of the console's files, where not beside the program")
    parser.add_argument('--work', type=pathlib.Path, help='an empty folder, which stays')
    return parser.parse_args()


def stages_named(only):
    """Those whose names begin so; one of exactly that name alone."""
    stages = command_stages() + inspection_stages()
    chosen = [stage for stage in stages if stage.name == only] or [stage for stage in stages if stage.name.startswith(only)]
    if not chosen:
        sys.exit(f'attack: no stage is named {only}; there are ' + ', '.join(stage.name for stage in stages))
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
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # what is running is ended, as by Ctrl-C
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
