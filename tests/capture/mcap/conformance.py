"""Reads the conformance corpus of github.com/foxglove/mcap with our reader and compares the messages.

usage: conformance.py PROBE CORPUS     CORPUS is tests/conformance/data of that repository
"""
import json
import pathlib
import subprocess
import sys


def expected_messages(description):
    """The lines that the probe prints for a file, from the corpus' description of its records."""
    schemas, channels, lines = {}, {}, []
    for record in description['records']:
        fields = dict(record['fields'])
        if record['type'] == 'Schema':
            schemas[fields['id']] = fields['name']
        elif record['type'] == 'Channel':
            channels[fields['id']] = fields
        elif record['type'] == 'Message':
            channel = channels[fields['channel_id']]
            data = bytes(int(byte) for byte in fields['data']).hex()
            lines.append(f"{channel['topic']} {schemas.get(channel['schema_id'], '-')} {channel['message_encoding']} "
                         f"{fields['log_time']} {data}")
    return sorted(lines)


def main():
    probe, corpus = sys.argv[1], pathlib.Path(sys.argv[2])
    if not sys.argv[2] or not corpus.is_dir():
        print(f'SKIPPED: no corpus: clone github.com/foxglove/mcap and give its tests/conformance/data as RVA_MCAP_CORPUS to CMake')
        return 77
    wrong = files = 0
    for file in sorted(corpus.rglob('*.mcap')):
        files += 1
        done = subprocess.run([probe, file], capture_output=True, text=True)
        wanted = expected_messages(json.loads(file.with_suffix('.json').read_text()))
        if done.returncode != 0 or sorted(done.stdout.splitlines()) != wanted:
            wrong += 1
            print(f'{file.name}: {done.stderr.strip() or "other messages"}')
    print(f'{files - wrong} of {files} files are read as they are described')
    return 1 if wrong or not files else 0


if __name__ == '__main__':
    sys.exit(main())
