"""Checks that all data that a server acknowledged is present after it was killed and started again."""
from contents import check_ply, check_png, contents, few
from killing import run
from ledger import MORE_PICTURES, PICTURES, digest, is_remains, optional_picture
from record_checks import check_closing, check_listed, check_marks, check_packages, check_rounds
from server import Refused
from setting import LOST, STUCK, UNEXPLAINED, Problem
from stored import integrity, notes_of_decisions
from whole import unless_whole

BEGUN_WITH = ('aircraft', 'zone', 'work_order', 'person', 'created_at')


def check_restarted(setting, server, ledger, data):
    """Problems in the records that the server returns."""
    listed = {entry['id'] for entry in server.ask('GET', 'inspections')['inspections']}
    problems = check_listed(ledger, listed)
    for number, known in ledger.inspections.items():
        if number not in listed:
            continue
        now = server.ask('GET', f'inspections/{number}')
        if number == ledger.current:
            problems += check_inspection(ledger, known, now) + check_closing(ledger, known, now)
            problems += check_marks(server, ledger, known, now) + check_rounds(server, ledger, number)
            problems += check_pictures(server, ledger, now)
        elif any(now.get(key) != known.get(key) for key in (*BEGUN_WITH, 'views', 'initial', 'final', 'findings')):
            problems.append(Problem(LOST, f'inspection {number} has changed, although nothing was done on it'))
    for number in listed - set(ledger.inspections):
        if not server.ask('GET', f'inspections/{number}')['views']:
            problems.append(Problem(UNEXPLAINED, f'inspection {number} was created incompletely: it has no view'))
    return problems + check_packages(setting, ledger, data) + check_accounts(setting, ledger, data)


def check_inspection(ledger, known, now):
    def lost(what, was, is_now):
        return Problem(LOST, f'inspection {known["id"]}: {what} was {was}, now is {is_now}')

    problems = [lost(key, known[key], now[key]) for key in BEGUN_WITH if known[key] != now[key]]
    if now['views'] not in [known['views']] + ([ledger.wanted_views] if ledger.wanted_views else []):
        problems.append(lost('its views', known['views'], now['views']))
    for side in ('initial', 'final'):
        was, is_now = known.get(side), now.get(side)
        is_newer = is_now is not None and (was is None or is_now['taken_at'] > was['taken_at'])
        if was == is_now and side in ledger.owed:
            problems.append(lost(f'its {side} side', 'reported as taken', is_now))
        elif was != is_now and not (ledger.may_have_come(side) and is_newer):
            problems.append(lost(f'its {side} side', was, is_now))
    return problems + check_comparison(ledger, known, now, lost)


def check_comparison(ledger, known, now, lost):
    was, is_now = known.get('compared_at'), now.get('compared_at')
    has_new_side = known.get('final') != now.get('final')
    if 'comparison' in ledger.owed and is_now in (None, was):
        return [lost('its comparison', 'reported as done', is_now)]
    if was == is_now:
        if was and has_new_side:
            return [Problem(UNEXPLAINED, f'inspection {known["id"]}: shows findings of the earlier final side with the new one')]
        return check_findings(ledger, known, now, lost)
    if is_now is None and not has_new_side:
        return [lost('its comparison', was, 'gone')]
    if is_now is not None and not (ledger.may_have_come('comparison') or ledger.may_have_come('final')):
        return [lost('its comparison', was, is_now)]
    return []


def check_findings(ledger, known, now, lost):
    """Problems with findings of an unchanged comparison: they and their decisions must be the same."""
    def without_decisions(inspection):
        return [{key: value for key, value in finding.items() if key != 'decision'} for finding in inspection['findings']]

    if known['compared'] != now['compared'] or without_decisions(known) != without_decisions(now):
        return [lost('what was found', f'{len(known["findings"])} findings', f'{len(now["findings"])}, or other ones')]
    problems = []
    for was, is_now in zip(known['findings'], now['findings']):
        decided_since = 'decision' in is_now and ledger.pending == 'decide'
        if was.get('decision') != is_now.get('decision') and not decided_since:
            problems.append(lost(f'the decision on finding {was["number"]}', was.get('decision'), is_now.get('decision')))
    return problems


def check_pictures(server, ledger, now):
    """Problems with pictures and clouds: those of each compared view must exist, and those of a comparison that was read
    before the kill must be unchanged."""
    problems = []
    same_comparison = now.get('compared_at') and now['compared_at'] == ledger.known().get('compared_at')
    paths = [(compared['view'], name) for compared in now['compared'] for name in PICTURES + MORE_PICTURES]
    for view, name in paths:
        picture = optional_picture(server, f'inspections/{now["id"]}/views/{view}/{name}.png')
        what = f'inspection {now["id"]}: picture {name} of view {view}'
        expected = ledger.pictures.get((view, name)) if same_comparison else None
        if picture is None:
            if expected or name in PICTURES:
                problems.append(Problem(LOST, f'{what} is gone'))
        elif expected not in (None, digest(picture)):
            problems.append(Problem(LOST, f'{what} is another one, though the comparison is the same'))
        else:
            problems += unless_whole(check_png, picture, what)
    for name in ('map', 'changes') if now['compared'] else ():
        cloud = optional_picture(server, f'inspections/{now["id"]}/{name}')
        what = f'inspection {now["id"]}: its {name}'
        problems += [Problem(LOST, f'{what} is gone')] if cloud is None else unless_whole(check_ply, cloud, what)
    if 'initial' in now:
        for view in range(len(now['views'])):
            try:
                server.download(f'inspections/{now["id"]}/baseline/{view}/depth.png')
            except Refused as refused:
                problems.append(Problem(LOST, f'its baseline cannot be seen: {refused}'))
    return problems


def check_accounts(setting, ledger, data):
    ended = run([setting.rva, 'account', 'list', '--data', data], data)
    if ended.status != 0:
        return [Problem(STUCK, f'rva account list: {ended.last_line()}')]
    roles = {line.split()[1]: line.split()[0] for line in ended.stdout.splitlines()}
    return [] if roles == ledger.accounts else [Problem(LOST, f'accounts are {roles}, were {ledger.accounts}')]


def check_captures(ledger, data, when):
    """Problems with captures of acknowledged sides: none may be moved or replaced, not even by a later side."""
    changed = [str(path) for path, files in ledger.captures.items() if contents(data / path) != files]
    return [Problem(LOST, f'{when}, captures that were acknowledged are gone or changed: {few(changed)}')] if changed else []


def check_stopped(ledger, data, said):
    """Problems in the data folder after the server has ended. `said` is its output on stderr since the kill."""
    database = data / 'rva.db'
    problems = [Problem(LOST, fault) for fault in integrity(database)]
    if problems:
        return problems
    missing = set(ledger.notes) - set(notes_of_decisions(database))
    if missing:
        problems.append(Problem(LOST, f'{len(missing)} of {len(ledger.notes)} decisions are missing from the database'))
    for path in sorted(data.rglob('*')):
        inside = path.relative_to(data)
        if is_remains(inside) and not is_remains(inside.parent) and path.name not in said:
            problems.append(Problem(UNEXPLAINED, f'{inside} is left over, and the program did not report it'))
    return problems
