"""The pages of the repository hold together: links lead somewhere, commands and paths exist, made pages are as made."""
import functools
import re
import shlex
import sys
import unittest

import markdown

sys.path.insert(0, str(__import__("pathlib").Path(__file__).resolve().parents[1] / "cli"))
import support  # noqa: E402
from support import SOURCE  # noqa: E402

PAGES = markdown.markdown_files(SOURCE)
KINDS = ("run", "campaign", "calibration", "confrontation", "measured")
REFERENCE_KEY = re.compile(r"(?m)^\| `(/[^`]+)` \|")
KEY = re.compile(r"^(?:/[a-z0-9_$]+)+$")
# A path in code: of a folder of this repository, without places for names.
PATH = re.compile(r"^(?:app|cmake|configs|core|docs|render|tests)/[\w./*{},-]+$")


def text_of(path):
    return path.read_text(encoding="utf-8")


@functools.lru_cache(maxsize=None)
def anchors_of(path):
    return markdown.anchors(text_of(path))


def arguments(command):
    """Words of a command up to a pipe, a redirection or a comment; placeholders and ellipses stay words."""
    return shlex.split(re.split(r"\s[|>;&]|\s2>", command)[0], comments=True)


def expanded(pattern):
    """`a.{hpp,cpp}` as its two paths."""
    match = re.search(r"\{([^{}]*)\}", pattern)
    if not match:
        return [pattern]
    return [p for word in match[1].split(",") for p in expanded(pattern[:match.start()] + word + pattern[match.end():])]


class Links(unittest.TestCase):
    def test_there_are_pages(self):
        self.assertGreater(len(PAGES), 40)

    def test_every_relative_link_leads_to_a_file_and_a_heading(self):
        dead = []
        for page in PAGES:
            for link in markdown.links(text_of(page)):
                if re.match(r"[a-z]+:", link):
                    continue
                file, _, anchor = link.partition("#")
                target = (page.parent / file).resolve() if file else page
                if not target.exists() or SOURCE not in (target, *target.parents):
                    dead.append(f"{page.relative_to(SOURCE)}: {link}")
                elif anchor and target.suffix == ".md" and anchor not in anchors_of(target):
                    dead.append(f"{page.relative_to(SOURCE)}: {link}: no such heading")
        self.assertEqual(dead, [])

    def test_the_index_leads_to_every_page(self):
        index = SOURCE / "docs/README.md"
        self.assertIn("docs/README.md", markdown.links(text_of(SOURCE / "README.md")))
        linked = {(index.parent / link.partition("#")[0]).resolve() for link in markdown.links(text_of(index))}
        missing = [str(p.relative_to(SOURCE)) for p in PAGES if p not in linked and p not in (index, SOURCE / "CHANGELOG.md")]
        self.assertEqual(missing, [])


class Mentions(support.CommandLineTest):
    def test_every_subcommand_and_option_exists(self):
        helps = {}
        general = self.succeed("--help").stdout
        for page in PAGES:
            for command in markdown.mentioned_commands(text_of(page)):
                words = arguments(command)
                if not words or not re.fullmatch(r"[a-z]+", words[0]):
                    continue  # an option, or a place for a name
                with self.subTest(page=str(page.relative_to(SOURCE)), command=command):
                    self.assertRegex(general, rf"(?m)^ +{words[0]} ")
                    if words[0] not in helps:
                        helps[words[0]] = self.succeed(words[0], "--help").stdout
                    for option in (w.split("=")[0] for w in words if w.startswith("--")):
                        self.assertRegex(helps[words[0]], rf"(?m){re.escape(option)}\b")

    def test_every_key_that_a_page_names_exists(self):
        """A JSON pointer in code is a key of some schema, or below one whose contents are free."""
        known = {key for kind in KINDS for key in REFERENCE_KEY.findall(text_of(SOURCE / f"docs/reference/{kind}.md"))}
        roots = {key.split("/")[1] for key in known}
        dead = []
        for page in PAGES:
            for span in markdown.SPAN.findall(markdown.BLOCK.sub("", text_of(page))):
                key = span.split("=")[0]
                if KEY.match(key) and key.split("/")[1] in roots and key not in known:
                    dead.append(f"{page.relative_to(SOURCE)}: {key}")
        self.assertEqual(dead, [])

    def test_every_path_that_a_guide_names_exists(self):
        dead = []
        for page in [SOURCE / "docs/extending.md", *sorted((SOURCE / "docs/physics").glob("*.md")), SOURCE / "docs/tutorial.md"]:
            for span in markdown.SPAN.findall(markdown.BLOCK.sub("", text_of(page))):
                if PATH.match(span):
                    dead += [f"{page.name}: {p}" for p in expanded(span) if not list(SOURCE.glob(p.rstrip("/")))]
        self.assertEqual(dead, [])


class Reference(support.CommandLineTest):
    def test_every_page_is_what_the_command_writes(self):
        for kind in KINDS:
            with self.subTest(kind=kind):
                page = SOURCE / f"docs/reference/{kind}.md"
                self.assertEqual(self.succeed("schema", kind, "--markdown").stdout, text_of(page),
                                 f"asperity schema {kind} --markdown > docs/reference/{kind}.md makes it anew")

    def test_an_unknown_kind_is_refused(self):
        self.assertIn("no-such-kind", self.fail_with(2, "schema", "no-such-kind", "--markdown"))


if __name__ == "__main__":
    support.main()
