"""Material cards and isochrones: those of the command line, which its tests read back, and against the results."""

import pickle

import numpy as np
import pytest

import breccia

LAW = {"law": "wlf", "c1": 6.5, "c2": "120 K", "reference": "20 degC", "temperature": "20 degC"}
FORMATS = ["abaqus", "ansys", "ls-dyna", "openradioss", "comsol", "moose", "csv"]


@pytest.fixture(scope="module")
def directory(tmp_path_factory):
    return tmp_path_factory.mktemp("results") / "run"


@pytest.fixture(scope="module")
def result(directory):
    """A composite that was tested in shear and in bulk, in the memory and in a directory."""
    binder = breccia.Material("binder", density="1.0 g/cm^3", bulk="3 GPa", temperature_shift=LAW,
                              shear=breccia.PronySeries([(1e-4, 80e6), (1e-2, 10e6), (1.0, 2e6)], 1e6))
    particle = breccia.Material("particle", density="2 g/cm^3", bulk="40 GPa", shear="30 GPa")
    stage = breccia.Stage("composite", matrix=binder, box="6 mm", cells=12,
                          fillers=breccia.Filler(particle, diameter="2 mm"),
                          packing=breccia.Packing("regular", columns=2, rows=2))
    tests = breccia.Tests(times=("10 us", "10 s"), loads=["shear", "bulk"], fields="none",
                          boundaries=["displacement", "traction"])
    return breccia.run(breccia.Study(stage, tests, title="Composite"), directory)


@pytest.mark.parametrize("format", FORMATS)
def test_cards_are_those_of_the_command_line(result, directory, command, format):
    printed = command("export", directory, "--format", format, "--boundary", "traction", "--bulk", "5 GPa",
                      "--units", "mm-t-s", "--tolerance", "2 %")
    assert printed.returncode == 0, printed.stderr
    for results in (result, breccia.read_results(directory)):
        card = breccia.export(results, format, boundary="traction", bulk="5 GPa", units="mm-t-s", tolerance=0.02)
        assert card == printed.stdout
        assert card == breccia.export(results, format, boundary="traction", bulk=5e9, units="mm-t-s", tolerance="2 %")


def test_a_table_follows_the_results_within_its_tolerance(result, tmp_path):
    file = tmp_path / "card.csv"
    text = breccia.export(result, "csv", file, boundary="displacement", poisson=0.4, tolerance=0.005)
    assert file.read_text() == text
    rows = np.array([[float(cell) for cell in line.split(",")[:2]] for line in text.splitlines()
                     if not line.startswith("#") and line[0] in "0123456789i"])
    finite = np.isfinite(rows[:, 0])
    series = breccia.PronySeries(rows[finite], equilibrium=float(rows[~finite, 1][0]))
    time, modulus = result["composite"].curve(boundary="displacement")
    assert series.at(time) == pytest.approx(modulus, rel=0.0051)
    again = breccia.Material("composite", density=1.0, bulk="1 GPa", shear={"prony": str(file)}).solid()
    assert again.shear == series


def test_isochrones_are_those_of_the_command_line(result, directory, command):
    asked = dict(boundary="traction", frequency="10 Hz", temperatures=("10 degC", "30 degC"), step="5 K")
    printed = command("export", directory, "--format", "dma", "--boundary", "traction", "--frequency", "10 Hz",
                      "--temperatures", "10 degC", "30 degC", "--step", "5 K")
    assert printed.returncode == 0, printed.stderr
    assert breccia.export(result, "dma", **asked) == printed.stdout
    isochrone = breccia.isochrone(result, "10 Hz", temperatures=("10 degC", "30 degC"), step="5 K", boundary="traction")
    assert isochrone.temperature == pytest.approx(273.15 + np.arange(10.0, 31.0, 5.0))
    factor = 10.0 ** isochrone.log10_shift_factor
    series = result["composite"].prony(boundary="traction")
    assert isochrone.shear == pytest.approx(series.complex_modulus(2 * np.pi * 10.0 * factor), rel=1e-12)
    assert isochrone.young.shape == isochrone.poisson.shape == (5,)
    assert repr(isochrone) == "<breccia.Isochrone: 10 Hz, 5 temperatures from 10 to 30 degC>"
    assert isochrone._repr_html_().count("<svg") == 2


@pytest.mark.parametrize("shift", [
    {"law": "arrhenius", "activation_energy": "120 kJ/mol"}, {"law": "table", "table": "shifts.csv"}])
def test_isochrones_by_other_laws_outlive_a_pickle(shift, tmp_path):
    """At 1 / (2 pi 10 ms) and the reference, that is, at the only relaxation time, the loss factor of a box of binder
    alone is 1 / 2 x 0.5 / (1 + 1 / 2 x 0.5), and the shift factors are those of the law."""
    (tmp_path / "shifts.csv").write_text("temperature_degC,shift_factor\n0,100\n20,1\n40,0.1\n")
    if "table" in shift:
        shift = {**shift, "table": str(tmp_path / "shifts.csv")}
    binder = breccia.Material("binder", density="1 g/cm^3", bulk="3 GPa", shear=breccia.PronySeries([(1e-2, 5e5)], 1e6),
                              temperature_shift={**shift, "reference": "20 degC", "temperature": "20 degC"})
    frequency = 1.0 / (2.0 * np.pi * 1e-2)
    tests = breccia.Tests(frequencies=(frequency / 1e3, "10 kHz"), boundaries="periodic", fields="none")
    study = breccia.Study(breccia.Stage("box", matrix=binder, box="1 mm", cells=4), tests)
    result = pickle.loads(pickle.dumps(breccia.solve(study)))
    curve = breccia.isochrone(result, frequency, temperatures=("10 degC", "30 degC"), step="10 degC")
    expected = [10.0, 1.0, 10**-0.5] if "table" in shift else [
        np.exp(120e3 / 8.314462618 * (1.0 / temperature - 1.0 / 293.15)) for temperature in (283.15, 293.15, 303.15)]
    assert np.allclose(10.0 ** curve.log10_shift_factor, expected, rtol=1e-8)
    assert curve.shear[1].imag / curve.shear[1].real == pytest.approx(0.25 / 1.25, rel=1e-4)


def test_exports_follow_the_temperature_of_a_response(result):
    warm = breccia.respond(result, temperature="30 degC")
    there = breccia.isochrone(warm, "1 Hz", temperatures=("20 degC", "30 degC"), step=10.0, boundary="traction")
    here = breccia.isochrone(result, "1 Hz", temperatures=("20 degC", "30 degC"), step=10.0, boundary="traction")
    assert there.log10_shift_factor[1] == pytest.approx(0.0, abs=1e-12)
    assert there.shear == pytest.approx(here.shear, rel=1e-3)
    other = breccia.respond(result, breccia.PronySeries([(1e-2, 10e6)], 2e6))
    with pytest.raises(breccia.InputError, match="shift"):
        breccia.isochrone(other, boundary="traction")


def test_exports_follow_the_shift_of_a_new_binder(result):
    """A response to the binder of the study, at another temperature in its own table, is that to the temperature."""
    own = dict(density="1.0 g/cm^3", bulk="3 GPa", shear=breccia.PronySeries([(1e-4, 80e6), (1e-2, 10e6), (1.0, 2e6)], 1e6))
    binder = breccia.Material("other", **own, temperature_shift={**LAW, "temperature": "30 degC"})
    other, warm = breccia.respond(result, binder), breccia.respond(result, temperature="30 degC")
    assert other.binder == warm.binder == result.binder == "binder"
    asked = dict(temperatures=("20 degC", "30 degC"), step=10.0, boundary="traction")
    there, here = breccia.isochrone(other, "1 Hz", **asked), breccia.isochrone(warm, "1 Hz", **asked)
    assert np.array_equal(there.shear, here.shear) and np.array_equal(there.log10_shift_factor, here.log10_shift_factor)
    again = breccia.respond(other, temperature="20 degC")
    back, first = again["composite"].curve(boundary="traction")[1], result["composite"].curve(boundary="traction")[1]
    assert back == pytest.approx(first, rel=1e-9)
    assert breccia.isochrone(again, "1 Hz", **asked).shear == pytest.approx(
        breccia.isochrone(result, "1 Hz", **asked).shear, rel=1e-9)
    # A file has its shift, too, and a response that was pickled answers as well.
    copy = pickle.loads(pickle.dumps(other))
    assert np.array_equal(breccia.isochrone(copy, "1 Hz", **asked).shear, there.shear)
    assert np.array_equal(breccia.respond(copy, temperature="25 degC")["composite"].curve(boundary="traction"),
                          breccia.respond(other, temperature="25 degC")["composite"].curve(boundary="traction"))
    unshifted = breccia.respond(result, breccia.Material("other", **own))
    with pytest.raises(breccia.InputError, match="shift"):
        breccia.isochrone(unshifted, boundary="traction")


def test_all_mistakes_of_an_export_are_named(result, tmp_path):
    taken = tmp_path / "taken"
    taken.write_text("mine")
    with pytest.raises(breccia.InputError) as error:
        breccia.export(result, "abaqus", taken, boundary="traction", frequency="1 Hz")
    assert error.value.mistakes == ["frequency: the format abaqus has none",
                                    f"{taken}: the file exists; replace it (overwrite=True) or choose another name"]
    assert taken.read_text() == "mine"
    for arguments, message in (
            ({"format": "nastran", "boundary": "traction"}, 'format: expected "abaqus" or .*got "nastran"'),
            ({"format": "abaqus"}, "boundary condition"),
            ({"format": "abaqus", "boundary": "periodic"}, "was not tested under the boundary condition periodic"),
            ({"format": "csv", "boundary": "traction", "bulk": "5 m"}, "bulk: expected a pressure"),
            ({"format": "csv", "boundary": "traction", "bulk": 5e9, "poisson": 0.4}, "expected one of them"),
            ({"format": "csv", "boundary": "traction", "bulk": 5e9, "tolerance": 2.0}, "tolerance"),
            ({"format": "csv", "boundary": "traction", "bulk": 5e9, "tolerance": "fine"}, "tolerance: expected a number or"),
            ({"format": "csv", "boundary": "traction", "bulk": 5e9, "times": "1 s"}, "times: expected the first and"),
            ({"format": "csv", "boundary": "traction", "bulk": 5e9, "stage": "composit"}, "did you mean"),
            ({"format": "dma", "boundary": "traction", "tolerance": 0.01}, "tolerance: the format dma has none"),
            ({"format": "dma", "boundary": "traction", "frequency": -1.0}, "frequency: expected a positive number in Hz"),
            ({"format": "dma", "boundary": "traction", "frequency": [1, 2]}, "frequency: expected a frequency, as text"),
            ({"format": "dma", "boundary": "traction", "temperatures": (20, 30)},
             r"temperatures: .* cover .* degC, got -253.15 to -243.15 degC .20 to 30 K.")):
        with pytest.raises(breccia.InputError, match=message):
            breccia.export(result, **arguments)
    breccia.export(result, "csv", taken, boundary="traction", bulk=5e9, overwrite=True)
    assert taken.read_text() != "mine"
