"""Results in frequency: complex moduli, their errors, and what was measured."""

import csv
import pickle
import xml.etree.ElementTree as ET

import numpy as np
import pytest

import breccia
from conftest import MODEL, OVERRIDES


def maxwell_study(tmp_path):
    """A homogeneous box of one Maxwell element and the same element as measured in kHz, 2 MPa and 0.1 s."""
    omega = 2 * np.pi * 10 ** (np.arange(-3, 7) / 3)
    x = 0.1 * omega
    rows = [f"{w / (2e3 * np.pi)!r},{2e6 * y**2 / (1 + y**2)!r},{1 / y!r}" for w, y in zip(omega.tolist(), x.tolist())]
    (tmp_path / "dma.csv").write_text("frequency_kHz,shear_storage_modulus_Pa,tan_delta\n" + "\n".join(rows))
    binder = breccia.Material("binder", density="1 g/cm^3", bulk="3 GPa",
                              shear=breccia.PronySeries([(0.1, 2e6)]))
    return breccia.Study([breccia.Stage("box", matrix=binder, box="6 mm", cells=4)],
                         breccia.Tests(frequencies=("0.1 Hz", "100 Hz"), loads=["isotropic", "bulk"],
                                       boundaries="periodic", fields="none"),
                         measurements=breccia.Measurement("DMA", shear={"measured": str(tmp_path / "dma.csv")}))


def test_a_measured_youngs_modulus_stands_beside_that_of_the_stage():
    times, shear = np.array([0.01, 0.1, 1.0]), 2e6
    binder = breccia.Material("binder", density=1000, bulk="3 GPa", shear=breccia.PronySeries([(0.1, shear)]))
    box = breccia.Stage("box", matrix=binder, box="6 mm", cells=4)
    tests = breccia.Tests(times=("10 ms", "1 s"), loads=["shear"], boundaries="periodic")
    tension = breccia.Measurement("tension", young=(times, 3 * shear * np.exp(-times / 0.1)))
    [comparison] = breccia.solve(breccia.Study(box, tests, measurements=tension))["box"].comparisons
    assert comparison["kind"] == "young"
    # Nearly incompressible, K = 1500 G: E is 3 G but for some thousandths.
    [first, *_, last] = comparison["modulus"] / (3 * shear * np.exp(-comparison["time"] / 0.1))
    assert [first, last] == pytest.approx([1.0, 1.0], rel=3e-3)
    with pytest.raises(breccia.InputError, match="exactly one of shear, young, bulk"):
        breccia.Study(box, tests, measurements=breccia.Measurement("none"))


def test_the_thermal_expansion_of_a_composite():
    resin = breccia.Material("resin", density=1200, bulk="4 GPa", shear="1 GPa", thermal_expansion="60e-6 /K")
    glass = breccia.Material("glass", density=2500, bulk="40 GPa", shear="30 GPa", thermal_expansion=8e-6)
    beads = breccia.Stage("A", matrix=resin, box="1 mm", cells=6, fillers=breccia.Filler(glass, diameter="0.8 mm"),
                          packing=breccia.Packing("regular", lattice="sc"))
    stage = breccia.solve(breccia.Study([beads], {"times": (1.0, 10.0), "loads": ["bulk"]}, dimensions=3))["A"]
    [found] = stage.expansions
    bulk = stage.test("bulk").modulus
    weight = (1 / bulk - 1 / 4e9) / (1 / 40e9 - 1 / 4e9)
    assert found["expansion"] == pytest.approx(60e-6 + weight * (8e-6 - 60e-6), rel=1e-9)
    assert len(found["error"]) == len(found["time"]) == len(bulk)


def test_the_whole_stiffness_of_a_composite(tmp_path):
    resin = breccia.Material("resin", density=1200, bulk="4 GPa", shear=breccia.PronySeries([(1.0, 1e9)], 1e8))
    box = breccia.Stage("A", matrix=resin, box="1 mm", cells=4)
    tests = breccia.Tests(times=("1 s", "10 s"), loads="stiffness", boundaries="periodic", fields="none")
    for dimensions, normal in ((2, [0, 1]), (3, [0, 1, 2])):
        study = breccia.Study([box], tests, dimensions=dimensions)
        computed = breccia.run(study, tmp_path / str(dimensions))["A"]
        for stage in (computed, breccia.read_results(tmp_path / str(dimensions))["A"]):
            [found] = stage.stiffness
            shear = 1e8 + 1e9 * np.exp(-found["time"])
            expected = np.zeros_like(found["stiffness"])
            expected[:, : len(normal), : len(normal)] = (4e9 - 2 / 3 * shear)[:, None, None]
            for i in range(expected.shape[1]):
                expected[:, i, i] += shear * (2 if i in normal else 1)
            assert found["stiffness"] == pytest.approx(expected, rel=1e-7, abs=10.0)
            assert found["bulk"] == pytest.approx(4e9, rel=1e-7) and found["shear"] == pytest.approx(shear, rel=1e-7)
            assert found["anisotropy"] == pytest.approx(0.0, abs=1e-6)
    assert breccia.solve(breccia.Study([box], {"times": (1.0, 10.0)}))["A"].stiffness == []


def test_complex_moduli_at_the_frequencies_of_the_deck(tmp_path):
    study = maxwell_study(tmp_path)
    result = breccia.run(study, tmp_path / "run")
    test = result["box"].test()
    moduli = test.in_frequency
    assert moduli.is_of_deck and len(moduli) == 61
    assert moduli.frequency[[0, 20, 60]] == pytest.approx([0.1, 1.0, 100.0], rel=1e-12)
    exact = 2e6 * (0.1j * moduli.angular_frequency) / (1 + 0.1j * moduli.angular_frequency)
    assert moduli.storage == pytest.approx(exact.real, rel=1e-6)
    assert moduli.loss == pytest.approx(exact.imag, rel=1e-6)
    assert moduli.absolute == pytest.approx(abs(exact), rel=1e-6)
    assert moduli.phase == pytest.approx(np.degrees(np.angle(exact)), rel=1e-6)
    assert moduli.loss_tangent == pytest.approx(exact.imag / exact.real, rel=1e-6)
    nearest = [np.argmin(abs(np.log(test.time * omega))) for omega in moduli.angular_frequency]
    assert np.array_equal(moduli.error, test.error[nearest], equal_nan=True)
    assert moduli.at("1 Hz") == moduli.at("6.283185307179586 rad/s") == test.series.complex_modulus("1 Hz")
    assert moduli.at(2 * np.pi) == pytest.approx(moduli.at("1 Hz"), rel=1e-14), "a number is in rad/s"
    assert moduli.at(moduli.angular_frequency) == pytest.approx(moduli.storage + 1j * moduli.loss)
    for wrong in ("1 s", "1/s", -1.0, 0.0, 1j):
        with pytest.raises(breccia.InputError, match="angular_frequency"):
            moduli.at(wrong)
    with open(tmp_path / "run" / "dynamic.csv") as file:
        rows = [row for row in csv.DictReader(line for line in file if not line.startswith("#"))
                if row["load"] == "isotropic"]
    assert [float(row["loss_modulus_Pa"]) for row in rows] == moduli.loss.tolist()
    stored = breccia.read_results(tmp_path / "run")["box"].test().in_frequency
    copied = pickle.loads(pickle.dumps(result))["box"].test().in_frequency
    for other in (stored, copied, pickle.loads(pickle.dumps(moduli))):
        assert other.is_of_deck and other.storage.tolist() == moduli.storage.tolist()
        assert np.array_equal(other.error, moduli.error, equal_nan=True)
    for shown in (result["box"]._repr_html_(), moduli._repr_html_()):
        assert "<th style=\"text-align:right\">|G*|</th>" in shown and "1 Hz" in shown and "1.06 MPa" in shown
        ET.fromstring(f"<body>{shown}</body>".replace("&nbsp;", " "))


def test_young_modulus_at_one_hertz(tmp_path):
    stage = breccia.solve(maxwell_study(tmp_path))["box"]
    moduli = stage.engineering()
    assert moduli.frequency == pytest.approx(stage.test().in_frequency.frequency)
    shear = 2e6 * (0.2j * np.pi) / (1 + 0.2j * np.pi)
    at = moduli.at("1 Hz")
    assert at.young == pytest.approx(9 * 3e9 * shear / (9e9 + shear), rel=1e-4)
    assert at.shear == pytest.approx(shear, rel=1e-6) and at.poisson.real == pytest.approx(0.4999, abs=1e-3)
    assert moduli.complex_young[20] == pytest.approx(at.young, rel=1e-9)
    assert pickle.loads(pickle.dumps(moduli)).at("1 Hz").young == at.young
    with pytest.raises(breccia.InputError, match="angular_frequency"):
        moduli.at("1 s")


def test_measured_complex_moduli_beside_the_result_and_an_answer(tmp_path):
    result = breccia.solve(maxwell_study(tmp_path))
    [comparison] = result["box"].comparisons
    assert len(comparison["angular_frequency"]) == 10
    assert comparison["complex_modulus"] / comparison["complex_measured"] == pytest.approx(np.ones(10), rel=1e-6)
    softer = breccia.PronySeries([(0.1, 1.95e6)])
    for base in (result, pickle.loads(pickle.dumps(result))):
        answer = breccia.respond(base, softer)["box"]
        [beside] = answer.comparisons
        assert beside["complex_modulus"] / beside["complex_measured"] == pytest.approx(0.975 * np.ones(10), rel=1e-5)
        assert answer.test().in_frequency.is_of_deck
    some = breccia.respond(result, softer, frequencies=("1 Hz", "10 Hz"))["box"].test().in_frequency
    assert some.frequency[[0, -1]] == pytest.approx([1.0, 10.0])
    assert not breccia.respond(result, softer, times=("10 ms", "1 s"))["box"].test().in_frequency.is_of_deck
    with pytest.raises(breccia.InputError, match="times or frequencies, got both"):
        breccia.respond(result, softer, times=("10 ms", "1 s"), frequencies=("1 Hz", "10 Hz"))
    with pytest.raises(breccia.InputError, match="two rising frequencies"):
        breccia.respond(result, softer, frequencies=("10 Hz", "1 Hz"))
    assert not breccia.solve(breccia.read_study(MODEL, OVERRIDES))["model"].test(boundary="traction").in_frequency.is_of_deck
