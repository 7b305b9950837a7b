"""Problems with files that cannot be opened."""
import zlib

from setting import LOST, Problem


def unless_whole(check, data, what):
    try:
        check(data)
    except (ValueError, KeyError, zlib.error) as error:
        return [Problem(LOST, f'{what} {error}')]
    return []
