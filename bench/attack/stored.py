"""What the database of a data folder holds."""
import contextlib
import sqlite3


def integrity(database):
    """What SQLite finds wrong with the file; nothing where there is no file."""
    if not database.exists():
        return []
    try:
        with contextlib.closing(sqlite3.connect(database)) as connection:
            said = [row[0] for row in connection.execute('pragma integrity_check')]
    except sqlite3.Error as error:
        said = [str(error)]
    return [f'{database.name}: {line}' for line in said if line != 'ok']


def notes_of_decisions(database):
    """Of every decision that was ever made, also on findings of comparisons that hold no more."""
    with contextlib.closing(sqlite3.connect(database)) as connection:
        return [row[0] for row in connection.execute('select note from decision')]
