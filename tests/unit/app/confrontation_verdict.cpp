#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "app/confrontation/condition_tables.hpp"
#include "app/confrontation/confrontation_chapters.hpp"
#include "app/confrontation/confrontation_pictures.hpp"

using namespace asperity;
using namespace asperity::app;
using Json = nlohmann::ordered_json;

namespace {

/// A verdict on two features of one test with two candidates.
struct Documents {
  Json verdict = Json::parse(R"({"status": "named", "causes": ["platen_friction"],
    "candidates": [{"id": "platen_friction", "amplitude": 0.8, "amplitude_error": 0.1, "misfit": 1.5, "kept": true,
                    "p_misfit": 0.4, "p_excess": 1, "explained": 40, "absorbed_share": 0.2, "suspect": false},
                   {"id": "mesh_size", "amplitude": 0.5, "amplitude_error": 0.1, "misfit": 30, "kept": false,
                    "p_misfit": 0.002, "p_excess": 0.003, "explained": 12, "absorbed_share": 0.7, "suspect": true}],
    "gate": {"discrepancy": true, "misfit": 41.5, "p_misfit": 1e-7, "p_explained": 0.002, "alarms": []},
    "parameters": [{"name": "c_c", "label": "cohesion", "unit": "MPa", "value": 2.1, "error": 0.04,
                    "determined": true, "at_limit": false}],
    "wrong": [], "left_out": [], "notes": [], "next_tests": [],
    "gain": {"causes": [], "elpd_change": null, "claimed": false}})");
  Json shown = Json::parse(R"({"setting": {"name": "case"}, "extension": ["platen_friction"],
    "tests": [{"id": "U", "experiment": "uniaxial", "use": "fit"},
              {"id": "T1", "experiment": "triaxial", "use": "fit", "confining_pressure_mpa": 1,
               "features": {"peak_axial_stress_mpa": [8.1, null]},
               "base": [{"seed": 1, "path": [0, 0.01], "load": [1, 8], "features": {"peak_axial_stress_mpa": 8}}]},
              {"id": "T3", "experiment": "triaxial", "use": "hold_out", "confining_pressure_mpa": 3,
               "features": {"peak_axial_stress_mpa": [14]}}],
    "slots": [{"test": "U", "feature": "peak_axial_stress_mpa", "projected": 3, "z_base": 5, "z_extension": 0.5},
              {"test": "U", "feature": "drop_share", "projected": -4, "z_base": -4, "z_extension": -0.2}],
    "candidates": [{"id": "platen_friction", "suspect": false, "most": 3, "explained": 40, "absorbed_share": 0.2,
                    "detectable": 0.3, "projected": [3, -4]},
                   {"id": "mesh_size", "suspect": true, "two_sided": true, "most": 1, "explained": 12,
                    "absorbed_share": 0.7, "detectable": null, "projected": [-4, -3]}],
    "seconds": []})");
  Json manifest = Json::object();

  ConfrontationData data() const {
    return confrontation_data(".", {&verdict, "verdict: "}, {&shown, "shown: "}, {&manifest, "manifest: "});
  }

  std::string sentences() const {
    std::string all;
    for (const std::string& sentence : verdict_sentences(data())) all += sentence + "\n";
    return all;
  }
};

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("a named cause is told with its own parameter") {
  const std::string text = Documents().sentences();
  CHECK(contains(text, "wrong beyond scatter"));
  CHECK(contains(text, "One mechanism"));
  CHECK(contains(text, "(platen_friction), friction coefficient 0.240 ± 0.030"));
  const std::vector<Note> notes = verdict_alarms(Documents().data());
  REQUIRE(notes.size() == 1);
  CHECK(contains(notes[0].text, "No feature of T1 could be compared"));
}

TEST_CASE("every status has words of its own") {
  Documents d;
  d.verdict["status"] = "nothing_found";
  CHECK(contains(d.sentences(), "Nothing found"));
  d.verdict["status"] = "unexplained";
  CHECK(contains(d.sentences(), "Unexplained"));
  d.verdict["status"] = "indistinguishable";
  d.verdict["causes"] = {"mesh_size", "platen_friction"};
  CHECK(contains(d.sentences(), "2 mechanisms explain it"));
  d.verdict["status"] = "two_causes";
  d.verdict["pairs"] = Json::parse(R"([{"ids": ["mesh_size", "platen_friction"], "amplitudes": [0.5, 0.5],
                                        "amplitude_errors": [0.1, 0.1], "kept": true}])");
  CHECK(contains(d.sentences(), "these two together do"));
  CHECK(contains(d.sentences(), "friction coefficient 0.150 ± 0.030"));
}

TEST_CASE("alarms, suspects of the solver, limits and strengths at an end stand before everything") {
  Documents d;
  d.verdict["gate"]["alarms"] = {"the data agree with the simulation better than scatter allows"};
  d.verdict["causes"] = {"mesh_size", "platen_friction"};
  d.verdict["parameters"][0]["at_limit"] = true;
  d.verdict["candidates"][0]["amplitude"] = d.shown["candidates"][0]["most"];
  const std::vector<Note> notes = verdict_alarms(d.data());
  REQUIRE(notes.size() == 5);
  CHECK(contains(notes[0].text, "Alarm: the data agree"));
  CHECK(contains(notes[1].text, "(mesh_size)"));
  CHECK(contains(notes[3].text, "limit of what is allowed for cohesion"));
  CHECK(contains(notes[3].text, "as far as 5 standard deviations"));
  CHECK(contains(notes[3].text, "a mechanism may be named for it. Give it more room"));
  CHECK(contains(notes[4].text, "3 of the declared strong one"));
  d.shown["candidates"][0]["whole"] = true;
  CHECK(verdict_alarms(d.data()).size() == 4);
  d.shown["setting"]["linearised_at"] = "reference";
  CHECK(contains(verdict_alarms(d.data())[3].text, "within four steps"));
}

TEST_CASE("a cause whose runs end before their peak is warned of") {
  Documents d;
  d.verdict["short_runs"] = Json::parse(R"([{"causes": ["platen_friction"], "test": "U",
    "feature": "peak_axial_stress_mpa", "base": 6, "extension": 1, "meshes": 6}])");
  const std::vector<Note> notes = verdict_alarms(d.data());
  REQUIRE(notes.size() == 2);
  CHECK(contains(notes[1].text,
                 "With platen_friction fewer runs pass a peak than with the base: "
                 "U (peak axial stress: 1 of 6 runs, of the base's 6)"));
}

TEST_CASE("base runs that are not quasi-static are warned of, test by test") {
  Documents d;
  Json& runs = d.shown["tests"][1]["base"];
  runs.push_back(runs[0]);
  runs[0]["kinetic_over_stored"] = 0.019;
  CHECK(verdict_alarms(d.data()).size() == 1);
  runs[1]["kinetic_over_stored"] = 0.0467;
  const std::vector<Note> notes = verdict_alarms(d.data());
  REQUIRE(notes.size() == 2);
  CHECK(contains(notes[1].text, "exceeded 0.02 of the stored energy in T1 (up to 0.047 in 1 of 2 runs)"));
}

TEST_CASE("a gain is claimed, left open, or refutes the extension") {
  Documents d;
  const auto told = [&](double low, double high) {
    d.verdict["gain"] = {{"causes", {"platen_friction"}},
                         {"elpd_change", 0.5 * (low + high)},
                         {"elpd_interval_90", {low, high}},
                         {"claimed", low > 0.0},
                         {"rms_z_before", 1.5},
                         {"rms_z_after", 1.2}};
    return markdown_of(verdict_chapter(d.data())) + markdown_of(gain_chapter(d.data()));
  };
  CHECK(contains(told(1.0, 3.0), "predicts the tests that were kept back better"));
  const std::string open = told(-1.0, 3.0), refuted = told(-8.0, -0.2);
  CHECK(contains(open, "No gain on the tests that were kept back is claimed"));
  CHECK(!contains(open, "refute the model"));
  CHECK(!contains(open, "refute this extension"));
  CHECK(contains(refuted, "The tests that were kept back refute the model extended by"));
  CHECK(contains(refuted, "The whole interval lies below zero: the kept-back tests refute this extension"));
}

TEST_CASE("the page says how far the search went") {
  Documents d;
  CHECK(contains(d.sentences(), "All 2 candidates were refitted; 1 would not be seen in these data"));
  d.verdict["candidates"].erase(1);
  CHECK(contains(d.sentences(), "Of 2 candidates the one that explains most was refitted"));
  d.verdict["candidates"][0]["converged"] = false;
  ConfrontationData data = d.data();
  data.folder = std::filesystem::path(ASPERITY_TEST_SCRATCH) / "confrontation_page";
  CHECK(contains(markdown_of(cause_chapter(data)), "the refit did not converge"));
}

TEST_CASE("tests' conditions and their instruments' errors stand on the page, those that are alike in one row") {
  Documents d;
  const Json instrument = {{"load_noise_percent", 0.5},         {"displacement_noise_percent", 0.1},
                           {"transverse_noise_percent", 0.5},   {"load_scale_percent", 1.0},
                           {"displacement_scale_percent", 1.0}, {"load_zero_percent", 0.2},
                           {"displacement_zero_mm", 0.02}};
  for (Json& test : d.shown["tests"]) {
    test["instrument"] = instrument;
    test["instrument_by_default"] = true;
    test["specimens"] = 3;
    test["conditions"] = {{"size_mm", {50, 100}},
                          {"edge_mm", 4},
                          {"plane", "strain"},
                          {"rate_mm_per_s", 400},
                          {"laboratory_rate_mm_per_s", nullptr}};
  }
  d.shown["tests"][2]["instrument"]["load_scale_percent"] = 3.0;
  d.shown["tests"][2]["instrument_by_default"] = false;
  const std::string text = markdown_of(assumptions_chapter(d.data()));
  CHECK(contains(text, "| T1 | triaxial | 3 | 50 × 100 | σ₃ = 1 | not given | 400 | 4 | strain |"));
  CHECK(contains(text, "| U, T1 | 0.5 | 0.1 | 0.5 | 1 | 1 | 0.2 | 0.02 | the defaults |"));
  CHECK(contains(text, "| T3 | 0.5 | 0.1 | 0.5 | 3 | 1 | 0.2 | 0.02 | given; those left out by default |"));
}

TEST_CASE("compared features are explained once") {
  const std::string text = markdown_of(Block(features_table(Documents().data())));
  CHECK(contains(text, "| drop share | share of the peak lost"));
  CHECK(contains(text, "| peak axial stress | largest axial stress, total |"));
}

TEST_CASE("an extension's runs that are too fast raise an alarm of their own") {
  Documents d;
  d.shown["tests"][1]["extension"] = d.shown["tests"][1]["base"];
  d.shown["tests"][1]["extension"][0]["kinetic_over_stored"] = 0.05;
  bool told = false;
  for (const Note& note : verdict_alarms(d.data())) told |= contains(note.text, "of the extension's runs");
  CHECK(told);
}

TEST_CASE("what data could not have shown is told of every candidate") {
  const std::string text = markdown_of(limits_chapter(Documents().data()));
  CHECK(contains(text, "friction coefficient 0.09"));
  CHECK(contains(text, "not visible at any strength"));
}

TEST_CASE("a fingerprint is drawn at the strength that explains most, and not below zero") {
  Documents d;
  CHECK(explaining_amplitude(d.data(), d.data().candidates[0]) == Approx(1.0));
  CHECK(explaining_amplitude(d.data(), d.data().candidates[1]) == Approx(0.0).margin(1e-12));
  const render::BarPanels bars = fingerprint_bars(d.data());
  REQUIRE(bars.panels.size() == 3);
  CHECK(bars.panels[1].heading == "platen_friction");
  CHECK(bars.panels[1].values == std::vector<double>{3, -4});
  d.shown["candidates"][0]["projected"] = {-3, 4};
  CHECK(explaining_amplitude(d.data(), d.data().candidates[0]) == 0.0);
  d.shown["candidates"][0]["two_sided"] = true;
  CHECK(explaining_amplitude(d.data(), d.data().candidates[0]) == Approx(-1.0));
}

TEST_CASE("cosines between fingerprints are those of the projected vectors") {
  const auto matrix = cosine_picture(Documents().data());
  REQUIRE(matrix.has_value());
  CHECK(matrix->values[0][0] == Approx(1.0));
  CHECK(matrix->values[0][1] == Approx(0.0).margin(1e-12));
  CHECK(cosine({1, 0}, {0, 0}) != cosine({1, 0}, {0, 0}));  // NaN
}

TEST_CASE("strengths are drawn over confining pressure, kept-back ones apart") {
  const auto figure = strength_figure(Documents().data());
  REQUIRE(figure.has_value());
  std::vector<std::string> labels;
  for (const render::Layer& layer : figure->charts.front().layers) {
    if (const auto* points = std::get_if<render::PointLayer>(&layer)) labels.push_back(points->label);
  }
  CHECK(labels == std::vector<std::string>{"measured, fitted", "measured, kept back"});
  CHECK_FALSE(joint_strength_figure(Documents().data()).has_value());
}

TEST_CASE("a fingerprint of another length than the slots is refused") {
  Documents d;
  d.shown["candidates"][0]["projected"] = {1};
  CHECK_THROWS_WITH(d.data(), Catch::Contains("platen_friction") && Catch::Contains("slots"));
}
