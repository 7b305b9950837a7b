"""Runs programs for the tests of this folder."""
import subprocess

TIMEOUT_S = 250


def run(*command, **options):
    if 'input' not in options:
        options['stdin'] = subprocess.DEVNULL
    return subprocess.run([*map(str, command)], capture_output=True, text=True, timeout=TIMEOUT_S, **options)


def output_of(*command, **options):
    done = run(*command, **options)
    if done.returncode:
        raise AssertionError(f'{command}: {done.stdout}{done.stderr}')
    return done.stdout
