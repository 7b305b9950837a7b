"""Data folders with inspections that are closed, written without any capture: their records and the pictures of the
review, as a report needs them."""
import contextlib
import json
import sqlite3

import cv2
import numpy as np

WIDTH, HEIGHT = 424, 240
BEGUN, COMPARED, DECIDED, CLOSED = (f'2026-01-01T{hour:02}:00:00.000Z' for hour in (8, 9, 10, 11))


def write_pictures(result, seed):
    """Pictures of a bright bay before and after the work."""
    result.mkdir(parents=True)
    random = np.random.default_rng(seed)
    for name in ('initial_color', 'final_color', 'initial_depth', 'final_depth'):
        coarse = random.integers(60, 230, (6, 9, 3), np.uint8)
        cv2.imwrite(str(result / f'{name}.png'), cv2.resize(coarse, (WIDTH, HEIGHT), interpolation=cv2.INTER_CUBIC))
    stripes = np.zeros((HEIGHT, WIDTH, 3), np.uint8)
    stripes[:40, ::8] = (0, 0, 200)
    cv2.imwrite(str(result / 'not_inspected.png'), stripes)
    (result / 'detections.json').write_text(json.dumps({'method': 'calibrated', 'parameters': {'false_alarms': 0.05}}))


def write_inspection(data, number, findings=0, aircraft='N123AB', zone='Left wing, bay 3', work_order='WO-4711',
                     person='Ida', note='taken out', views=1, closing_note=''):
    """Adds an inspection in which `findings` objects were found and removed, to a data folder that has its tables.

    Findings beyond the last round would leave the inspection open, so a second round without any follows them."""
    rounds = [findings, 0] if findings else [0]
    with contextlib.closing(sqlite3.connect(data / 'rva.db')) as database, database:
        database.execute('insert into inspection (id, aircraft, zone, work_order, person, created_at, dither, comparison) '
                         'values (?, ?, ?, ?, ?, ?, 1, ?)', (number, aircraft, zone, work_order, person, BEGUN, len(rounds)))
        for view in range(views):
            database.execute('insert into view values (?, ?, 0, ?)', (number, view, 5 * view))
        for k, count in enumerate(rounds, 1):
            folder = data / 'inspections' / f'{number:06}' / f'comparison-{k}'
            database.execute('insert into comparison values (?, ?, ?, ?, ?)', (number, k, COMPARED, folder.name, k))
            for view in range(views):
                write_pictures(folder / 'results' / f'{view:03}', view)
                database.execute("insert into compared_view values (?, ?, ?, 'calibrated', 0.9, 0.02, 0.05, 0.85, '[]', null, "
                                 "'[[5.0,0.4],[10.0,0.7],[20.0,0.8]]', '[]')", (number, k, view))
            for finding in range(1, count + 1):
                box = [20 + 37 * (finding % 10), 30 + 40 * (finding // 10 % 5), 24, 16]
                database.execute(
                    "insert into finding (inspection, comparison, number, view, same_as, kind, box, centroid, position_m, size_mm, "
                    "height_mm, score, top_above_surroundings_mm) values (?, ?, ?, ?, ?, 'added', ?, '[1,1]', '[0,0,0.7]', ?, 9, 10, 8)",
                    (number, k, finding, finding % views, finding, json.dumps(box), f'[{finding + 100.0}, 9.5]'))
                database.execute(
                    "insert into decision (inspection, comparison, finding, verdict, note, person, decided_at, round) "
                    "values (?, ?, ?, 'debris-removed', ?, ?, ?, ?)", (number, k, finding, f'{note} {finding}', person, DECIDED, k))
        database.execute('insert into closing values (?, ?, ?, ?, ?)', (number, len(rounds), person, closing_note, CLOSED))
