"""The text of an HTML page, and what is wrong with it."""
import html.parser


class ReadPage(html.parser.HTMLParser):
    """The text of a page, and what is wrong with it: elements that are not closed, scripts, what is loaded from elsewhere."""

    def __init__(self, page):
        super().__init__()
        self.faults, self.open, self.words = [], [], []
        self.feed(page)
        self.close()
        self.faults += self.open
        self.text = ' '.join(' '.join(self.words).split())

    def handle_starttag(self, tag, attributes):
        if tag not in ('meta', 'img'):
            self.open.append(tag)
        self.faults += [f'{tag} {name}' for name, value in attributes
                        if name.startswith('on') or name == 'href' or (name == 'src' and not value.startswith('data:'))]
        if tag in ('script', 'link', 'iframe'):
            self.faults.append(tag)

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.faults.append(f'/{tag}')

    def handle_data(self, data):
        self.words.append(data)
