"""What is shipped beside the executable fits it: configurations, the table of the paper's numbers, README's commands."""
import csv
import re
import shlex

import support
from support import SOURCE

CONFIGS = sorted(p for p in (SOURCE / "configs").rglob("*.json") if "schema" not in p.parts)
COMMAND = re.compile(r"^\s*(?:\$ )?(?:asperity|(?:\./)?build/release/app/asperity) (.*)$")


def shell_commands(text):
    """Argument lists of every asperity command in the fenced code blocks, up to a pipe, a redirection or a comment."""
    commands = []
    blocks = re.findall(r"(?ms)^```[a-z]*\n(.*?)^```", text)
    for line in "\n".join(blocks).replace("\\\n", " ").splitlines():
        match = COMMAND.match(line)
        if match:
            words = shlex.split(re.split(r"\s[|>;&]|\s2>", match[1])[0], comments=True)
            commands.append(words)
    return commands


class Shipped(support.CommandLineTest):
    def test_every_config_is_valid(self):
        self.assertGreaterEqual(len(CONFIGS), 10)
        result = self.succeed("validate", *CONFIGS)
        for path in CONFIGS:
            self.assertIn(f"{path}: valid", result.stdout)

    def test_the_paper_table_names_existing_configs(self):
        folder = SOURCE / "configs/paper"
        with open(folder / "index.csv", newline="") as table:
            rows = list(csv.DictReader(table))
        self.assertEqual({r["config"] for r in rows}, {p.name for p in folder.glob("*.json")})
        for row in rows:
            self.assertTrue(row["paper_reference"] and row["quantity"] and row["printed_value"], row)


class Readme(support.CommandLineTest):
    @classmethod
    def setUpClass(cls):
        path = SOURCE / "README.md"
        assert path.is_file(), f"{path} does not exist; it must show the commands that a newcomer types"
        cls.commands = shell_commands(path.read_text())

    def test_it_shows_commands(self):
        self.assertTrue(self.commands, "README.md has no line that begins with `asperity ` in a code block")

    def test_every_subcommand_and_option_exists(self):
        for words in self.commands:
            with self.subTest(command=" ".join(words)):
                text = self.succeed(*([] if words[0].startswith("-") else words[:1]), "--help").stdout
                for option in (w.split("=")[0] for w in words if w.startswith("--")):
                    self.assertRegex(text, rf"(?m){re.escape(option)}\b")

    def test_every_config_named_exists(self):
        for words in self.commands:
            for word in words:
                if word.startswith("configs/"):
                    self.assertTrue(list(SOURCE.glob(word)), f"{word} in `asperity {' '.join(words)}`")


if __name__ == "__main__":
    support.main()
