"""`law`: pictures and tables of a configuration's contact law, and that the tables hold the law's own figures."""
import csv
import math

import support
from support import SCRATCH, SOURCE, settings

BRAZILIAN = SOURCE / "configs/paper/brazilian.json"
FIGURES = ("tension", "compression_shear", "strength", "damage")
T_C, C_C, TAN_PHI = 6.89, 5.02, math.tan(math.radians(36.5))  # Table 5
CLOSE = 1e-6  # the peaks are bisected


def rows(folder, figure, law="default", path=None):
    with open(folder / f"{figure}.csv") as file:
        return [r for r in csv.DictReader(file) if r["law"] == law and path in (None, r["path"])]


def numbers(table, column):
    return [float(r[column]) for r in table]


class Law(support.CommandLineTest):
    def law(self, name, *options, config=BRAZILIAN):
        out = SCRATCH / name
        lines = self.succeed("law", config, *options, "--out", out).stdout.splitlines()
        self.assertEqual(lines[-1], str(out))
        self.assertEqual(lines[:-1], [str(out / f"{f}.{kind}") for f in FIGURES for kind in ("png", "svg", "csv")])
        for path in lines[:-1]:
            self.assertTrue(support.pathlib.Path(path).stat().st_size > 1000, path)
        return out

    def test_the_tables_hold_the_laws_figures(self):
        out = self.law("brazilian")
        for law in ("default", "literal"):
            opening = rows(out, "tension", law, "opening")
            self.assertTrue(math.isclose(max(numbers(opening, "normal_traction_mpa")), T_C, rel_tol=CLOSE))
            self.assertEqual({r["leg"] for r in rows(out, "tension", law, "opening with unloading")},
                             {"loading", "unloading", "reloading"})
        for law, tan in (("default", TAN_PHI), ("literal", 0)):
            closed = [r for r in rows(out, "strength", law, "strength") if float(r["normal_traction_mpa"]) < 0]
            self.assertGreater(len(closed), 20)
            for r in closed:
                peak = C_C - float(r["normal_traction_mpa"]) * tan
                self.assertTrue(math.isclose(float(r["shear_traction_mpa"]), peak, rel_tol=CLOSE), r)

    def test_a_mechanism_changes_the_drawn_law(self):
        plain, curved = self.law("plain"), self.law("curved", "--set", '/mechanisms=[{"type":"curved_envelope"}]')
        highest = [max(numbers(rows(out, "strength", path="strength"), "shear_traction_mpa")) for out in (plain, curved)]
        self.assertLess(highest[1], 0.9 * highest[0])
        self.assertIn("curved_envelope", (curved / "strength.svg").read_text())

    def test_a_literal_configuration_is_drawn_over_the_default_law(self):
        out = self.law("literal", config=SOURCE / "configs/paper/brazilian_literal.json")
        self.assertIn("area under the literal law", (out / "tension.svg").read_text())

    def test_softening_ends_where_its_energy_says(self):
        out = self.law("soft", *settings(contacts__shear_fracture_energy_n_per_mm=0.3))
        self.assertIn("= 0.3 N/mm: area under the default law", (out / "compression_shear.svg").read_text())

    def test_faults(self):
        self.assertIn("/contacts/fracture_energy_n_per_mm", self.fail_with(
            3, "law", BRAZILIAN, *settings(contacts__fracture_energy_n_per_mm=0.001), "--out", SCRATCH / "faulty"))
        self.assertFalse((SCRATCH / "faulty").exists())
        (SCRATCH / "file").write_text("")
        self.fail_with(5, "law", BRAZILIAN, "--out", SCRATCH / "file")


if __name__ == "__main__":
    support.main()
