"""The wiring plan: wiring.txt, drawn as SVG."""
import html
import re

COLUMN, NODE, TERMINAL, TOP, LEFT = 300, 200, 22, 90, 30
COLOURS = {'red': '#c0392b', 'black': '#222', 'blue': '#2563b0', 'orange': '#c56a00', 'green': '#2e8540', 'USB 3': '#6b3fa0', 'USB 2': '#777'}


class Plan:
    def __init__(self, text):
        self.columns, self.nodes, self.wires, self.notes = [], {}, [], []
        node = None
        for number, line in enumerate(text.splitlines(), 1):
            if not line or line.startswith('#'):
                continue
            if match := re.fullmatch(r'column: (.*) \| (.*)', line):
                self.columns.append(match.groups())
            elif match := re.fullmatch(r'node (\d+) (\w+): (.*)', line):
                node = self.nodes[match[2]] = {'column': int(match[1]) - 1, 'title': match[3], '<': [], '>': []}
            elif (match := re.fullmatch(r'([<>]) (.*)', line)) and node:
                node[match[1]].append(match[2])
            elif match := re.fullmatch(r'wire (\w+)\.(.*) -> (\w+)\.(.*): (.*)', line):
                self.wires.append(match.groups())
            elif match := re.fullmatch(r'inside (\w+)\.(.*) -> (\w+)(?:\.(.*?))?(?:: (.*))?', line):
                self.notes.append(match.groups())
            else:
                raise ValueError(f'wiring.txt:{number}: not understood: {line}')
        self._check()

    def _check(self):
        used = set()
        for source, out, target, into, kind in self.wires:
            if out not in self.nodes[source]['>'] or into not in self.nodes[target]['<']:
                raise ValueError(f'wiring.txt: no such terminal: {source}.{out} -> {target}.{into}')
            if self.nodes[target]['column'] - self.nodes[source]['column'] != 1:
                raise ValueError(f'wiring.txt: {source} and {target} are no neighbours')
            if kind not in COLOURS:
                raise ValueError(f'wiring.txt: no colour for {kind}')
            used |= {(source, '>', out), (target, '<', into)}
        for source, out, target, into, _ in self.notes:
            used |= {(source, '>', out), (target, '<', into)}
        for name, node in self.nodes.items():
            for side in '<>':
                for terminal in node[side]:
                    if (name, side, terminal) not in used:
                        raise ValueError(f'wiring.txt: {name}.{terminal} is not connected')

    def _place(self):
        heights = [TOP] * len(self.columns)
        for node in self.nodes.values():
            rows = max(len(node['<']), len(node['>']), 1)
            node['x'], node['y'] = LEFT + COLUMN * node['column'], heights[node['column']]
            node['height'] = 34 + TERMINAL * rows
            heights[node['column']] += node['height'] + 34
        return max(heights)

    @staticmethod
    def _terminal(node, side, name):
        return node['x'] + (NODE if side == '>' else 0), node['y'] + 34 + TERMINAL * node[side].index(name) + 8

    def _ends(self, wire):
        source, outlet, target, inlet, _ = wire
        return self._terminal(self.nodes[source], '>', outlet), self._terminal(self.nodes[target], '<', inlet)

    def _bent_wires(self, column):
        """Those that leave a column and change their height; each has a lane of its own."""
        def bends(wire):
            (_, y0), (_, y1) = self._ends(wire)
            return y0 != y1
        return [wire for wire in self.wires if self.nodes[wire[0]]['column'] == column and bends(wire)]

    def svg(self):
        height = self._place()
        width = LEFT + COLUMN * (len(self.columns) - 1) + NODE + LEFT
        total = height + 22 * len(self.notes) + 30
        out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {total}" font-family="sans-serif" font-size="12">',
               f'<rect width="{width}" height="{total}" fill="white"/>']

        def text(x, y, content, **attributes):
            extra = ''.join(f' {key.replace("_", "-")}="{value}"' for key, value in attributes.items())
            out.append(f'<text x="{x}" y="{y}"{extra}>{html.escape(content)}</text>')

        for index, (title, subtitle) in enumerate(self.columns):
            x = LEFT + COLUMN * index + NODE / 2
            text(x, 36, title, text_anchor='middle', font_weight='bold', font_size=15)
            text(x, 56, subtitle, text_anchor='middle', fill='#555')
        lanes = [self._bent_wires(column) for column in range(len(self.columns))]
        for wire in self.wires:
            (x0, y0), (x1, y1) = self._ends(wire)
            source, kind = wire[0], wire[4]
            bent = lanes[self.nodes[source]['column']]
            middle = x0 + (x1 - x0) * (bent.index(wire) + 1) / (len(bent) + 1) if wire in bent else x1
            out.append(f'<path d="M{x0} {y0}H{middle:.1f}V{y1}H{x1}" fill="none" stroke="{COLOURS[kind]}" stroke-width="2.2"/>')
        for node in self.nodes.values():
            out.append(f'<rect x="{node["x"]}" y="{node["y"]}" width="{NODE}" height="{node["height"]}" rx="5" fill="#f4f6f8" stroke="#456"/>')
            text(node['x'] + NODE / 2, node['y'] + 18, node['title'], text_anchor='middle', font_weight='bold',
                 font_size=12 if len(node['title']) < 28 else 9.5)
            for side, anchor, shift in (('<', 'start', 9), ('>', 'end', -9)):
                for name in node[side]:
                    x, y = self._terminal(node, side, name)
                    out.append(f'<circle cx="{x}" cy="{y}" r="3.5" fill="#456"/>')
                    text(x + shift, y + 4, name, text_anchor=anchor, font_size=11)
        text(LEFT, height + 6, 'Inside the control box:', font_weight='bold')
        for index, (source, outlet, target, inlet, note) in enumerate(self.notes, 1):
            end = self.nodes[target]['title'] + (f', {inlet}' if inlet else '')
            text(LEFT, height + 6 + 22 * index, f'{self.nodes[source]["title"]}, {outlet} to {end}: {note}')
        out.append('</svg>')
        return '\n'.join(out) + '\n'
