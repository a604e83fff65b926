"""Arguments: quantities as text and as numbers, and mistakes, which are InputError with plain words."""

import re

import numpy as np
import pytest

import breccia
from breccia._quantities import UNITS
from conftest import MODEL, OVERRIDES, ROOT

RUBBER = breccia.Material("rubber", density=1100.0, bulk="2 GPa", shear=breccia.PronySeries([(1.0, 2e6)], 1e6))
GLASS = breccia.Material("glass", density=2500.0, bulk="40 GPa", shear="28 GPa")
BOX = breccia.Stage("box", matrix=RUBBER, box=1e-3, cells=4)
TESTS = breccia.Tests(times=(0.1, 10.0))


class WithUnits(np.ndarray):
    """An array as packages for quantities have it."""

    units = "um"


def test_materials_by_youngs_modulus_and_poissons_ratio():
    bulk, shear = 210e9 / (3.0 * (1.0 - 0.6)), 210e9 / 2.6
    for given in ({"young": "210 GPa", "poisson": 0.3}, {"young": 210e9, "poisson": np.float64(0.3)},
                  {"shear": shear, "poisson": 0.3}, {"young": 210e9, "shear": shear}, {"bulk": bulk, "poisson": 0.3}):
        solid = breccia.Material("steel", density=7850, **given).solid()
        assert solid.bulk.equilibrium == pytest.approx(bulk) and solid.shear.equilibrium == pytest.approx(shear)
    steel = breccia.Material("steel", density=7850, young="210 GPa", poisson=0.3)
    study = breccia.Study(breccia.Stage("box", matrix=steel, box="1 mm", cells=4), TESTS)
    assert "poisson = 0.3\n" in study.deck
    # A constant ratio: both moduli relax in proportion.
    soft = breccia.Material("m", density=1e3, young=breccia.PronySeries([(1.0, 2.6e6)], 2.6e6), poisson=0.3).solid()
    assert soft.shear.terms == pytest.approx(np.array([[1.0, 1e6]])) and soft.bulk.equilibrium == pytest.approx(2.6e6 / 1.2)
    with pytest.raises(breccia.InputError, match="poisson"):
        breccia.Material("m", density=1e3, young=1e6, poisson=0.5).solid()


@pytest.mark.parametrize("by_number, by_text", [
    ({"terms": [{"time": 1.0, "modulus": 1e6}], "equilibrium": 1e5},
     {"terms": [{"time": "1 s", "modulus": "1 MPa"}], "equilibrium": "0.1 MPa"}),
    (breccia.PronySeries([("1 ms", "2 MPa"), (1.0, 5e5)], equilibrium="1 MPa"),
     breccia.PronySeries([(1e-3, 2e6), (1.0, 5e5)], 1e6)),
])
def test_moduli_by_numbers_are_those_by_text(by_number, by_text):
    shift = {"law": "wlf", "c1": 14, "c2": 120.0, "reference": 293.15, "temperature": 303.15}
    same = {"law": "wlf", "c1": 14, "c2": "120 K", "reference": "20 degC", "temperature": "30 degC"}
    one = breccia.Material("m", density=1000, bulk=3e9, shear=by_number, temperature_shift=shift).solid()
    other = breccia.Material("m", density="1 g/cm^3", bulk="3 GPa", shear=by_text, temperature_shift=same).solid()
    assert one == other and one.shear.relaxation_times[0] < 1.0


@pytest.mark.parametrize("by_number, by_text", [
    ({"from": 5e-6, "to": 75e-6}, {"from": "5 um", "to": "75 um"}),
    ({"d10": 1e-5, "d50": 2e-5, "d90": 4e-5}, {"d10": "10 um", "d50": "20 um", "d90": "40 um"}),
    ({"fuller": 75e-6}, {"fuller": "75 um", "exponent": 0.5}),
    ({"passing": [{"size": 7e-5, "passing": 1.0}, {"size": 1e-5, "passing": 0.0}]},
     {"passing": [{"size": "10 um", "passing": "0 %"}, {"size": "70 um", "passing": "100 %"}]}),
])
def test_sizes_by_numbers_are_those_by_text(by_number, by_text):
    def study(sizes):
        filler = breccia.Filler(breccia.Material("f", density=2e3, bulk=1e10, shear=1e10), fraction=0.2, sizes=sizes,
                                smallest=1e-5, largest=6e-5)
        binder = breccia.Material("b", density=1e3, bulk=1e9, shear=1e6)
        stage = breccia.Stage("s", matrix=binder, box=5e-4, cells=40, fillers=filler, packing="lubachevsky-stillinger")
        return breccia.Study(stage, breccia.Tests(times=(1e-3, 1.0)))
    one, other = (breccia.pack(study(sizes))["s"].microstructure for sizes in (by_number, by_text))
    assert np.allclose(one.particles, other.particles)


class Millisecond:
    """A quantity as packages of units have it, which NumPy takes for the number 1."""

    units = "ms"

    def __float__(self):
        return 1.0

    def __array__(self, *_, **__):
        return np.asarray(1.0)


def test_laws_take_numbers_in_si_units_and_text():
    by_number = {"law": "logarithmic-creep", "instantaneous": 40e-12, "creep": 20e-12, "time": 86400.0}
    by_text = {"law": "logarithmic-creep", "instantaneous": "40e-6 /MPa", "creep": "20 /TPa", "time": "1 day"}
    one = breccia.Material("paste", density=2000.0, young=by_number, poisson=0.2).solid().shear
    other = breccia.Material("paste", density=2000.0, young=by_text, poisson=0.2).solid().shear
    assert np.allclose(one.terms, other.terms, rtol=1e-12)
    assert np.isclose(one.at(0.0), 25e9 / 2.4, rtol=1e-6)
    compliance = one.creep_compliance().at(86400.0) / 2.4
    assert np.isclose(compliance, 40e-12 + 20e-12 * np.log(2.0), rtol=2e-3)


def test_what_numpy_would_drop_is_refused():
    series = breccia.PronySeries([(1.0, 1e6)], 1e6)
    times = np.array([1e-3, 1.0, 10.0])
    with pytest.raises(breccia.InputError, match="time: expected numbers in s, got a quantity of another package"):
        series.at(Millisecond())
    with pytest.raises(breccia.InputError, match="expected a list of numbers in s, got a quantity of another package"):
        breccia.fit(Millisecond(), [1.0])
    with pytest.raises(breccia.InputError, match="modulus: expected a list of numbers in Pa, got complex numbers"):
        breccia.fit(times, series.complex_modulus(times))
    with pytest.raises(breccia.InputError, match="quantity of another package"):
        breccia.PronySeries([(Millisecond(), 1e6)])
    for several in ([Millisecond(), 1.0], (1.0, Millisecond())):
        with pytest.raises(breccia.InputError, match="got a quantity of another package"):
            series.at(several)
    with pytest.raises(breccia.InputError, match="complex"):
        breccia.fit(times, list(series.complex_modulus(times)))
    with pytest.raises(breccia.InputError, match="time: expected a list of numbers in s, got 'long'"):
        breccia.fit("long", [1.0])


def test_two_lists_may_be_pairs_or_columns():
    with pytest.raises(breccia.InputError, match="two lists that may be columns"):
        breccia.PronySeries([[1e-3, 1.0], [10e6, 2e6]])
    pairs = breccia.PronySeries([(1e-3, 1e7), (1.0, 2e6)])
    assert breccia.PronySeries(np.array([[1e-3, 1e7], [1.0, 2e6]])) == pairs
    assert breccia.PronySeries(zip([1e-3, 1.0], [1e7, 2e6])) == pairs
    assert len(breccia.PronySeries([[1e-3, 1e7], [1.0, 2e6], [10.0, 1e6]]).terms) == 3


@pytest.mark.parametrize("inverse", ["1 /s", "1 s^-1", "1 Bq"])
def test_an_inverse_time_is_no_frequency(inverse):
    with pytest.raises(breccia.InputError, match="may mean cycles or radians"):
        breccia.PronySeries([(1.0, 1e6)]).complex_modulus(inverse)
    with pytest.raises(breccia.InputError, match="may mean cycles or radians"):
        breccia.Study(BOX, breccia.Tests(frequencies=(inverse, "100 Hz")))


def test_tables_within_tables_take_numbers():
    filler = breccia.Filler(GLASS, fraction=0.2, sizes={"lognormal": [{"median": 1e-4, "sigma": 0.2}]}, smallest=8e-5,
                            largest=1.2e-4, gap=2e-5)
    stage = breccia.Stage("box", matrix=RUBBER, box=1e-3, cells=40, fillers=filler, packing="lubachevsky-stillinger")
    study = breccia.Study(stage, breccia.Tests(times=(0.1, 10.0), quasistatic={"vary": {"glass": {"shear": [3e9, 3e11]}}}))
    for text in ('"median" = "0.0001 m"', '"shear" = ["3000000000.0 Pa", "300000000000.0 Pa"]', '"sigma" = 0.2'):
        assert text in study.deck
    listed = breccia.Filler(GLASS, sizes=["0.2 mm", 2e-4])
    study = breccia.Study(breccia.Stage("box", matrix=RUBBER, box=1e-3, cells=40, fillers=listed,
                                        packing="random-sequential"), TESTS)
    assert '"list" = ["0.2 mm", "0.0002 m"]' in study.deck


def test_boxes_and_cells_are_chosen_for_an_accuracy():
    filler = breccia.Filler(GLASS, fraction=0.3, diameter=1e-3, gap="10 %")

    def study(tests, **box):
        stage = breccia.Stage("box", matrix=RUBBER, fillers=filler, packing="lubachevsky-stillinger", **box)
        return breccia.Study(stage, breccia.Tests(times=TESTS.times, **tests))

    chosen = study({"accuracy": 0.2, "budget": 60.0})
    assert "accuracy = 0.2" in chosen.deck and 'budget = "60.0 s"' in chosen.deck
    assert breccia.solve(chosen).stages[0].test().error.max() < 0.2
    box = breccia.solve(study({}, particles=20, cells=16)).stages[0].microstructure
    assert box.fraction == pytest.approx(0.3, rel=1e-3)
    with pytest.raises(breccia.InputError, match="the box is given already"):
        study({}, particles=20, box=1e-3, cells=16)


def test_overrides_and_swept_keys_take_numbers():
    as_text = breccia.read_study(MODEL, {**OVERRIDES, "materials.binder.bulk": "2 MPa", "tests.times": ["1 ms", "50 ms"]})
    as_number = breccia.read_study(MODEL, {**OVERRIDES, "materials.binder.bulk": 2e6, "tests.times": (1e-3, 0.05)})
    assert as_number.materials == as_text.materials and as_number.times == as_text.times
    assert breccia.read_study(MODEL, "stages.0.cells=24").stages == ["model"]
    with pytest.raises(breccia.InputError, match="stages.model.box: missing"):
        breccia.read_study(MODEL, {"stages.0.box": None})
    studies = breccia.read_sweep(MODEL, OVERRIDES, keys={"materials.binder.bulk": [1e6, 2e6]})
    assert [study.materials[0].bulk.equilibrium for study in studies.values()] == [1e6, 2e6]
    ranges = breccia.read_sweep(MODEL, OVERRIDES, keys={"stages.0.cells": {"from": 8, "to": 10}})
    assert list(ranges) == ["cells-8", "cells-9", "cells-10"]
    between = breccia.read_sweep(MODEL, OVERRIDES, keys={"materials.binder.bulk": {"from": 1e6, "to": 3e6, "count": 3}})
    assert [study.materials[0].bulk.equilibrium for study in between.values()] == [1e6, 2e6, 3e6]


def test_every_quantity_of_a_deck_has_a_unit_here():
    """What the readers of decks take as quantities is what numbers get a unit for."""
    text = "".join(path.read_text() for path in (ROOT / "src" / "deck").glob("*.cpp"))
    keys = set(re.findall(r'quantit(?:y|ies)\(\s*"([a-z0-9_]+)",\s*Dimension::', text))
    # Read by a name in a variable, or a table of sizes that looks like a distribution.
    by_variable = {"bulk", "shear", "young", "times", "resolution", "gap", "d50", "d90", "sizes"}
    assert keys | by_variable == set(UNITS)


SERIES = breccia.PronySeries([(1e-3, 2e6), (1.0, 5e5)], equilibrium=1e5)


def test_series_take_text_with_units_and_pairs_of_any_kind():
    assert SERIES.at("1 s") == SERIES.at(1.0) and isinstance(SERIES.at("1 s"), float)
    assert SERIES.complex_modulus("10 rad/s") == SERIES.complex_modulus(10.0)
    assert SERIES.complex_modulus("1 Hz") == SERIES.complex_modulus(2.0 * np.pi)
    assert SERIES.creep_compliance().at("1 ms") == SERIES.creep_compliance().at(1e-3)
    times, moduli = [1e-3, 1.0], [2e6, 5e5]
    for terms in (zip(times, moduli), list(zip(times, moduli)), np.column_stack([times, moduli]), ((1e-3, 2e6), (1.0, 5e5)),
                  [["1 ms", "2 MPa"], [1.0, "500 kPa"]]):
        assert breccia.PronySeries(terms, equilibrium="0.1 MPa") == SERIES
    for terms in ([], (), np.empty((0, 2))):
        assert breccia.PronySeries(terms, 1.0).is_elastic


@pytest.mark.parametrize("call, message", [
    (lambda: breccia.PronySeries(([1e-3, 1e-1], [1e6, 2e6])), r"terms: expected pairs .* a tuple of two lists.*zip\(\)"),
    (lambda: breccia.PronySeries([np.array([1e-3, 1.0]), np.array([1e7, 2e6])]), "terms: expected pairs"),
    (lambda: SERIES.at(np.timedelta64(1, "ms")), "time: expected .* a time of numpy, whose unit would be lost"),
    (lambda: SERIES.at(np.array([1, 2], "timedelta64[ms]")), "time: expected .* a time of numpy"),
    (lambda: breccia.PronySeries(np.array([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]])), "terms: expected pairs"),
    (lambda: breccia.PronySeries([1.0, 2.0]), "terms: expected pairs .* got 1.0 in place of a pair"),
    (lambda: breccia.PronySeries(3e6), "terms: expected pairs"),
    (lambda: breccia.quantity(3, "pressure"), "text: expected a number with its unit in quotes, got 3"),
    (lambda: breccia.PronySeries([("1 Pa", 1e6)]), "terms: expected a time"),
    (lambda: breccia.PronySeries([(1.0, None)]), "terms: expected a pressure, as a number .* got None"),
    (lambda: SERIES.at("1 m"), "time: expected a time"),
    (lambda: SERIES.at(["soon"]), "time: expected numbers in s"),
    (lambda: SERIES.complex_modulus("1 m"), "angular_frequency: expected a frequency"),
    (lambda: breccia.Stage("a", matrix=RUBBER, fillers=GLASS), "Stage: fillers: expected a Filler or several"),
    (lambda: breccia.Study(breccia.Stage("a", matrix=None, box=1e-3, cells=4), TESTS), "stages.a.matrix: missing, expected text"),
    (lambda: breccia.Study(breccia.Stage("a", matrix=3, box=1e-3, cells=4), TESTS), "Stage: matrix: expected a name"),
    (lambda: breccia.Study(BOX, breccia.Tests(times=1.0)), "tests.times: expected"),
    (lambda: breccia.Study(BOX, None), "tests: expected Tests"),
    (lambda: breccia.Study(BOX, breccia.Tests(times=object())), "times: expected what a deck can hold"),
    (lambda: breccia.Study(BOX, TESTS, measurements=3), "measurements: expected a Measurement or several"),
    (lambda: breccia.Study("box", TESTS), "stages: expected a Stage or several"),
    (lambda: breccia.Study(BOX, TESTS, measurements=breccia.Measurement("m", shear=([1, 2], [1]))),
     "Measurement: shear: expected .times .s., moduli .Pa.., two lists of one length"),
    (lambda: breccia.Study(BOX, TESTS, measurements=breccia.Measurement("m", shear=([1, 2], [1, 2], [1, 2]))),
     "Measurement: shear: expected .times .s., moduli .Pa.., two lists of one length"),
    (lambda: breccia.Study(BOX, TESTS, measurements=breccia.Measurement("m", shear=([1, 2], [3 + 1j, 2]))),
     "Measurement: shear: expected numbers in Pa, got a complex number"),
    (lambda: breccia.Study(BOX, TESTS, measurements=breccia.Measurement("m", shear=([1, 2], ["3 MPa", "2 MPa"]))),
     "Measurement: shear: expected numbers in Pa, got something else among them"),
    (lambda: breccia.Study(breccia.Stage("a", matrix=RUBBER, box=1e-3, cells=4, fillers=breccia.Filler(
        GLASS.name, fraction=0.3, sizes=np.array([1e-4, 2e-4]).view(WithUnits))), TESTS, materials=GLASS),
     "list: expected numbers, or text with units, got a quantity of another package"),
    (lambda: breccia.solve("deck.toml"), r"study: expected a Study, .*read_study\('deck.toml'\)"),
    (lambda: breccia.run(breccia.Study(BOX, TESTS), "nowhere", time_limit=-1), "time_limit: expected a positive number"),
    (lambda: breccia.run(breccia.Study(BOX, TESTS), "nowhere", time_limit=[1]), "time_limit: expected a time"),
    (lambda: breccia.export("results", "abaqus"), r"result: expected a Result, .*read_results\('results'\)"),
    (lambda: breccia.respond("results", SERIES), "result: expected a Result"),
    (lambda: breccia.Image(np.zeros((4, 4), int), materials=None), "Image: materials: expected"),
    (lambda: breccia.Packing(particles=[["a", 1, 2]])._table(None), "Packing: particles: expected numbers"),
    (lambda: breccia.read_sweep(MODEL, keys={"stages.0.cells": 0.2}), "keys: stages.0.cells: expected a list of values"),
    (lambda: breccia.read_sweep(MODEL, keys={"stages.0.cells": "24"}), "keys: stages.0.cells: expected a list of values"),
])
def test_mistakes_have_plain_words(call, message):
    with pytest.raises(breccia.InputError, match=message):
        call()


def test_what_can_only_be_meant_one_way_is_taken():
    one = breccia.Measurement("m", shear=(np.array([0.1, 1.0, 10.0]), np.array([2e6, 1e6, 1e5])))
    study = breccia.Study(BOX, {"times": (0.1, 10.0), "boundaries": "displacement"}, measurements=one, materials=GLASS)
    assert study.times == (0.1, 10.0) and len(study.materials) == 2 and "[[measurements]]" in study.deck
    assert breccia.Stage("a", matrix=RUBBER, fillers=None).fillers == ()
    pixels = np.zeros((8, 8), int)
    pixels[2:4] = 1
    listed = breccia.Image(pixels, materials=[RUBBER, GLASS], pixel=1e-4)
    assert listed.materials == {0: RUBBER, 1: GLASS} and "Image((8, 8)" in repr(listed)
    assert "particles=" in repr(breccia.Packing(particles=np.zeros((2, 3))))


def test_messages_name_arguments_in_place_of_files_that_python_wrote():
    inside = breccia.Packing(particles=[[5e-4, 5e-4, np.nan]])
    with pytest.raises(breccia.InputError) as error:
        breccia.Study(breccia.Stage("box", matrix=RUBBER, box=1e-3, cells=8, fillers=breccia.Filler(GLASS), packing=inside),
                      TESTS)
    assert "particles of Packing" in str(error.value) and "/breccia-" not in str(error.value)
    with pytest.raises(breccia.InputError) as error:
        breccia.Study(breccia.Stage("scan", matrix=RUBBER, packing=breccia.Image(
            np.full((8, 8), 0.5), materials={0: RUBBER}, pixel=1e-4)), TESTS)
    assert "labels of Image" in str(error.value) and "/breccia-" not in str(error.value)
