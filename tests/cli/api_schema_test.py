"""What `rva serve` sends, and what it accepts, is as console/schema/api.json describes it, in a whole inspection.

usage: api_schema_test.py RVA REPOSITORY
"""
import json
import os
import struct
import subprocess
import sys

import program
from api_schema import ApiSchema
from console_client import Console, ask
from read_elsewhere import ReadElsewhere
from simulations import TOOLS

SCHEMA = None

# Fields that appear only after a failure of a device, or by chance.
NOT_MET = {'CameraStatus.problem', 'CheckedView.problem', 'Finding.moved_from', 'HealthCheck.problem', 'RecordedLevels.effective_frames',
           'LampStatus.celsius', 'ReadinessValues.frames', 'ReadinessValues.repeated_frames', 'RobotStatus.problem', 'TaskStatus.problem', 'TaskStatus.waiting'}


class CheckedConsole(Console):
    """Checks all messages, in both directions."""

    def say(self, **message):
        SCHEMA.check('ClientMessage', message)
        super().say(**message)

    def _hear(self, message):
        SCHEMA.check('ServerMessage', message)
        super()._hear(message)

    def _show(self, payload):
        length = struct.unpack('<I', payload[:4])[0]
        SCHEMA.check('PictureHead', json.loads(payload[4:4 + length]))
        super()._show(payload)


class ApiSchemaTest(ReadElsewhere, program.ProgramTest):
    cookie = ''

    def setUp(self):
        super().setUp()
        (self.folder / 'console').mkdir()
        (self.folder / 'console' / 'index.html').write_text('<title>RVA</title>')
        server = subprocess.Popen(
            self.command('serve', '--camera', f'sim:{TOOLS}', '--robot', 'sim', '--data', self.folder / 'data', '--port', 0,
                         '--console', self.folder / 'console', '--frames', 16, '--dither', 4),
            stdout=subprocess.PIPE, encoding='utf-8')
        self.addCleanup(server.stdout.close)
        self.addCleanup(server.wait, 60)
        self.addCleanup(server.terminate)
        self.address = server.stdout.readline().strip()
        self.console = self.open_console('depth')
        self.console.wait_for(lambda status: status['camera']['streams'] and 'pan_deg' in status['robot'])

    def open_console(self, stream=None):
        console = CheckedConsole(self.address, stream=stream, cookie=self.cookie)
        self.addCleanup(console.close)
        return console

    def get(self, path, definition):
        return self.ask('GET', path, None, None, definition, 200)

    def post(self, path, request, body, definition='Empty', status=200):
        return self.ask('POST', path, request, body, definition, status)

    def ask(self, method, path, request, body, definition, status):
        if request:
            SCHEMA.check(request, body)
        answered, answer = ask(self.address, method, '/api/' + path, body, self.console.client, self.cookie)
        self.assertEqual(answered, status, answer)
        SCHEMA.check(definition, answer)
        return answer

    def refuse(self, method, path, body, status):
        return self.ask(method, path, None, body, 'ErrorAnswer', status)

    def take(self, side, then):
        body = {'side': side, 'person': 'Ann', 'replaced': False}
        before = self.console.status['task']['number']
        self.post('inspections/1/capture', 'CaptureRequest', body, status=202)
        self.wait_for_task(then, before)

    def wait_for_task(self, kind, before):
        status = self.console.wait_for(lambda status: status['task']['number'] > before and status['task']['kind'] == kind
                                       and status['task']['end'] != 'running', timeout_s=120)
        self.assertEqual(status['task']['end'], 'done', status['task'])

    def test_an_inspection(self):
        self.begin()
        self.drive()
        self.measure()
        self.point()
        self.keep_a_snapshot()
        self.expose()
        self.light()
        self.take('initial', then='check')
        self.get('inspections/1/baseline-check', 'BaselineCheck')
        left_out = [[-0.5, -0.5], [40.0, -0.5], [40.0, 40.0]]
        self.ask('PUT', 'inspections/1/regions', 'RegionsRequest', {'view': 0, 'ignore': [left_out]}, 'Inspection', 200)
        self.plan()
        self.post('simulation', 'SimulationRequest', {'done': True})
        self.take('final', then='comparison')
        self.review()
        self.mark()
        self.check_out()
        self.begin_another_round()
        self.take('final', then='comparison')
        self.close()
        self.export()
        self.report()
        self.trends()
        self.rerun()
        self.export_crops()
        self.sign_in()
        self.sign()
        self.assertLessEqual(SCHEMA.not_met(), NOT_MET, 'fields that were in no request, answer or message: remove them '
                             'from the schema, or list them here')

    def begin(self):
        self.get('health', 'Health')
        self.get('session', 'Session')
        self.get('inspections', 'InspectionList')
        self.refuse('GET', 'inspections/1', None, 404)
        self.refuse('PUT', 'session', {}, 405)
        self.refuse('POST', 'measure', {}, 400)
        self.post('inspections', 'Order', {'aircraft': 'N1', 'zone': 'bay', 'work_order': 'W1', 'person': 'Ann'},
                  'Inspection', 201)
        joints = {joint: self.console.status['robot'][joint] for joint in ('pan_deg', 'tilt_deg')}
        self.ask('PUT', 'inspections/1/views', 'ViewsRequest', {'views': [joints]}, 'Inspection', 200)
        self.post('readiness', None, {}, status=202)
        self.console.wait_for(lambda status: 'readiness' in status)
        self.post('cancel', None, {}, status=202)

    def drive(self):
        other = self.open_console()
        other.drive(1.0, 0.0)
        self.console.say(type='lease', action='take', name='Ann')
        other.say(type='lease', action='take', name='Bob')
        with other.changed:
            self.assertTrue(other.changed.wait_for(lambda: len(other.refused) == 2, 20), 'not refused')
        self.refuse('POST', 'inspections/9/compare', {}, 404)
        self.console.say(type='stop')
        self.console.say(type='lease', action='release')

    def point(self):
        middle, corner = {'x': 0.5, 'y': 0.5}, {'x': 1.0, 'y': 0.0}
        for shape in ('tap', 'arrow', 'circle'):
            self.console.say(type='pointing', stream='depth', shape=shape, **{'from': middle, 'to': corner})
        with self.console.changed:
            self.assertTrue(self.console.changed.wait_for(lambda: len(self.console.pointed) == 3, 20), 'not passed on')

    def expose(self):
        for fixed in ({'time_us': 5000, 'gain': 32}, None):
            self.ask('PUT', 'camera/exposure', 'ExposureRequest', {'automatic': fixed is None, **(fixed or {})}, 'Empty', 200)
            self.console.wait_for(lambda status: status['camera']['exposure']['automatic'] == (fixed is None))
        self.refuse('PUT', 'camera/exposure', {'automatic': False, 'time_us': 5000, 'gain': -1}, 409)

    def light(self):
        for percent in (40, 0):
            self.ask('PUT', 'robot/lamp', 'LampRequest', {'percent': percent}, 'Empty', 200)
            self.console.wait_for(lambda status: status['robot']['lamp']['percent'] == percent)
        for percent in (101, -1, 0.5):
            self.refuse('PUT', 'robot/lamp', {'percent': percent}, 400)

    def keep_a_snapshot(self):
        frozen = self.post('freeze', 'FreezeRequest', {'stream': 'color'}, 'FrozenPicture', 201)
        self.post('measure', 'MeasureRequest',
                  {'stream': 'color', 'frozen': frozen['frozen'], 'points': [{'u': 340, 'v': 336}]}, 'Measurement')
        for picture in ({'frozen': frozen['frozen']}, {}):
            self.post('inspections/1/snapshots', 'SnapshotRequest',
                      {'stream': 'color', 'note': 'a crack?', 'person': 'Ann', **picture}, 'Inspection', 201)

    def measure(self):
        for points in ([{'u': 340, 'v': 336}], [{'u': 340, 'v': 336}, {'u': 509, 'v': 336}], [{'u': -9, 'v': -9}]):
            self.post('measure', 'MeasureRequest', {'stream': 'depth', 'points': points}, 'Measurement')
        line = [{'u': 340, 'v': 336}, {'u': 409, 'v': 336}]
        for request in ({'tool': 'profile', 'points': line},
                        {'tool': 'height', 'points': line[:1], 'bbox': [300, 320, 80, 40]}):
            self.post('measure', 'MeasureRequest', {'stream': 'depth', **request}, 'Measurement')

    def plan(self):
        area = [[60, 60], [840, 60], [840, 470], [60, 470]]
        parts = [{'name': 'tools', 'kind': 'added', 'count': 1, 'height_mm': [1, 400], 'areas': [area]},
                 {'name': 'bracket', 'kind': 'removed', 'height_mm': [20, 25], 'size_mm': [20, 90], 'areas': [],
                  'places': [[420, 240]]}]
        text = json.dumps({'format': 'rva-plan', 'version': 1, 'coordinates': 'pixels', 'parts': parts})
        self.ask('PUT', 'inspections/1/views/0/plan', 'PlanRequest', {'text': text}, 'Inspection', 200)
        self.refuse('PUT', 'inspections/1/views/0/plan', {'text': 'parts: []'}, 409)

    def review(self):
        found = self.get('inspections/1', 'Inspection')
        self.assertTrue(found['findings'])
        planned = {work['name']: work for work in found['compared'][0]['planned']}
        self.assertEqual(planned['tools']['found'], 1)
        self.assertEqual((planned['bracket']['planned'], planned['bracket']['found']), (1, 0))
        self.assertIn('planned', {finding['planned'] for finding in found['findings']})
        self.post('inspections/1/findings/1/decision', 'DecisionRequest',
                  {'comparison': found['comparison'], 'verdict': 'debris-removed', 'note': '', 'object': 'rag', 'person': 'Ann'}, 'Inspection')
        self.get('inspections', 'InspectionList')
        self.measure_the_review(found)
        self.post('inspections/1/compare', None, {}, status=202)
        self.cancel('comparison')

    def measure_the_review(self, found):
        at = f'inspections/1/rounds/{found["comparison"]}/views/0/measure'
        line = [{'u': 340, 'v': 336}, {'u': 409, 'v': 336}]
        for side in ('initial', 'final'):
            measured = self.post(at, 'ViewMeasureRequest', {'side': side, 'tool': 'length', 'points': line}, 'Measurement')
            self.assertGreater(measured['length_uncertainty_mm'], 0)
        by_region = {'side': 'final', 'tool': 'height', 'points': line[:1], 'bbox': [300, 320, 80, 40]}
        self.post(at, 'ViewMeasureRequest', by_region, 'Measurement')
        self.refuse('POST', 'inspections/1/rounds/99/views/0/measure', by_region, 404)
        self.refuse('POST', at, {**by_region, 'side': 'left'}, 400)
        points = {'points_m': [finding['in_foot_m'] for finding in found['findings'] if 'in_foot_m' in finding][:2]}
        self.post('inspections/1/map/measure', 'MapMeasureRequest', points, 'Measurement')
        of_round = f'inspections/1/rounds/{found["comparison"]}/map/measure'
        self.post(of_round, 'MapMeasureRequest', points, 'Measurement')
        self.refuse('POST', 'inspections/1/map/measure', {'points_m': [[0, 0, 0]]}, 400)

    def mark(self):
        found = self.get('inspections/1', 'Inspection')
        in_view = {'comparison': found['comparison'], 'view': 0, 'bbox': [340, 336, 24, 24], 'note': 'a rag', 'person': 'Ann'}
        self.post('inspections/1/marked', 'MarkRequest', in_view, 'Inspection', 201)
        live = {'stream': 'color', 'bbox': [340, 336, 24, 24], 'note': '', 'person': 'Ann'}
        self.post('inspections/1/marked', 'MarkRequest', live, 'Inspection', 201)
        for number in (1, 2):
            self.post(f'inspections/1/marked/{number}/decision', 'MarkDecisionRequest',
                      {'verdict': 'debris-removed', 'note': '', 'object': 'rag', 'person': 'Ann'}, 'Inspection')
        self.post('inspections/1/decisions', 'DecisionsRequest',
                  {'comparison': found['comparison'], 'person': 'Ann', 'decisions': [
                      {'finding': 1, 'verdict': 'undecided', 'note': ''}, {'mark': 1, 'verdict': 'false-alarm', 'note': '', 'object': ''}]},
                  'Inspection')
        self.refuse('POST', 'inspections/1/marked', {**in_view, 'comparison': 99}, 409)

    def check_out(self):
        for csv in ('item,number,quantity\r\nwrench,T-12,1\r\n"collar, 7 mm",,24\r\n', 'item\nrag\n'):
            self.post('inspections/1/items', 'CheckOutRequest', {'csv': csv, 'person': 'Ann'}, 'Inspection', 201)
        self.refuse('POST', 'inspections/1/items', {'csv': 'price\n7\n', 'person': 'Ann'}, 409)
        self.refuse('POST', 'inspections/1/items', {'csv': 7, 'person': 'Ann'}, 400)
        nothing = {'returned': 0, 'used': 0, 'lost': 0, 'released': False, 'note': '', 'person': 'Ann'}
        for item, change, status in ((4, {}, 409), (2, {'returned': 25}, 409), (2, {'returned': -1}, 409), (2, {'released': True}, 409),
                                     (2, {'lost': 'one'}, 400)):
            self.refuse('POST', f'inspections/1/items/{item}', {**nothing, **change}, status)

    def account_for_items(self, closing):
        nothing = {'returned': 0, 'used': 0, 'lost': 0, 'released': False, 'note': '', 'person': 'Ann'}
        for item, change in ((1, {'returned': 1}), (2, {'used': 23, 'lost': 1}), (3, {'returned': 1}),
                             (2, {'used': 23, 'lost': 1, 'released': True, 'note': 'seen to fall outside'})):
            self.refuse('POST', 'inspections/1/close', closing, 409)
            after = self.post(f'inspections/1/items/{item}', 'ItemRequest', {**nothing, **change}, 'Inspection')
        self.assertEqual([item['state'] for item in after['items']], ['back', 'released', 'back'])
        self.assertIn('lost-item', after['closing_note_for'])

    def close(self):
        self.get('inspections/1/rounds', 'RoundList')
        found = self.get('inspections/1', 'Inspection')
        closing = {'comparison': found['comparison'], 'note': '', 'person': 'Ann'}
        for finding in found['findings']:
            self.refuse('POST', 'inspections/1/close', closing, 409)
            self.post(f'inspections/1/findings/{finding["number"]}/decision', 'DecisionRequest',
                      {'comparison': found['comparison'], 'verdict': 'installed-work', 'note': '', 'person': 'Ann'}, 'Inspection')
        self.account_for_items(closing)
        self.refuse('POST', 'inspections/1/close', closing, 409)
        closing['note'] = 'one collar fell outside'
        closed = self.post('inspections/1/close', 'CloseRequest', closing, 'Inspection')
        self.assertEqual(closed['stage'], 'done')
        self.refuse('POST', 'inspections/1/close', closing, 409)
        self.get('inspections?text=n1+bay&stage=done&most=5', 'InspectionList')

    def begin_another_round(self):
        self.post('inspections/1/capture', 'CaptureRequest', {'side': 'final', 'person': 'Ann', 'replaced': True}, status=202)
        self.cancel('capture')
        self.get('inspections/1', 'Inspection')

    def cancel(self, kind):
        self.console.wait_for(lambda status: (status['task']['kind'], status['task']['end']) == (kind, 'running'))
        self.post('cancel', None, {}, status=202)
        self.console.wait_for(lambda status: (status['task']['kind'], status['task']['end']) == (kind, 'cancelled'))

    def add_account(self, name, role):
        subprocess.run(self.command('account', 'add', name, '--role', role, '--data', self.folder / 'data'),
                       input='correct horse\n', check=True, capture_output=True, encoding='utf-8')

    def cookie_of(self, name):
        body, headers = {'name': name, 'password': 'correct horse'}, {}
        SCHEMA.check('SignInRequest', body)
        SCHEMA.check('Empty', ask(self.address, 'POST', '/api/sign-in', body, headers=headers)[1])
        return headers['Set-Cookie'].split(';')[0]

    def sign(self):
        self.add_account('ida', 'inspector')
        self.cookie = self.cookie_of('ida')
        before = self.console.status['task']['number']
        other = {'name': 'ann', 'password': 'correct horse'}
        self.refuse('POST', 'inspections/1/sign', {'password': 'correct horse', 'others': [other]}, 403)
        self.add_account('max', 'operator')
        self.post('inspections/1/sign', 'SignRequest', {'password': 'correct horse', 'others': [{**other, 'name': 'max'}]}, status=202)
        self.console = self.open_console()
        self.wait_for_task('signing', before)
        package, = self.get('inspections/1', 'Inspection')['signed']
        self.assertEqual([key.split('+')[0] for key in package['signers']], ['ida', 'max'])
        self.assertEqual(len(self.get('keys', 'KeyList')['keys']), 3)
        self.assertTrue(self.get('inspections', 'InspectionList')['inspections'][-1]['has_signature'])
        self.succeed('inspection', 'verify', self.folder / 'data' / package['folder'], '--log', self.folder / 'data/log')

    def sign_in(self):
        self.add_account('ann', 'viewer')
        self.get('session', 'Session')
        self.refuse('GET', 'inspections', None, 401)
        self.refuse('POST', 'sign-in', {'name': 'ann', 'password': 'wrong horse'}, 401)
        self.cookie = self.cookie_of('ann')
        self.get('session', 'Session')
        self.refuse('POST', 'cancel', {}, 403)
        self.post('sign-out', None, {})


if __name__ == '__main__':
    SCHEMA = ApiSchema(os.path.join(sys.argv.pop(2), 'console', 'schema', 'api.json'))
    program.main()
