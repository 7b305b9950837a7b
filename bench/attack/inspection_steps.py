"""The steps of an inspection as a user performs them. Every answer is noted in the ledger."""
from killing import run
from server import Refused
from setting import Unusable

PASSWORD = 'correct horse'
VIEWS = [{'pan_deg': pan, 'tilt_deg': -20.0} for pan in (0.0, 6.0)]
REGION = [[[0.0, 0.0], [60.0, 0.0], [60.0, 60.0]]]


class Steps:
    def __init__(self, setting, server, ledger, data):
        self.setting, self.server, self.ledger, self.data = setting, server, ledger, data

    def begin(self):
        self.ledger.current = self.begin_another()

    def begin_another(self):
        """Begins an inspection that is not the current one. Returns its number."""
        with self.ledger.asking('begin'):
            answer = self.server.ask('POST', 'inspections', {'aircraft': 'A1', 'zone': 'wing', 'work_order': '7',
                                                             'person': self.server.person})
            self.ledger.note(answer)
        return answer['id']

    def views(self):
        with self.ledger.asking('views', VIEWS):
            self.ledger.note(self.server.ask('PUT', self._path('views'), {'views': VIEWS}))

    def initial(self):
        self._capture('initial')
        self.ledger.owed.add('initial')

    def regions(self):
        views = [dict(view) for view in self.ledger.known()['views']]
        views[0]['ignore'] = REGION
        with self.ledger.asking('regions', views):
            self.ledger.note(self.server.ask('PUT', self._path('regions'), {'view': 0, 'ignore': REGION}))

    def final(self):
        """Takes the final side; it replaces an earlier one."""
        self._capture('final')
        self.ledger.owed |= {'final', 'comparison'}

    def compare(self):
        with self.ledger.asking('comparison'):
            self.server.do(self._path('compare'), {})
        self.ledger.owed.add('comparison')

    def decide(self):
        """Decides on all undecided findings of the last comparison."""
        inspection = self.ledger.known()
        for finding in inspection['findings']:
            if 'decision' in finding:
                continue
            note = f'note {len(self.ledger.notes)}'
            with self.ledger.asking('decide'):
                answer = self.server.ask('POST', self._path(f'findings/{finding["number"]}/decision'),
                                         {'compared_at': inspection['compared_at'], 'verdict': 'false-alarm', 'note': note,
                                          'person': self.server.person})
                self.ledger.notes.append(note)
                self.ledger.note(answer)

    def mark(self):
        """Marks a finding in the pictures of a view, and another one in the live picture, which is kept."""
        box = {'bbox': [300, 200, 24, 24], 'person': self.server.person}
        for where in ({'comparison': self.ledger.known()['comparison'], 'view': 0}, {'stream': 'depth'}):
            with self.ledger.asking('mark'):
                self.ledger.note(self.server.ask('POST', self._path('marked'), {**box, **where, 'note': 'a rag'}))

    def decide_marks(self):
        for mark in self.ledger.known()['marked']:
            if 'decision' in mark:
                continue
            with self.ledger.asking('decide-mark'):
                self.ledger.note(self.server.ask('POST', self._path(f'marked/{mark["number"]}/decision'),
                                                 {'verdict': 'installed-work', 'note': '', 'person': self.server.person}))

    def close(self):
        with self.ledger.asking('close'):
            self.ledger.note(self.server.ask('POST', self._path('close'),
                                             {'comparison': self.ledger.known()['comparison'], 'note': 'seen',
                                              'person': self.server.person}))

    def delete(self):
        """Deletes the inspections of which nothing was captured, and begins another one."""
        for number in [number for number in self.ledger.inspections if number != self.ledger.current]:
            with self.ledger.asking('delete'):
                self.server.ask('DELETE', f'inspections/{number}', {})
                self.ledger.note_deleted(number)
        self.begin_another()

    def accounts(self):
        """Changes accounts by the command line while the server runs."""
        self._account('add', 'ann', '--role', 'inspector')
        self.ledger.accounts['ann'] = 'inspector'
        self.server.sign_in('ann', PASSWORD)
        self._account('add', 'bob', '--role', 'viewer')
        self.ledger.accounts['bob'] = 'viewer'
        self._account('remove', 'bob')
        del self.ledger.accounts['bob']

    def sign(self):
        """Signs the closed inspection, with the password of an account."""
        with self.ledger.asking('sign'):
            self.server.do(self._path('sign'), {'password': PASSWORD})
            self.ledger.packages += 1

    def look(self):
        self.ledger.look(self.server, self.data)

    def to_the_work(self):
        """Performs the steps that are missing after a kill, up to the initial side."""
        if self.ledger.current is None:
            self.begin()
        self._ask_again()
        if 'initial' not in self.ledger.known():
            self.initial()
            self.look()

    def to_the_end(self):
        """Performs the steps that are missing after a kill, takes the final side once more, decides on all findings, and
        closes the inspection. One that is closed already must not change."""
        self._ask_again()
        if 'closing' in self.ledger.known():
            self._expect_refusal()
            if 'ann' in self.ledger.accounts:
                self.sign()
            return
        if 'final' not in self.ledger.known():
            self.final()
        elif 'compared_at' not in self.ledger.known():
            self.compare()
        self.look()
        self.decide()
        self.final()
        self.look()
        self.decide()
        self.mark()
        self.decide_marks()
        self.close()
        self.look()

    def _expect_refusal(self):
        try:
            self._capture('final')
        except Refused:
            self.look()
            return
        raise Refused('a closed inspection was captured again')

    def _ask_again(self):
        """After a kill, accepts the current state of the inspection; nothing is pending any more."""
        self.ledger.note(self.server.ask('GET', f'inspections/{self.ledger.current}'))
        listed = {entry['id'] for entry in self.server.ask('GET', 'inspections')['inspections']}
        for number in set(self.ledger.inspections) - listed:
            self.ledger.note_deleted(number)
        self.ledger.pending = self.ledger.wanted_views = None
        self.ledger.owed.clear()

    def _capture(self, side):
        with self.ledger.asking(side):
            self.server.do(self._path('capture'), {'side': side, 'person': self.server.person, 'replaced': False})

    def _account(self, *arguments):
        """Runs `rva account`, which is not killed, so its exit status can be relied on."""
        ended = run([self.setting.rva, 'account', *arguments, '--data', self.data], self.data, PASSWORD + '\n')
        if ended.status != 0:
            raise Unusable(f'rva account {" ".join(arguments)}: {ended.last_line()}')

    def _path(self, what):
        return f'inspections/{self.ledger.current}/{what}'
