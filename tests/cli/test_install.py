"""`cmake --install`: what lies below the prefix, and that it needs neither the sources nor the build."""
import gzip
import os
import re
import signal
import subprocess
import time

import support
from support import BINARY, SCRATCH, SOURCE, environment

BUILD = BINARY.parent.parent
MOVED = SCRATCH / "moved"  # the prefix is not where it was installed to any more
ELSEWHERE = SCRATCH / "elsewhere"


class Install(support.CommandLineTest):
    @classmethod
    def setUpClass(cls):
        prefix = SCRATCH / "prefix"
        done = subprocess.run(["cmake", "--install", BUILD, "--prefix", prefix], capture_output=True, text=True, timeout=120)
        assert done.returncode == 0, done.stderr
        prefix.rename(MOVED)
        ELSEWHERE.mkdir()
        cls.program = MOVED / "bin/asperity"

    def run_it(self, *arguments):
        return subprocess.run([self.program, *arguments], capture_output=True, text=True, timeout=60, cwd=ELSEWHERE, env=environment())

    def test_every_installed_configuration_is_valid_from_another_folder(self):
        configs = MOVED / "share/asperity/configs"
        some = [configs / "quickstart.json", configs / "campaign/joint_cases.json", configs / "calibration/plaster.json", configs / "confrontation/zigong.json"]
        result = self.run_it("validate", *some)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(sorted(p.relative_to(configs) for p in configs.rglob("*") if p.is_file()),
                         sorted(p.relative_to(SOURCE / "configs") for p in (SOURCE / "configs").rglob("*") if p.is_file()))

    def test_default_configurations_are_found_beside_the_program(self):
        """A command that finds none ends at once with 3; this one computes until it is told to stop."""
        audit = subprocess.Popen([self.program, "audit", "--rows", "1", "--seeds", "1", "--jobs", "1"], cwd=ELSEWHERE, env=environment(),
                                 stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        deadline = time.monotonic() + 2
        while audit.poll() is None and time.monotonic() < deadline:
            time.sleep(0.05)
        audit.send_signal(signal.SIGINT)
        errors = audit.communicate(timeout=60)[1]
        self.assertEqual(audit.returncode, 130, errors)

    def test_manual_completions_and_documents(self):
        manual = gzip.open(MOVED / "share/man/man1/asperity.1.gz", "rt").read()
        self.assertEqual(manual, self.run_it("manual").stdout)
        for shell, path in {"bash": "bash-completion/completions/asperity", "zsh": "zsh/site-functions/_asperity",
                            "fish": "fish/vendor_completions.d/asperity.fish"}.items():
            self.assertEqual((MOVED / "share" / path).read_text(), self.run_it("completion", shell).stdout)
        self.assertTrue((MOVED / "share/doc/asperity/examples/quickstart.json").is_file())

    def test_links_of_the_readme_lead_to_installed_documents(self):
        folder = MOVED / "share/doc/asperity"
        links = re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", (folder / "README.md").read_text())
        self.assertGreater(len(links), 10)
        self.assertEqual([link for link in links if not (folder / link).exists()], [])

    def test_nothing_names_the_build_or_the_sources(self):
        release = "-DNDEBUG" in self.run_it("info").stdout  # an assertion names its source file
        for path in MOVED.rglob("*"):
            if path.is_file() and (release or path != self.program):
                content = path.read_bytes()
                for folder in {str(BUILD), str(SOURCE)}:
                    self.assertNotIn(os.fsencode(folder) + b"/", content, path)
        self.assertNotRegex(subprocess.run(["readelf", "-d", self.program], capture_output=True, text=True).stdout, "R(UN)?PATH")


if __name__ == "__main__":
    support.main()
