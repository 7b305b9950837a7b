"""Checks that each file includes what it uses, itself or through headers of the project: builds with precompiled
headers do not notice what is missing. The table has the names that precompiled headers (cmake/RvaTarget.cmake,
tests/CMakeLists.txt) declare.

usage: own_includes.py ROOT
"""
import functools
import pathlib
import re
import sys

NEEDED = {
    'algorithm': r'std::(?:ranges::)?(?:max|min|clamp|minmax|(?:max|min)_element|sort|stable_sort|find(?:_if)?|count(?:_if)?'
                 r'|all_of|any_of|none_of|copy|fill|transform|reverse|unique|nth_element|(?:lower|upper)_bound|equal)\b',
    'array': r'std::(?:array|to_array)\b',
    'chrono': r'std::chrono\b',
    'cmath': r'std::(?:sqrt|cbrt|hypot|exp|log(?:10|2|1p)?|pow|sin|cos|tan|a(?:sin|cos|tan2?)|floor|ceil|l?round|lrint|fmod'
             r'|is(?:finite|nan)|erfc?|lgamma)\b',
    'cstdint': r'\bstd::u?int(?:8|16|32|64|max|ptr)_t\b',
    'filesystem': r'std::filesystem\b',
    'functional': r'std::(?:function|bind_front|reference_wrapper|greater|less|plus)\b',
    'iterator': r'std::(?:back_inserter|next|prev|distance|[io]streambuf_iterator)\b',
    'limits': r'std::numeric_limits\b',
    'map': r'std::(?:multi)?map\b',
    'memory': r'std::(?:unique_ptr|shared_ptr|weak_ptr|make_(?:unique|shared)|enable_shared_from_this)\b',
    'numeric': r'std::(?:accumulate|iota|inner_product|gcd|reduce|transform_reduce|partial_sum)\b',
    'optional': r'std::(?:optional|nullopt|make_optional)\b',
    'set': r'std::(?:multi)?set\b',
    'span': r'std::span\b',
    'sstream': r'std::[io]?stringstream\b',
    'string': r'std::(?:string|to_string|stoi|stod|stoull?|getline)\b',
    'tuple': r'std::(?:tuple|tie|make_tuple|forward_as_tuple)\b',
    'vector': r'std::vector\b',
    'Eigen/': r'\bEigen::',
    'fmt/': r'\bfmt::',
    'g(?:test|mock)/': r'^(?:TEST|TEST_F|TEST_P)\(|\btesting::',
}
NEEDED = {header: re.compile(use, re.MULTILINE) for header, use in NEEDED.items()}
COMMENT_OR_TEXT = re.compile(r'//[^\n]*|"(?:\\.|[^"\\\n])*"')
INCLUDE = re.compile(r'^\s*#\s*include\s+(?:"([^"]+)"|<([^>]+)>)', re.MULTILINE)


class Sources:
    def __init__(self, root):
        self.root = root

    def found(self, file, included):
        """The project's header of this name, None where there is none."""
        for folder in (file.parent, self.root / 'src', self.root, self.root / 'tests'):
            if (folder / included).is_file():
                return (folder / included).resolve()
        return None

    @functools.cache
    def system_headers(self, file):
        """All headers of others that a file includes, itself or through headers of the project."""
        headers = set()
        for own, other in INCLUDE.findall(file.read_text()):
            inner = self.found(file, own) if own else None
            headers |= self.system_headers(inner) if inner else {own or other}
        return headers

    def missing_in(self, file):
        text = COMMENT_OR_TEXT.sub('', file.read_text())
        headers = self.system_headers(file)
        return [header for header, use in NEEDED.items()
                if use.search(text) and not any(re.match(header + ('' if header.endswith('/') else '$'), one) for one in headers)]


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    sources = Sources(root)
    files = sorted(file for folder in ('src', 'tests', 'bench', 'examples', 'python') for file in (root / folder).rglob('*.[ch]pp'))
    faults = [f'{file.relative_to(root)}: uses what <{header}> declares, but does not include it'
              for file in files for header in sources.missing_in(file)]
    if len(files) < 100:
        faults.append(f'{root}: only {len(files)} files were found')
    print('\n'.join(faults) or f'{len(files)} files include what they use')
    return 1 if faults else 0


if __name__ == '__main__':
    sys.exit(main())
