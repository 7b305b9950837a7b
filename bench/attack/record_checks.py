"""Checks of marked findings, of earlier rounds, and of closed and deleted inspections after a kill."""
from contents import check_png
from killing import run
from ledger import digest, optional_picture
from server import Refused
from setting import LOST, UNEXPLAINED, Problem
from whole import unless_whole


def check_listed(ledger, listed):
    """Problems with the numbers of the inspections that are there."""
    problems = [Problem(LOST, f'inspection {number} was deleted, and is there again') for number in listed & ledger.deleted]
    problems += [Problem(LOST, f'inspection {number} is gone')
                 for number in sorted(set(ledger.inspections) - listed) if not ledger.may_be_deleted(number)]
    unknown = listed - set(ledger.inspections) - ledger.deleted
    if len(unknown) > (ledger.pending == 'begin'):
        problems.append(Problem(UNEXPLAINED, f'there are inspections without a request: {sorted(unknown)}'))
    problems += [Problem(UNEXPLAINED, f'inspection {number} has a number that was given before')
                 for number in unknown if number <= ledger.greatest]
    return problems


def check_closing(ledger, known, now):
    was, is_now = known.get('closing'), now.get('closing')
    if was == is_now or (was is None and ledger.pending == 'close'):
        return []
    return [Problem(LOST, f'inspection {known["id"]}: its closing was {was}, now is {is_now}')]


def check_packages(setting, ledger, data):
    """Problems with signed packages: those that were acknowledged are there, and each is whole and in the site's log."""
    packages = sorted((data / 'signed').glob('*-[0-9]')) if (data / 'signed').exists() else []
    problems = []
    if not ledger.packages <= len(packages) <= ledger.packages + (ledger.pending == 'sign'):
        problems.append(Problem(LOST, f'{len(packages)} packages are there, {ledger.packages} were acknowledged'))
    for package in packages:
        ended = run([setting.rva, 'inspection', 'verify', package, '--log', data / 'log'], data)
        if ended.status != 0:
            problems.append(Problem(LOST, f'{package.name} does not verify: {ended.last_line()}'))
    ledger.packages = len(packages)
    return problems


def check_marks(server, ledger, known, now):
    def lost(what):
        return Problem(LOST, f'inspection {known["id"]}: {what}')

    problems = []
    marks = {mark['number']: mark for mark in now['marked']}
    for was in known['marked']:
        is_now = marks.pop(was['number'], None)
        if is_now is None:
            problems.append(lost(f'mark {was["number"]} is gone'))
            continue
        if without_decision(was) != without_decision(is_now):
            problems.append(lost(f'mark {was["number"]} has changed'))
        decided_since = 'decision' not in was and ledger.pending == 'decide-mark'
        if was.get('decision') != is_now.get('decision') and not decided_since:
            problems.append(lost(f'the decision on mark {was["number"]} has changed'))
    if len(marks) > (ledger.pending == 'mark'):
        problems.append(Problem(UNEXPLAINED, f'there are marks without a request: {sorted(marks)}'))
    for mark in now['marked']:
        what = f'inspection {known["id"]}: the picture of mark {mark["number"]}'
        picture = optional_picture(server, f'inspections/{known["id"]}/marked/{mark["number"]}/picture.png')
        if picture is None:
            problems.append(Problem(LOST, f'{what} is gone'))
        elif ledger.marks.get(mark['number'], digest(picture)) != digest(picture):
            problems.append(Problem(LOST, f'{what} is another one'))
        else:
            problems += unless_whole(check_png, picture, what)
    return problems


def check_rounds(server, ledger, number):
    """Problems with the comparisons that were there: each must show what it showed, with its decisions."""
    problems = []
    now = {entry['comparison']: entry for entry in server.ask('GET', f'inspections/{number}/rounds')['rounds']}
    for was in ledger.rounds:
        what = f'inspection {number}: comparison {was["comparison"]}'
        is_now = now.get(was['comparison'])
        if is_now is None:
            problems.append(Problem(LOST, f'{what} is gone'))
            continue
        if as_found(was) != as_found(is_now):
            problems.append(Problem(LOST, f'{what} shows something else'))
        for before, after in zip(was['findings'], is_now['findings']):
            if before.get('decision', after.get('decision')) != after.get('decision'):
                problems.append(Problem(LOST, f'{what}: the decision on finding {before["number"]} has changed'))
        try:
            path = f'inspections/{number}/rounds/{was["comparison"]}/views/0/final_depth.png'
            problems += unless_whole(check_png, server.download(path), f'{what}: its picture')
        except Refused:
            problems.append(Problem(LOST, f'{what}: its pictures are gone'))
    return problems


def without_decision(finding):
    return {key: value for key, value in finding.items() if key != 'decision'}


def as_found(entry):
    """What a comparison showed, without the decisions, which are made later."""
    return {**entry, 'findings': [without_decision(finding) for finding in entry['findings']]}
