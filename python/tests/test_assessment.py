"""What the uncertainty of the inputs of a study makes of its results."""

import os
import subprocess

import numpy as np
import pytest

import breccia

TERMS = [(1e-4, 500e6), (1e-3, 300e6), (1e-2, 90e6)]


def study(shear_of_glass=30e9, fraction=0.3, **factors):
    binder = breccia.Material("binder", density=1000, bulk=3e9, shear=breccia.PronySeries(TERMS, 1e6), factors=factors)
    glass = breccia.Material("glass", density=2500, bulk=40e9, shear=shear_of_glass)
    packing = breccia.Packing("lubachevsky-stillinger", seed=1)
    stage = breccia.Stage("discs", matrix=binder, box=10e-3, cells=16, packing=packing,
                          fillers=breccia.Filler(glass, fraction=fraction, sizes={"diameter": 2e-3}))
    return breccia.Study([stage], breccia.Tests(times=("10 us", "1 s"), fields="none", mixing="series"))


def test_carries_materials_through_in_one_box():
    found = breccia.assess(study({"value": 30e9, "sd": 3e9}, times={"value": 1, "factor": 2}), samples=300)
    assert found.inputs == ["materials.binder.factors.times", "materials.glass.shear"]
    assert (found.samples, found.boxes) == (300, 1)
    curve = found["G"]
    assert np.all(curve.inputs[0] < curve.median) and np.all(curve.median < curve.inputs[1])
    alone = sum(curve.alone.values())
    assert np.all(alone <= 1 + 1e-9) and np.all(alone > 0.9)
    middle = len(curve.at) // 2
    assert curve.alone["materials.binder.factors.times"][middle] > 0.9, "the binder relaxes"
    assert np.allclose(curve.reference, found.reference["discs"].curve()[1])
    assert "materials.glass.shear"[len("materials."):] in found._repr_html_()


def test_agrees_with_the_command_line(tmp_path):
    deck = tmp_path / "deck.toml"
    deck.write_text(study({"value": 30e9, "sd": 3e9}).deck)
    own = breccia.assess(breccia.read_study(deck, {"stages.0.cells": 12}), samples=200)
    subprocess.run([os.environ["BRECCIA_COMMAND"], "assess", deck, "--set", "stages.0.cells=12", "--samples", "200", "--out",
                    tmp_path / "out", "--quiet"], check=True)
    lines = (tmp_path / "out" / "assess" / "bands.csv").read_text().splitlines()[2:]
    lower = np.array([float(line.split(",")[5]) for line in lines])
    assert np.allclose(own["G"].inputs[0], lower, rtol=1e-12)


def test_numbers_without_units_may_be_distributions():
    found = breccia.assess(study(fraction={"from": 0.28, "to": 0.32}), boxes=3)
    assert found.inputs == ["stages.discs.filler.fraction"]


def test_overrides_of_factors_have_no_unit(tmp_path):
    deck = tmp_path / "deck.toml"
    deck.write_text(study(times=2.0).deck)
    changed = breccia.read_study(deck, {"materials.binder.factors.times": 3.0})
    assert changed.materials[0].shear.terms[0][0] == pytest.approx(3.0 * 1e-2)


def test_solves_boxes():
    found = breccia.assess(study(fraction={"value": 0.3, "sd": 0.04}), boxes=8)
    assert found.boxes == 8 and found.samples == 8
    shares = found["G"].alone["stages.discs.filler.fraction"]
    assert shares[-1] == pytest.approx(1.0), "the only input causes all of the variance"


def test_finds_inputs_from_measurements(tmp_path):
    truth = breccia.solve(study(33e9, times=1.5))["discs"]
    time, modulus = truth.curve()
    path = tmp_path / "g.csv"
    path.write_text("time_s,shear_modulus_Pa\n" + "".join(f"{t},{g}\n" for t, g in zip(time[::5], modulus[::5])))
    found = breccia.assess(study({"value": 30e9, "sd": 3e9}, times={"value": 1, "factor": 2}), measured=path, noise=0.01,
                           model_error=0.01).calibration
    times = found["materials.binder.factors.times"]
    assert times.interval[0] < 1.5 < times.interval[1]
    assert times.learned > 0.9
    assert len(found.predictions["measured"]) == len(time[::5])
    with pytest.raises(breccia.FileError, match="cannot read"):
        breccia.assess(study({"value": 30e9, "sd": 3e9}), measured=tmp_path / "none.csv")
    with pytest.raises(breccia.InputError, match="noise: expected a share"):
        breccia.assess(study({"value": 30e9, "sd": 3e9}), measured=path, noise=2.0)


@pytest.mark.parametrize("shear, keys, message", [
    (30e9, {}, "every input is certain"),
    ({"value": 30e9, "sd": 20e9}, {}, "expected less than a quarter"),
    ({"value": 30e9, "sd": "3 mm"}, {}, 'expected a pressure, got "3 mm"'),
    ({"value": 30e9, "factor": 0.5}, {}, "expected a factor above 1, got 0.5"),
    ({"value": 30e9, "sd": 3e9}, {"samples": 10}, "samples: expected 100 or more, got 10"),
    ({"value": 30e9, "sd": 3e9}, {"boxes": 1}, "boxes: expected 2 or more"),
    ({"value": 30e9, "sd": 3e9}, {"stage": "disks"}, 'no stage "disks", did you mean "discs"?'),
])
def test_refuses_mistakes(shear, keys, message):
    with pytest.raises(breccia.InputError, match=message.replace("?", r"\?")):
        breccia.assess(study(shear), **keys)


def test_takes_studies_alone():
    with pytest.raises(breccia.InputError, match="expected a Study"):
        breccia.assess("deck.toml")


def test_finds_an_input_as_the_command_does(tmp_path):
    sought = study(fraction={"from": 0.25, "to": 0.4})
    found = breccia.find(sought, "fraction", "G(1 ms) = 350 MPa", boxes=5, model_error=0.02)
    assert found.inputs[0] == pytest.approx(0.25, rel=1e-3) and found.inputs[-1] == pytest.approx(0.4, rel=1e-3)
    assert np.all(found.band[0] < found.values) and np.all(found.values < found.band[1])
    assert np.interp(found.value, found.inputs, found.values) == pytest.approx(350e6, rel=2e-3)
    assert found.reached == pytest.approx(350e6, rel=0.1)
    assert found.interval[0] < found.value < found.interval[1]
    assert found.text in found._repr_html_() and found.text in repr(found)
    deck = tmp_path / "deck.toml"
    deck.write_text(sought.deck)
    printed = subprocess.run([os.environ["BRECCIA_COMMAND"], "find", "fraction", deck, "--so-that", "G(1 ms) = 350 MPa",
                              "--boxes", "5", "--model-error", "2 %", "--out", tmp_path / "out"], check=True,
                             capture_output=True, text=True).stdout
    assert f"stages.discs.filler.fraction  {found.text}  (95 %" in printed


def test_find_says_what_can_be_had():
    sought = study(times={"from": 0.5, "to": 2.0})
    with pytest.raises(breccia.InputError, match="no materials.binder.factors.times from 0.5 to 2 makes"):
        breccia.find(sought, "times", "G(1 ms) = 350 GPa")
    with pytest.raises(breccia.InputError, match="so_that: expected a text"):
        breccia.find(sought, "times", 350e6)
    with pytest.raises(breccia.InputError, match="model_error"):
        breccia.find(sought, "times", "G(1 ms) = 350 MPa", model_error=2.0)
