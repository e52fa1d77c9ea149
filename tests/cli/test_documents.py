"""Completion scripts and the manual name every command and option that --help names, and the shells can use them."""
import functools
import re
import shutil
import subprocess

import support
from support import SCRATCH, asperity, environment

BASH = """source "$1"; shift
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _asperity; printf '%s\\n' "${COMPREPLY[@]}" """
FISH = "source $argv[1]; complete -C $argv[2]"
# zsh completes in its line editor only: the function is called with stand-ins that print what they are told.
ZSH = """compdef() { : }
_arguments() { printf '%s\\n' "$@"; state=argument; line=($WORD); [[ $1 != -C ]] }
_describe() { : }
source $1; WORD=$2; _asperity"""


def options_of(text):
    """Every option in a --help, from the columns where options stand."""
    head = re.split(r"(?m)^(?:Examples?:|Start with:|Exit)", text)[0]
    first_words = [line.split()[0] for line in head.splitlines() if line.startswith("  -")]  # "-h,--help", "--no-render{false}"
    return {name for word in first_words for name in word.split("{")[0].split(",")}


@functools.cache
def options_of_commands():
    return {command: options_of(asperity(command, "--help").stdout) for command in support.commands()}


def in_shell(shell, program, *arguments):
    result = subprocess.run([shell, *(["-f"] if shell == "zsh" else []), "-c", program, *(["x"] if shell != "fish" else []), *arguments],
                            capture_output=True, text=True, timeout=60, cwd=SCRATCH, env=environment())
    return result.stdout.splitlines(), result.stderr


class Documents(support.CommandLineTest):
    @classmethod
    def setUpClass(cls):
        cls.options = options_of_commands()
        cls.scripts = {}
        for shell in ("bash", "zsh", "fish"):
            assert shutil.which(shell), f"no {shell}: install what app/packages.txt lists"
            cls.scripts[shell] = SCRATCH / f"completion.{shell}"
            cls.scripts[shell].write_text(asperity("completion", shell).stdout)

    def bash(self, *words):
        found, errors = in_shell("bash", BASH, self.scripts["bash"], "asperity", *words)
        self.assertEqual(errors, "")
        return set(found)

    def fish(self, line):
        found, errors = in_shell("fish", FISH, self.scripts["fish"], line)
        self.assertEqual(errors, "")
        return {entry.split("\t")[0] for entry in found}

    def test_help_is_read(self):
        self.assertLessEqual({"run", "confront", "completion", "manual"}, self.options.keys())
        self.assertEqual(self.options["run"], {"-h", "--help", "--set", "--out", "--threads", "--no-render", "--force", "--quiet"})

    def test_bash_completes_every_command_and_option(self):
        self.assertEqual(self.bash(""), self.options.keys() | {"-h", "--help", "--version"})
        for command, options in self.options.items():
            with self.subTest(command=command):
                self.assertEqual(self.bash(command, "-"), options)

    def test_fish_completes_every_command_and_option(self):
        self.assertEqual(self.fish("asperity "), set(self.options))
        for command, options in self.options.items():
            with self.subTest(command=command):
                self.assertEqual(self.fish(f"asperity {command} --"), {o for o in options if o.startswith("--")})

    def test_zsh_completes_every_command_and_option(self):
        for command, options in self.options.items():
            with self.subTest(command=command):
                told, errors = in_shell("zsh", ZSH, self.scripts["zsh"], command)
                self.assertEqual(errors, "")
                after = told[told.index("*::argument:->argument") + 1:]
                self.assertEqual({re.match(r"\*?(-[-a-z]+)\[", t)[1] for t in after if re.match(r"\*?-", t)}, options)

    def test_files(self):
        folder = SCRATCH / "files"
        folder.mkdir()
        (folder / "a test.json").write_text("{}")
        (folder / "other.txt").write_text("")
        (folder / "deeper").mkdir()
        self.assertEqual(self.bash("run", "files/"), {"files/a test.json", "files/deeper"})
        self.assertEqual(self.bash("run", "files/a test.json", "--out", "files/"), {"files/deeper"})
        self.assertEqual(self.bash("run", "--out", "=", "files/d"), {"files/deeper"})
        self.assertEqual(self.bash("bench", "--json", "files/o"), {"files/other.txt"})
        self.assertIn("files/a test.json", self.fish("asperity run files/a"))

    def test_words(self):
        for complete in (self.bash, lambda *words: self.fish("asperity " + " ".join(words))):
            self.assertEqual(complete("campaign", "--executor", ""), {"local", "slurm"})
            self.assertEqual(complete("mechanisms", "platen_f"), {"platen_friction"})
            self.assertEqual(complete("schema", "conf"), {"confrontation"})
            self.assertEqual(complete("render", "--field", "dam"), {"damage"})
            self.assertEqual(complete("run", "--set", "/particles/se"), {"/particles/seed="})
        self.assertEqual(self.bash("run", "--threads", ""), {""})

    def test_unknown_shell(self):
        self.assertIn("csh", self.fail_with(2, "completion", "csh"))


class Manual(support.CommandLineTest):
    @classmethod
    def setUpClass(cls):
        cls.page = SCRATCH / "asperity.1"
        cls.page.write_text(asperity("manual").stdout)

    def mandoc(self, *arguments):
        return subprocess.run(["mandoc", *arguments, self.page], capture_output=True, text=True, timeout=60)

    def test_it_has_nothing_that_lint_finds(self):
        result = self.mandoc("-T", "lint", "-W", "style")
        self.assertEqual((result.stdout, result.stderr, result.returncode), ("", "", 0))

    def test_it_has_every_command_with_its_options_and_examples(self):
        text = re.sub(".\b", "", self.mandoc("-T", "ascii").stdout)
        sections = dict(re.findall(r"(?ms)^   (\S+)\n(.*?)(?=^   \S|^\S)", text))
        for command, options in options_of_commands().items():
            with self.subTest(command=command):
                for option in options:
                    self.assertRegex(sections[command], rf"(?m)^ +.*{re.escape(option)}\b")
                self.assertRegex(sections[command], rf"(?m)^ {{11}}(source <\()?asperity {command}\b")  # usage is at 7
        self.assertRegex(text, r"(?s)EXIT STATUS.*130.*FILES.*configs/schema")


if __name__ == "__main__":
    support.main()
