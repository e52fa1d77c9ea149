"""What is wrong with a configuration is said all at once, by `run` and `validate` alike, and nothing is written."""
import json
import re

import support
from support import SCRATCH, TINY, asperity, settings

FAULTY = """{
  "experiment": {"type": "brazilian", "diametre_mm": 54, "diameter_mm": -3, "confining_pressure_mpa": 1},
  "particles": {"edge_mm": 5, "edge_mm": 6, "seed": "one"}
}"""


def write_config(name, text):
    path = SCRATCH / name
    path.write_text(text)
    return path


def fault_lines(stderr, config):
    """The faults as pointer-and-text lines, without what `run` and `validate` put around them."""
    lines = [line.removeprefix("error: ") for line in stderr.splitlines()]
    return [line for line in lines if line and line != f"{config}:"]


class ConfigFaults(support.CommandLineTest):
    def faults(self, config, *overrides):
        """Faults that `run` finds; checks that it exits 3, writes nothing, and that `validate` finds the same."""
        out = SCRATCH / "must_not_appear"
        before = support.listing(SCRATCH)
        run = self.fail_with(3, "run", config, *overrides, "--out", out)
        validate = self.fail_with(3, "validate", config, *overrides)
        self.assertEqual(fault_lines(validate, config), fault_lines(run, config))
        self.assertEqual(support.listing(SCRATCH), before)
        return fault_lines(run, config)

    def assert_fault(self, faults, pointer, *words):
        """Exactly one fault at the pointer, with these words and a hint."""
        found = [f for f in faults if f.startswith(f"{pointer}: ")]
        self.assertEqual(len(found), 1, faults)
        for word in [*words, "Hint: "]:
            self.assertIn(word, found[0])

    def test_missing_file_is_named(self):
        faults = self.faults(SCRATCH / "no_such_file.json")
        self.assertEqual(len(faults), 1)
        self.assertIn("no_such_file.json: cannot be read: No such file or directory", faults[0])

    def test_text_that_is_no_json_is_placed(self):
        faults = self.faults(write_config("broken.json", '{\n  "experiment": {"type": "brazilian",,}\n}\n'))
        self.assertRegex(faults[0], r"broken\.json:2:\d+: ")

    def test_bad_value(self):
        faults = self.faults(TINY, *settings(experiment__diameter_mm=-3))
        self.assert_fault(faults, "/experiment/diameter_mm", "out of range", "found -3", "allowed: 1 to 10000 mm")
        self.assertEqual(len(faults), 1)

    def test_wrong_type(self):
        faults = self.faults(write_config("type.json", '{"experiment": {"type": "brazilian"}, "particles": {"edge_mm": "two"}}'))
        self.assert_fault(faults, "/particles/edge_mm", '"two"')

    def test_unknown_key(self):
        config = json.loads(TINY.read_text())
        config["particles"]["edge_mn"] = 5
        config["contacts"]["cohesion_mp"] = 5
        faults = self.faults(write_config("unknown.json", json.dumps(config)))
        self.assert_fault(faults, "/particles/edge_mn", "is not a key", "did you mean edge_mm?")
        self.assert_fault(faults, "/contacts/cohesion_mp", "is not a key", "did you mean cohesion_mpa?")

    def test_duplicate_key(self):
        faults = self.faults(write_config("twice.json", '{"experiment": {"type": "brazilian"}, "name": "a", "name": "b"}'))
        self.assert_fault(faults, "/name", "is given twice")

    def test_several_faults_at_once(self):
        faults = self.faults(write_config("several.json", FAULTY))
        self.assert_fault(faults, "/particles/edge_mm", "is given twice")
        self.assert_fault(faults, "/particles/seed", '"one"')
        self.assert_fault(faults, "/experiment/diametre_mm", "did you mean diameter_mm?")
        self.assert_fault(faults, "/experiment/diameter_mm", "found -3")
        self.assert_fault(faults, "/experiment/confining_pressure_mpa", "has no meaning", "brazilian")
        self.assertEqual(len(faults), 5, faults)

    def test_edge_longer_than_the_specimen(self):
        faults = self.faults(TINY, *settings(particles__edge_mm=60))
        self.assert_fault(faults, "/particles/edge_mm", "too long for the specimen", "found 60")

    def test_override_at_an_unknown_pointer(self):
        faults = self.faults(TINY, *settings(particles__edge_m=3))
        self.assert_fault(faults, "/particles/edge_m", "did you mean edge_mm?")

    def test_override_with_a_bad_value(self):
        faults = self.faults(TINY, *settings(contacts__law__reading="literally"))
        self.assert_fault(faults, "/contacts/law/reading", "literally")

    def test_time_step_far_above_the_stable_one(self):
        faults = self.faults(TINY, *settings(integration__time_step_s=1e-3))
        self.assert_fault(faults, "/integration/time_step_s", "above the stable time step", "found 0.001")

    def test_time_step_that_only_the_mesh_shows_to_be_unstable(self):
        text = self.succeed("validate", TINY).stdout
        stable = float(re.search(r"time step (\S+) s", text)[1]) / 0.7  # the default safety factor
        self.succeed("validate", TINY, *settings(integration__time_step_s=0.99 * stable))
        faults = self.faults(TINY, *settings(integration__time_step_s=1.02 * stable))
        self.assert_fault(faults, "/integration/time_step_s", "above the stable time step of this mesh", "found ", "at most ")

    def test_validate_goes_on_after_a_faulty_file(self):
        faulty = write_config("faulty.json", FAULTY)
        result = asperity("validate", faulty, TINY)
        self.assertEqual(result.returncode, 3)
        self.assertIn(f"{TINY}: valid", result.stdout)
        self.assertIn(f"{faulty}:", result.stderr)


if __name__ == "__main__":
    support.main()
