"""Every command of docs/tutorial.md, in order, in an empty folder that sees the repository's configs: exit codes, the output that the
page shows, the files that it names."""
import os
import pathlib
import re
import subprocess
import sys
import unittest

import markdown

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cli"))
import support  # noqa: E402
from support import BINARY, SCRATCH, SOURCE  # noqa: E402

TUTORIAL = SOURCE / "docs/tutorial.md"
SECONDS = 900  # one command; the slowest takes half a minute on an idle core
NUMBER = re.compile(r"(?<![\w.])[-+]?\d[\d,]*(?:\.\d+)?(?:e[-+]?\d+)?(?![\w.]*\d)")
# Runs give the same bytes with the same compiler and libraries. With others the order in which contacts break may differ,
# and a peak with it by some per cent.
SHARE = 0.05
OUTPUT = re.compile(r"^outputs/[\w./*-]+$")


def steps(text):
    """(commands, lines shown below them) of each sh block; a text block right behind it shows what the last one prints."""
    found = []
    for language, body in markdown.blocks(text):
        if language == "sh":
            found.append((markdown.shell_lines(body), []))
        elif language == "text" and found:
            found[-1][1].extend(line for line in body.splitlines() if line.strip() not in ("", "..."))
    return found


def same_line(shown, printed):
    """Words equal, numbers within SHARE."""
    def words(line):
        return " ".join(NUMBER.sub("#", line).split())

    def numbers(line):
        return [float(n.replace(",", "")) for n in NUMBER.findall(line)]
    if words(shown) != words(printed):
        return False
    return all(abs(a - b) <= SHARE * abs(b) + 1e-12 for a, b in zip(numbers(shown), numbers(printed)))


def not_printed(shown, printed):
    """Shown lines that the output has not, in this order."""
    rest, missing = iter(printed), []
    for line in shown:
        if not any(same_line(line, other) for other in rest):
            missing.append(line)
            rest = iter(printed)
    return missing


class Comparison(unittest.TestCase):
    def test_numbers_may_differ_a_little_and_words_not_at_all(self):
        self.assertTrue(same_line("peak 2.80 MPa, 1,356 triangles", "peak  2.81 MPa, 1,356 triangles"))
        self.assertFalse(same_line("peak 2.80 MPa", "peak 3.10 MPa"))
        self.assertFalse(same_line("peak 2.80 MPa", "peak 2.80 GPa"))
        self.assertEqual(not_printed(["b", "a"], ["a", "b"]), ["a"])
        self.assertEqual(not_printed(["a", "b"], ["a", "x", "b"]), [])

    def test_blocks_are_found(self):
        page = "```sh\n# c\na \\\n  b\nc\n```\nx\n```text\nout\n...\n```\n```json\n{}\n```\n"
        self.assertEqual(steps(page), [(["a    b", "c"], ["out"])])


class Tutorial(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        """A folder as the repository's root is, with an empty outputs/, and `asperity` on the PATH."""
        cls.work, tools = SCRATCH / "work", SCRATCH / "bin"
        cls.work.mkdir()
        tools.mkdir()
        (cls.work / "configs").symlink_to(SOURCE / "configs")
        (tools / "asperity").symlink_to(BINARY)
        cls.environment = {**support.environment(), "PATH": f"{tools}{os.pathsep}{os.environ['PATH']}"}

    def run_command(self, command):
        return subprocess.run(["sh", "-c", command], capture_output=True, text=True, timeout=SECONDS, cwd=self.work, env=self.environment)

    def test_every_command_runs_and_prints_what_the_page_shows(self):
        text = TUTORIAL.read_text(encoding="utf-8")
        chapters = steps(text)
        self.assertGreater(sum(len(commands) for commands, _ in chapters), 12)
        self.assertGreater(sum(len(shown) for _, shown in chapters), 12)
        for commands, shown in chapters:
            for command in commands:
                result = self.run_command(command)
                self.assertEqual(result.returncode, 0, f"{command}\n{result.stderr[-2000:]}")
            self.assertEqual(not_printed(shown, result.stdout.splitlines()), [], f"{command} printed:\n{result.stdout[-3000:]}")
        named = {span for span in markdown.SPAN.findall(markdown.BLOCK.sub("", text)) if OUTPUT.match(span)}
        self.assertGreater(len(named), 10)
        self.assertEqual([name for name in sorted(named) if not list(self.work.glob(name.rstrip("/")))], [])


if __name__ == "__main__":
    support.main()
