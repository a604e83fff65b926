"""Unknown numbers of materials from measurements of composites."""

import numpy as np
import pytest

import breccia

DECK = """
[materials.binder]
density = "1 g/cm^3"
bulk    = "3 GPa"
shear   = { equilibrium = "1 MPa", terms = [
  { time = "100 us", modulus = "500 MPa" }, { time = "1 ms", modulus = "300 MPa" }, { time = "10 ms", modulus = "90 MPa" }] }

[materials.glass]
density = "2.5 g/cm^3"
bulk    = "40 GPa"
shear   = "30 GPa"

[[stages]]
name    = "discs"
matrix  = "binder"
box     = "6 mm"
cells   = 12
filler  = { material = "glass", sizes = { diameter = "2 mm" } }
packing = { method = "regular", columns = 2, rows = 2 }

[tests]
loads      = ["shear"]
times      = ["10 us", "1 s"]
boundaries = ["displacement"]

[tests.quasistatic]
vary = { glass = { shear = ["1 GPa", "60 GPa"] } }
"""


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    path = tmp_path_factory.mktemp("calibration") / "deck.toml"
    path.write_text(DECK)
    return breccia.solve(breccia.read_study(path))


@pytest.fixture(scope="module")
def measured(result, tmp_path_factory):
    """G(t) of the composite with a binder that is three times slower."""
    binder = result["discs"].tests[0]
    slow = breccia.PronySeries([(3e-4, 500e6), (3e-3, 300e6), (3e-2, 90e6)], 1e6)
    time, modulus = breccia.respond(result, slow)["discs"].curve(load="shear", boundary="displacement")
    assert binder is not None
    path = tmp_path_factory.mktemp("measured") / "g.csv"
    rows = "".join(f"{t},{g}\n" for t, g in zip(time[::5], modulus[::5]))
    path.write_text("time_s,shear_modulus_Pa\n" + rows)
    return path


def test_finds_the_factor_of_times(result, measured):
    found = breccia.calibrate(result, measured, "binder.times")
    estimate = found["binder.times"]
    assert estimate.value == pytest.approx(3.0, rel=1e-3)
    assert estimate.interval[0] < estimate.value < estimate.interval[1]
    assert estimate.before[0] < 0.1 and estimate.before[1] > 10.0
    assert estimate.learned > 0.99
    assert found.correlation.shape == (1, 1)
    assert np.allclose(found.predictions["predicted"], found.predictions["measured"], rtol=1e-3)
    assert any("state the error of the model" in warning for warning in found.warnings)
    assert any("noise of the data" in remark for remark in found.remarks)
    assert "binder.times" in found._repr_html_()


def test_found_materials_go_to_respond(result, measured):
    found = breccia.calibrate(result, measured, ["binder.times"])
    time, modulus = breccia.respond(result, materials=found.materials)["discs"].curve(load="shear", boundary="displacement")
    at = np.interp(np.log(found.predictions["at"]), np.log(time), modulus)
    assert np.allclose(at, found.predictions["measured"], rtol=1e-3)


def test_takes_priors_and_several_results(result, measured):
    unknowns = {"binder.times": "{ value = 2, factor = 3 }", "glass.shear": None}
    found = breccia.calibrate({"one": result, "two": result}, {"one": measured, "two": [measured]}, unknowns,
                              noise=0.02, model_error=0.05)
    assert found.noise == pytest.approx(0.02)
    assert {"model of one", "model of two"} < set(found.estimates)
    assert set(found.predictions["composite"]) == {"one", "two"}
    assert not any("error of the model" in warning for warning in found.warnings)
    assert any("tested under displacement alone" in warning for warning in found.warnings)


def test_draws_samples(result, measured):
    found = breccia.calibrate(result, measured, "binder.times", noise=0.02, samples=400)
    assert np.isnan(found.independent_samples)  # twenty steps of each walker do not tell
    assert found["binder.times"].interval[0] < 3.0 < found["binder.times"].interval[1]


@pytest.mark.parametrize("arguments, options, message", [
    (("g.csv", "binder.tims"), {}, 'binder has no "tims" that could be unknown, did you mean "times"?'),
    (("g.csv", "binder.times"), {"noise": 2.0}, "noise: expected a share between 0 and 1, got 2.0"),
    (("g.csv", "binder.times"), {"modulus": "sheer"}, 'modulus: expected "shear", "young" or "bulk"'),
    (({"other": "g.csv"}, "binder.times"), {}, "measured: no results are called 'other'; there are composite"),
    (("g.csv", "binder.times"), {"stage": "disks"}, 'no response of a stage "disks"'),
])
def test_mistakes_are_refused(result, measured, arguments, options, message):
    files, unknowns = arguments
    files = {name: measured for name in files} if isinstance(files, dict) else measured
    with pytest.raises(breccia.InputError, match=message.replace("?", r"\?")):
        breccia.calibrate(result, files, unknowns, **options)


def test_several_results_need_names(result, measured):
    with pytest.raises(breccia.InputError, match="expected files by the names of the results, one, two"):
        breccia.calibrate({"one": result, "two": result}, measured, "binder.times")
