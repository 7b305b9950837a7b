"""The data that the server has acknowledged, and which must therefore survive any later kill."""
import contextlib
import hashlib

from contents import contents
from server import Refused

PICTURES = ('initial_color', 'final_color', 'initial_depth', 'final_depth', 'changed', 'not_inspected')
MORE_PICTURES = ('changes', 'level_of_detection', 'findable_5mm', 'findable_10mm', 'findable_20mm')  # not of every method
REMAINS = ('.partial', '.replaced')


def is_remains(path):
    return any(mark in part for part in path.parts for mark in REMAINS)


def digest(data):
    return hashlib.sha256(data).hexdigest()


def optional_picture(server, path):
    try:
        return server.download(path)
    except Refused:
        return None


class Ledger:
    """
    inspections: the last answer about each inspection, by number
    owed:        sides and comparison of the current inspection that were reported as done, but not read since
    pending:     the last request without an answer; wanted_views: the views that it would set, if any
    notes:       the notes of all decisions; each text is unique
    captures:    contents of the folder of each capture, by path in the data folder
    unfinished:  paths of captures of an interrupted side, which the program may keep or remove
    pictures:    digests of the pictures of the current inspection's comparison, by view and name
    accounts:    roles by name
    marks:       digests of the pictures in which findings of the current inspection were marked, by number
    rounds:      the comparisons of the current inspection when they were last read
    packages:    how many signed packages of the current inspection were acknowledged
    deleted:     numbers of inspections that were deleted; greatest: the highest number that was ever given
    """

    def __init__(self):
        self.inspections, self.owed, self.notes = {}, set(), []
        self.captures, self.pictures, self.accounts = {}, {}, {}
        self.marks, self.rounds, self.deleted, self.greatest = {}, [], set(), 0
        self.unfinished, self.packages = set(), 0
        self.pending, self.wanted_views = None, None
        self.current = None  # number of the current inspection

    @contextlib.contextmanager
    def asking(self, what, wanted_views=None):
        """A context for one request, which stays pending if there is no answer."""
        self.pending, self.wanted_views = what, wanted_views
        yield
        self.pending, self.wanted_views = None, None

    def may_have_come(self, what):
        return self.pending == what or what in self.owed

    def may_be_deleted(self, number):
        return self.pending == 'delete' and number != self.current

    def note(self, answer):
        self.inspections[answer['id']] = answer
        self.greatest = max(self.greatest, answer['id'])

    def note_deleted(self, number):
        del self.inspections[number]
        self.deleted.add(number)

    def known(self):
        return self.inspections[self.current]

    def look(self, server, data):
        """Reads the state of the current inspection, with its captures and pictures."""
        answer = server.ask('GET', f'inspections/{self.current}')
        self.note(answer)
        self.owed.clear()
        self.pictures.clear()
        self.rounds = server.ask('GET', f'inspections/{self.current}/rounds')['rounds']
        self.marks = {mark['number']: digest(server.download(f'inspections/{self.current}/marked/{mark["number"]}/picture.png'))
                      for mark in answer['marked']}
        for compared in answer['compared']:
            for name in PICTURES + MORE_PICTURES:
                picture = optional_picture(server, f'inspections/{self.current}/views/{compared["view"]}/{name}.png')
                if picture is not None:
                    self.pictures[compared['view'], name] = digest(picture)
        self.note_captures(data)

    def note_captures(self, data, acknowledged=True):
        """Notes new captures: as those of acknowledged sides, which must survive, or else of an interrupted side."""
        for description in sorted(data.rglob('capture.json')):
            path = description.parent.relative_to(data)
            if is_remains(path) or path in self.captures or path in self.unfinished:
                continue
            if acknowledged:
                self.captures[path] = contents(description.parent)
            else:
                self.unfinished.add(path)
