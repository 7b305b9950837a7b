"""Contents of the database of a data folder."""
import contextlib
import sqlite3


def integrity(database):
    """The problems that SQLite finds in the file; none if there is no file."""
    if not database.exists():
        return []
    try:
        with contextlib.closing(sqlite3.connect(database)) as connection:
            said = [row[0] for row in connection.execute('pragma integrity_check')]
    except sqlite3.Error as error:
        said = [str(error)]
    return [f'{database.name}: {line}' for line in said if line != 'ok']


def notes_of_decisions(database):
    """The notes of all decisions ever made, including those on findings of superseded comparisons."""
    with contextlib.closing(sqlite3.connect(database)) as connection:
        return [row[0] for row in connection.execute('select note from decision')]
