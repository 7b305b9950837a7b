"""What the server has acknowledged, so that it must be there whenever it is killed afterwards."""
import contextlib
import hashlib

from contents import contents
from server import Refused

PICTURES = ('initial_color', 'final_color', 'initial_depth', 'final_depth', 'changed', 'not_inspected')
MORE_PICTURES = ('changes', 'level_of_detection')  # not of every method
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
    inspections: the last answer about each, by its number
    owed:        sides and comparison of the inspection under way that were said to be done, but not looked at since
    pending:     what was asked for last and is not answered, and, where it is known, how the views would be then
    notes:       of all decisions; each is of a text that no other has
    captures:    contents of each capture's folder, by its path in the data folder
    unfinished:  paths of captures of a side that was killed: whoever goes on may keep them or not
    pictures:    digests of those of the inspection under way, by view and name, as of its comparison
    accounts:    roles, by name
    """

    def __init__(self):
        self.inspections, self.owed, self.notes = {}, set(), []
        self.captures, self.pictures, self.accounts = {}, {}, {}
        self.unfinished = set()
        self.pending, self.wanted_views = None, None
        self.current = None  # number of the inspection under way

    @contextlib.contextmanager
    def asking(self, what, wanted_views=None):
        """What is asked for within it, stays pending if no answer comes."""
        self.pending, self.wanted_views = what, wanted_views
        yield
        self.pending, self.wanted_views = None, None

    def may_have_come(self, what):
        return self.pending == what or what in self.owed

    def note(self, answer):
        self.inspections[answer['id']] = answer

    def known(self):
        return self.inspections[self.current]

    def look(self, server, data):
        """Notes how the inspection under way is now, with its captures and pictures."""
        answer = server.ask('GET', f'inspections/{self.current}')
        self.note(answer)
        self.owed.clear()
        self.pictures.clear()
        for compared in answer['compared']:
            for name in PICTURES + MORE_PICTURES:
                picture = optional_picture(server, f'inspections/{self.current}/views/{compared["view"]}/{name}.png')
                if picture is not None:
                    self.pictures[compared['view'], name] = digest(picture)
        self.note_captures(data)

    def note_captures(self, data, acknowledged=True):
        """Those that are new belong to sides that were said to be done; or to one that was killed, and never count."""
        for description in sorted(data.rglob('capture.json')):
            path = description.parent.relative_to(data)
            if is_remains(path) or path in self.captures or path in self.unfinished:
                continue
            if acknowledged:
                self.captures[path] = contents(description.parent)
            else:
                self.unfinished.add(path)
