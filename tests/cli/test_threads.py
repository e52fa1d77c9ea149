"""The number of threads changes no byte of the results."""
import support
from support import SCRATCH, SOURCE, settings

# Loops run in blocks of 1024, so the mesh must have a few thousand nodes and contacts for two threads to share anything; the
# weak contacts make cracks within a few thousand steps.
CONFIG = SOURCE / "configs/quickstart.json"
SHORT = settings(
    particles__edge_mm=2, experiment__loading__closing_rate_mm_per_s=1000, experiment__loading__ramp_time_s=0,
    experiment__stop__axial_strain=0.012, contacts__tensile_strength_mpa=2, contacts__cohesion_mpa=0.8,
    measurement__samples=50, output__frames=3)


class Threads(support.CommandLineTest):
    def test_one_two_four_and_eight_threads_give_the_same_bytes(self):
        folders = {n: SCRATCH / f"threads_{n}" for n in (1, 2, 4, 8)}
        for threads, folder in folders.items():
            self.succeed("run", CONFIG, *SHORT, "--threads", threads, "--no-render", "--quiet", "--out", folder)
            self.assertIn(f'"threads": {threads}', (folder / "manifest.json").read_text())
        one = folders[1]
        series = [p.relative_to(one) for p in sorted(one.glob("*/*.vtu"))]
        self.assertGreaterEqual(len(series), 6)
        for threads in (2, 4, 8):
            self.assert_same_bytes(one, folders[threads], ["curves.csv", "energy.csv", "cracks.csv", "events.csv", *series])
        self.assertGreater(len((one / "cracks.csv").read_text().splitlines()), 10)  # a comparison without cracks shows little


if __name__ == "__main__":
    support.main()
