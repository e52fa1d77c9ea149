"""A report page as a reader's program sees it: its elements, headings, pictures, links and words."""
import html.parser

VOID = {"meta", "img", "br", "link", "input"}


class Page(html.parser.HTMLParser):
    """What a page shows, and whether its elements are closed in order."""

    def __init__(self, text):
        super().__init__()
        self.open, self.headings, self.images, self.links, self.controls, self.words = [], [], [], [], [], ""
        self.viewer = None
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        if tag not in VOID:
            self.open.append(tag)
        if tag[0] == "h" and tag[1:].isdigit():
            self.headings.append((int(tag[1:]), ""))
        if tag == "img":
            self.images.append(values)
        if tag == "a":
            self.links.append(values["href"])
        if tag in ("input", "button"):
            self.controls.append(values)
        self.viewer = values.get("data-viewer", self.viewer)

    def handle_endtag(self, tag):
        if self.open.pop() != tag:
            raise ValueError(f"</{tag}> closes another element")

    def handle_data(self, data):
        if "style" in self.open or "script" in self.open:
            return
        self.words += data
        if self.open and self.open[-1][0] == "h" and self.open[-1][1:].isdigit():
            level, text = self.headings.pop()
            self.headings.append((level, text + data))

    def sections(self):
        return [text for level, text in self.headings if level == 2]


def check_self_contained(test, folder, text, page):
    """No network, headings in order, an alternative text for every picture, and every link leads to a file."""
    test.assertEqual(page.open, [])
    for word in ("http:", "https:", "<script src", "javascript:", "@import", "url("):
        test.assertNotIn(word, text)
    levels = [level for level, _ in page.headings]
    test.assertEqual(levels[0], 1)
    test.assertEqual(levels.count(1), 1)
    test.assertTrue(all(b <= a + 1 for a, b in zip(levels, levels[1:])), levels)
    for image in page.images:
        test.assertGreater(len(image["alt"]), 20, image)
        test.assertTrue((folder / image["src"].replace("%20", " ")).is_file(), image)
    for link in page.links:
        if link.startswith("#"):
            test.assertIn(f'id="{link[1:]}"', text)
        elif not link.startswith("configs/"):
            test.assertTrue((folder / link.replace("%20", " ")).is_file(), link)
