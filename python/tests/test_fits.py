"""Series and fits against what they were made from."""

import pickle

import numpy as np
import pytest

import breccia
from conftest import ROOT

SERIES = breccia.PronySeries([(1e-3, 2e6), (1.0, 5e5)], equilibrium=1e5)


def test_series_are_evaluated_at_numbers_and_arrays():
    time = np.array([[0.0, 1e-3], [1.0, 10.0]])
    exact = 1e5 + 2e6 * np.exp(-time / 1e-3) + 5e5 * np.exp(-time)
    assert SERIES.at(time) == pytest.approx(exact) and SERIES.at(time).shape == (2, 2)
    assert isinstance(SERIES.at(0), float) and SERIES.at(0) == SERIES.unrelaxed == 2.6e6
    assert SERIES.relaxation_times.tolist() == [1.0, 1e-3] and SERIES.moduli.tolist() == [5e5, 2e6]
    assert SERIES.shifted(10.0).at(10.0) == pytest.approx(SERIES.at(1.0))
    assert SERIES.scaled(2.0).at(1.0) == pytest.approx(2.0 * SERIES.at(1.0))
    assert breccia.PronySeries(equilibrium=1.0).is_elastic


def test_creep_and_relaxation_are_each_others_inverse():
    again = SERIES.creep_compliance().relaxation_modulus()
    assert again.terms == pytest.approx(SERIES.terms, rel=1e-10)
    # s^2 G(s) J(s) = 1 holds as G*(w) J*(w) = 1.
    frequency = np.geomspace(1e-3, 1e5, 9)
    assert SERIES.complex_modulus(frequency) * SERIES.creep_compliance().complex_compliance(frequency) == pytest.approx(
        np.ones(9))


def test_a_law_is_fitted_in_place_of_a_spectrum():
    table = {"law": "2s2p1d", "static": 0.0, "glassy": 1e9, "delta": 2.2, "time": 2e-3, "k": 0.22, "h": 0.63, "beta": 50.0}
    truth = breccia.Material("bitumen", density=1040, bulk=2.5e9, shear=table).solid().shear
    frequency = np.geomspace(1e-3, 1e5, 60)
    modulus = truth.complex_modulus(frequency)
    fit = breccia.fit_dynamic(frequency, modulus.real, modulus.imag, law="2s2p1d", keep={"static": "0 Pa"})
    # The series of the truth is within 0.1 % of the formula that is fitted.
    assert fit.law == pytest.approx(table, rel=0.05) and fit.worst_error < 2e-3
    assert fit.law_errors["static"] == 0.0 and 0.0 < fit.law_errors["k"] < 0.01
    assert "2s2p1d" in repr(fit) and pickle.loads(pickle.dumps(fit)).law_errors == fit.law_errors
    # A material takes the law as it is.
    again = breccia.Material("bitumen", density=1040, bulk=2.5e9, shear=fit.law).solid().shear
    assert again.at(1.0) == pytest.approx(truth.at(1.0), rel=5e-3)
    assert breccia.fit_dynamic(frequency, modulus.real, modulus.imag).law is None


def test_a_law_of_creep_takes_what_is_known():
    time = np.geomspace(1.0, 1e7, 50)
    compliance = 4e-11 + 2e-11 * np.log1p((time / 86400) ** 0.1)
    fit = breccia.fit_creep(time, compliance, law="logarithmic-creep", keep={"time": "1 day", "exponent": 0.1})
    assert fit.law["creep"] == pytest.approx(2e-11, rel=1e-6)
    assert fit.compliance.at(1e4) == pytest.approx(np.interp(1e4, time, compliance), rel=5e-3)
    assert pickle.loads(pickle.dumps(fit)).law == fit.law
    relaxation = breccia.fit(time, 1.0 / compliance, law="fractional-zener")
    assert relaxation.law["law"] == "fractional-zener" and relaxation.worst_error < 0.05


@pytest.mark.parametrize("arguments, message", [
    ({"law": "huet"}, 'law: expected "2s2p1d" or'),
    ({"law": "power-law-creep"}, "power-law-creep is a creep compliance"),
    ({"law": "2s2p1d", "ramp": 1.0}, "ramp: not with a law"),
    ({"law": "2s2p1d", "times_per_decade": 5.0}, "times_per_decade: not with a law"),
    ({"keep": {"k": 0.2}}, "keep: expected a law whose parameters they are"),
    ({"law": "2s2p1d", "keep": [0.2]}, "keep: expected values by parameters"),
    ({"law": "2s2p1d", "keep": {"k": "0.2"}}, "keep: k: expected a number, got '0.2'"),
    ({"law": "2s2p1d", "keep": {"glassy": "2 s"}}, "keep: glassy: expected a pressure"),
    ({"law": "2s2p1d", "keep": {"exponent": 0.2}}, "exponent: not a parameter of 2s2p1d"),
])
def test_laws_that_do_not_suit_are_refused(arguments, message):
    time = np.geomspace(1e-5, 1e2, 80)
    with pytest.raises(breccia.InputError, match=message):
        breccia.fit(time, SERIES.at(time), **arguments)


def test_fits_find_the_series_of_their_data():
    time = np.geomspace(1e-5, 1e2, 80)
    fit = breccia.fit(time, SERIES.at(time))
    assert fit.worst_error < 0.01 and np.allclose(fit.fitted, SERIES.at(time), rtol=0.01)
    assert fit.series.at(0.1) == pytest.approx(SERIES.at(0.1), rel=0.01)
    frequency = np.geomspace(1e-3, 1e5, 80)
    dynamic = breccia.fit_dynamic(frequency, SERIES.complex_modulus(frequency).real,
                                  SERIES.complex_modulus(frequency).imag)
    assert dynamic.series.at(0.1) == pytest.approx(SERIES.at(0.1), rel=0.02)
    creep = breccia.fit_creep(time, SERIES.creep_compliance().at(time))
    assert creep.compliance.at(0.1) == pytest.approx(SERIES.creep_compliance().at(0.1), rel=0.02)
    again = pickle.loads(pickle.dumps(fit))
    assert again.series == fit.series and np.array_equal(again.fitted, fit.fitted)
    assert repr(fit).endswith(" s>") and repr(creep).endswith(" s>") and repr(dynamic).endswith(" rad/s>")
    assert np.array_equal(fit.time, time) and len(fit.angular_frequency) == 0 and np.array_equal(
        fit.measured, SERIES.at(time))
    assert np.array_equal(dynamic.angular_frequency, frequency) and len(dynamic.time) == 0
    assert len(dynamic.measured) == len(dynamic.fitted) == 160
    copied = pickle.loads(pickle.dumps(creep))
    assert copied.compliance == creep.compliance and np.array_equal(copied.measured, creep.measured)
    assert repr(copied) == repr(creep) and repr(pickle.loads(pickle.dumps(dynamic))) == repr(dynamic)
    for one, marks in ((fit, 80), (creep, 80), (dynamic, 160)):
        assert one._repr_html_().count("<circle") == marks + one._repr_html_().count("measured</text>")


def test_master_curve_finds_the_shift_law():
    frequency = np.geomspace(1e-1, 1e2, 20)
    wide = breccia.PronySeries([(10.0**decade, 1e6) for decade in range(-8, 9)], equilibrium=1e5)
    sweeps = []
    for kelvin in (283.15, 293.15, 303.15, 313.15):
        factor = 10.0 ** (-8.0 * (kelvin - 293.15) / (100.0 + kelvin - 293.15))
        moduli = wide.complex_modulus(frequency * factor)
        sweeps.append((kelvin, frequency, moduli.real, moduli.imag))
    curve = breccia.master_curve(sweeps, 293.15)
    law = curve.williams_landel_ferry()
    assert law.shift_factor(303.15) == pytest.approx(10.0 ** (-80.0 / 110.0), rel=0.05)
    assert curve.shift_factors.shape == (4, 3) and curve.series.at(1.0) == pytest.approx(wide.at(1.0), rel=0.02)
    assert len(curve.angular_frequency) == len(curve.storage) == len(curve.loss) == 80


@pytest.mark.parametrize("arguments", [
    ([1.0, 2.0], [1.0, 2.0, 3.0]),
    ([1.0, 2.0], [2.0, 1.0]),
    ([3.0, 2.0, 1.0], [1.0, 2.0, 3.0]),
    ([[1.0, 2.0, 3.0]], [[1.0, 2.0, 3.0]]),
])
def test_data_that_cannot_be_fitted_are_refused(arguments):
    with pytest.raises(breccia.InputError):
        breccia.fit(*arguments)


def test_quantities():
    assert breccia.quantity("0.5 um", "length") == pytest.approx(5e-7)
    assert breccia.quantity("19 degC", "temperature") == pytest.approx(292.15)
    with pytest.raises(breccia.InputError, match="expected a length"):
        breccia.quantity("1 s", "length")


@pytest.mark.parametrize("call, message", [
    (lambda: SERIES.scaled(-1), "factor: expected a positive number, got -1"),
    (lambda: SERIES.scaled(0), "factor: expected a positive number, got 0"),
    (lambda: SERIES.shifted(0), "factor: expected a positive number, got 0"),
    (lambda: SERIES.shifted(np.inf), "factor: expected a positive number, got inf"),
    (lambda: SERIES.at(-1), "time: expected a non-negative number in s, got -1"),
    (lambda: SERIES.at([1.0, np.nan]), "time: expected a non-negative number in s, got nan"),
    (lambda: SERIES.complex_modulus(-2.5), "angular_frequency: expected a non-negative number in rad/s, got -2.5"),
    (lambda: SERIES.creep_compliance().at(-1), "time: expected a non-negative number in s, got -1"),
    (lambda: SERIES.creep_compliance().complex_compliance(0),
     "angular_frequency: expected a positive number in rad/s, got 0"),
])
def test_numbers_out_of_range_are_refused(call, message):
    with pytest.raises(ValueError, match="^" + message) as error:
        call()
    assert isinstance(error.value, breccia.InputError)


def test_sweeps_of_an_instrument_become_a_master_curve():
    sweeps = breccia.read_sweeps(ROOT / "data" / "synthetic_dma.csv", kind="shear")
    assert len(sweeps) == 11 and sweeps[0][0] == pytest.approx(232.15)
    curve = breccia.master_curve(sweeps, "19 degC")
    law = curve.williams_landel_ferry()
    assert abs(law.c1 - 6.5) < 3 * law.c1_error and abs(law.c2 - 120.0) < 3 * law.c2_error
    assert curve._repr_html_().count("<circle") > 300
    binder = breccia.Material("binder", density=1480.0, bulk="3.6 GPa", shear=curve.series, temperature_shift=law)
    study = breccia.Study(breccia.Stage("box", matrix=binder, box="1 mm", cells=4), breccia.Tests(times=(1e-3, 1.0)))
    assert study.materials[0].shear.terms == pytest.approx(curve.series.terms, rel=1e-14)
    again = pickle.loads(pickle.dumps(curve))
    assert again.series == curve.series and np.array_equal(again.shift_factors, curve.shift_factors)
    for name in ("angular_frequency", "storage", "loss", "reference_temperature"):
        assert np.array_equal(getattr(again, name), getattr(curve, name))
    assert repr(again.fit) == repr(curve.fit) and repr(curve.fit).endswith("rad/s>")
    same = pickle.loads(pickle.dumps(law))
    assert (same.c1, same.c2, same.c1_error, same.c2_error) == (law.c1, law.c2, law.c1_error, law.c2_error)
    assert law.shift_factor("30 degC") == law.shift_factor(303.15) == same.shift_factor(303.15)
    in_words = [(f"{kelvin} K", *columns) for kelvin, *columns in sweeps]
    assert breccia.master_curve(in_words, "19 degC").series == curve.series
    with pytest.raises(breccia.InputError, match="reference_temperature: expected a temperature"):
        breccia.master_curve(sweeps, "19 m")
    with pytest.raises(breccia.InputError, match="expected storage and loss moduli"):
        breccia.read_sweeps(ROOT / "data" / "pbx9501_binder_prony.csv")


@pytest.mark.parametrize("sweeps, message", [
    ([(293.0, [1, 2], [1, 2])], r"sweeps\[0\]: expected \(temperature"),
    ({"a": 1}, "sweeps: expected a list of sweeps"),
    ([(293.0, [1, 2], ["x", 2], [1, 2])], r"sweeps\[0\]: storage: expected a list of numbers"),
    ([("20 m", [1, 2], [1, 2], [1, 2])], r"sweeps\[0\]: temperature: expected a temperature"),
])
def test_sweeps_that_are_none_are_refused(sweeps, message):
    with pytest.raises(breccia.InputError, match=message):
        breccia.master_curve(sweeps, "20 degC")


def test_columns_are_chosen_by_words(tmp_path):
    file = tmp_path / "instrument.csv"
    frequency = np.array([1.0, 2.0, 5.0, 10.0])
    file.write_text("f [Hz],E1 [MPa],E2 [MPa]\n" + "".join(f"{f!r},{10 + f!r},{f!r}\n" for f in frequency.tolist()))
    columns = {"frequency": "f [Hz]", "storage": "E1 [MPa]", "loss": "E2 [MPa]"}
    (_, omega, storage, loss), = breccia.read_sweeps(file, kind="young", columns=columns)
    assert omega == pytest.approx(2.0 * np.pi * frequency)
    assert storage == pytest.approx((10.0 + frequency) * 1e6) and loss == pytest.approx(frequency * 1e6)
    measured = breccia.read_measured(file, columns=columns)
    assert np.array_equal(measured["storage_modulus"], storage) and set(measured) == {
        "angular_frequency", "storage_modulus", "loss_modulus"}
    with pytest.raises(breccia.InputError, match='columns: unknown quantity "storrage", did you mean "storage"'):
        breccia.read_measured(file, columns={"storrage": "E1 [MPa]"})
    with pytest.raises(breccia.InputError, match="columns: expected names by quantities"):
        breccia.read_sweeps(file, columns="storage=E1")
    german = tmp_path / "german.csv"
    german.write_text("Frequenz [Hz],Speicher [MPa]\n1,2\n2,3\n")
    with pytest.raises(breccia.InputError) as error:
        breccia.read_sweeps(german)
    assert 'columns={"storage": NAME, "loss": NAME} tells' in str(error.value) and "--columns" not in str(error.value)


def test_moduli_by_absolute_value_and_phase_angle_are_read(tmp_path):
    file = tmp_path / "asphalt.csv"
    file.write_text("frequency_Hz,|G*| [MPa],phase_angle_deg\n1,10,45\n10,20,30\n")
    measured = breccia.read_measured(file)
    assert measured["absolute_modulus"] == pytest.approx([10e6, 20e6])
    assert measured["phase_angle"] == pytest.approx(np.radians([45.0, 30.0]))
    file.write_text("frequency_Hz,storage_modulus_MPa,tan_delta\n1,10,1\n10,20,0.57735\n")
    measured = breccia.read_measured(file)
    assert measured["loss_tangent"] == pytest.approx([1.0, 0.57735])
