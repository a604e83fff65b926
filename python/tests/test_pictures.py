"""Tables, pictures and axes of results, studies that are varied, calculations that are stopped."""

import csv
import inspect
import pickle
import sys
import threading
import time
import xml.etree.ElementTree as ET

import numpy as np
import pytest

import breccia


@pytest.fixture(scope="module")
def study():
    binder = breccia.Material("binder", density="1 g/cm^3", bulk="2 GPa",
                              shear=breccia.PronySeries([(1e-3, 1e6), (1e-1, 1e6)], equilibrium=1e5))
    glass = breccia.Material("glass", density="2.5 g/cm^3", young="70 GPa", poisson=0.2)
    stage = breccia.Stage("box", matrix=binder, box="6 mm", cells=60,
                          fillers=breccia.Filler(glass, fraction=0.3, diameter="1 mm"),
                          packing=breccia.Packing("lubachevsky-stillinger", seed=1))
    measured = breccia.Measurement("rheometer", shear=([1e-3, 1e-2, 1e-1], [4e6, 3e6, 2e6]))
    return breccia.Study(stage, breccia.Tests(times=("1 ms", "1 s"), loads=["isotropic", "bulk"]), measurements=measured)


@pytest.fixture(scope="module")
def in_directory(study, tmp_path_factory):
    place = tmp_path_factory.mktemp("run") / "results"
    return breccia.run(study, place), place


def rows_of(place, name):
    with open(place / name, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def test_tables_are_those_of_the_files(study, in_directory):
    result, place = in_directory
    errors = rows_of(place, "errors.csv")
    table = result.table()
    known = {(row["stage"], row["load"], row["boundary"], float(row["time_s"])): row for row in errors}
    for *key, error in zip(table["stage"], table["load"], table["boundary"], table["time_s"].tolist(), table["error"]):
        assert error == pytest.approx(float(known[tuple(key)]["error"] or "nan"), nan_ok=True)
    rows = rows_of(place, "curves.csv")
    assert len(table["stage"]) == len(rows)
    for column in ("stage", "load", "boundary", "method", "cells"):
        assert table[column] == [row[column] for row in rows]
    assert table["modulus_Pa"].tolist() == [float(row["modulus_Pa"]) for row in rows]
    engineering = result.table("engineering")
    for column, values in engineering.items():
        written = [row[column] for row in rows_of(place, "engineering.csv")] if column != "load" else values
        if column in ("stage", "load", "boundary", "method"):
            assert values == written
        else:
            assert np.array_equal(values, [float(text or "nan") for text in written], equal_nan=True)
    assert np.isfinite(engineering["youngs_modulus_error"]).all() and (engineering["youngs_modulus_error"] < 0.5).all()
    comparison = result["box"].table("comparison")
    assert np.isfinite(comparison["error"]).all()
    assert comparison["ratio"].tolist() == [float(row["ratio"]) for row in rows_of(place, "comparison.csv")]
    assert set(table) == {*rows[0], "error"}
    assert set(engineering) == {*rows_of(place, "engineering.csv")[0], "load"} - {"cells"}
    dynamic = result.table("dynamic")
    assert set(dynamic) == {*rows_of(place, "dynamic.csv")[0], "frequency_Hz", "error"}
    written = [float(row["storage_modulus_Pa"]) for row in rows_of(place, "dynamic.csv")]
    assert np.allclose(np.sort(dynamic["storage_modulus_Pa"])[[0, -1]], [min(written), max(written)], rtol=1e-9)
    assert set(dynamic["load"]) >= {"isotropic", "bulk"} and len(dynamic["load"]) == len(dynamic["frequency_Hz"])
    assert breccia.pack(study).table() == {}
    with pytest.raises(breccia.InputError, match="kind: expected 'curves', 'dynamic', 'engineering', 'comparison', got"):
        result.table("moduli")


def test_pictures_name_their_axes_and_have_matrix_and_errors(in_directory):
    result, _ = in_directory
    svg = result.svg()
    assert ET.fromstring(svg).tag.endswith("svg") and svg == result._repr_svg_()
    for text in ("G(t)</text>", "Time / s</text>", "binder</text>", "rheometer</text>", "<polygon", "<circle"):
        assert text in svg, text
    assert "binder</text>" not in result["box"].svg() and "<polygon" in result["box"].svg()
    engineering = result["box"].engineering()
    assert "E, G, K</text>" in engineering.svg()
    again = pickle.loads(pickle.dumps(engineering))
    assert np.isfinite(engineering.complex_young_error).all()
    assert np.array_equal(again.complex_young_error, engineering.complex_young_error)
    assert "G\u2032, G\u2033</text>" in result["box"].test("isotropic").in_frequency.svg()
    assert breccia.PronySeries(equilibrium=1e6).svg() == ""
    creep = breccia.fit_creep([1, 2, 4, 8, 16], [1e-6, 1.2e-6, 1.4e-6, 1.6e-6, 1.8e-6])
    assert "J(t) / (1/Pa)</text>" in creep.svg()


def test_plots_are_drawn_on_axes_of_a_caller(in_directory):
    matplotlib = pytest.importorskip("matplotlib")
    result, _ = in_directory
    axes = result.plot()
    assert axes.get_xlabel() == "Time / s" and axes.get_ylabel() == "G(t) / Pa" and axes.get_xscale() == "log"
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["periodic", "rheometer", "binder"]
    line = axes.get_lines()[0]
    assert line.get_ydata().tolist() == result["box"].test("isotropic").modulus.tolist()
    result.plot(axes, label="again")
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["periodic", "rheometer", "binder", "again, periodic"]
    assert axes.get_lines()[-1].get_color() != line.get_color()
    with pytest.raises(breccia.InputError, match="ax: expected axes of Matplotlib, got 'plot.png'"):
        result.plot("plot.png")
    own = matplotlib.pyplot.subplots()[1]
    assert result["box"].engineering().plot(ax=own) is own and len(own.get_lines()) == 3
    with pytest.raises(breccia.InputError, match="there is no curve"):
        breccia.PronySeries(equilibrium=1e6).plot()


def test_a_plot_without_matplotlib_says_so(in_directory, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)
    with pytest.raises(breccia.InputError, match="Matplotlib is not installed; svg"):
        in_directory[0].plot()


def test_names_are_completed(in_directory, study):
    assert in_directory[0]._ipython_key_completions_() == ["box"]
    assert breccia.plan(study)._ipython_key_completions_() == ["box"]


def test_a_study_is_varied(study, tmp_path):
    other = study.replace({"stages.0.cells": 12, "materials.glass.young": 50e9})
    assert other.overrides == ["stages.0.cells=12", 'materials.glass.young="50000000000.0 Pa"'] and study.overrides == []
    glass = next(material for material in other.materials if material.name == "glass")
    assert glass.shear.equilibrium == pytest.approx(50e9 / 2.4)
    again = pickle.loads(pickle.dumps(other.replace({"stages.0.cells": 16})))
    assert again.overrides[-1] == "stages.0.cells=16"
    assert breccia.solve(again)["box"].cells == 16
    without = study.replace({"tests.loads": None})
    assert without.replace({"tests.loads": None}).overrides == without.overrides == ["tests.loads="]
    with pytest.raises(breccia.InputError, match='unknown key "cels"'):
        study.replace({"stages.0.cels": 12})
    deck = tmp_path / "deck.toml"
    deck.write_text(study.deck)
    read = breccia.read_study(deck, {"stages.0.cells": 12})
    deck.unlink()
    assert read.replace({"tests.times": ["1 ms", "10 ms"]}).times == (1e-3, 1e-2)


def test_tasks_of_a_sweep_have_their_values(study, tmp_path):
    deck = tmp_path / "deck.toml"
    deck.write_text(study.deck)
    tasks = breccia.read_sweep(deck, keys={"stages.0.cells": [8, 12]})
    assert [task.overrides for task in tasks.values()] == [["stages.0.cells=8"], ["stages.0.cells=12"]]


def test_calculations_are_stopped(study, tmp_path):
    slow = study.replace({"stages.0.cells": 400})
    begun, stop = time.monotonic(), threading.Event()
    threading.Timer(0.3, stop.set).start()
    with pytest.raises(breccia.Interrupted, match="the calculation was stopped and is lost"):
        breccia.solve(slow, stop=stop)
    with pytest.raises(breccia.Interrupted):
        breccia.solve(slow, time_limit="0.2 s")
    stop.set()
    with pytest.raises(breccia.Interrupted, match="resume=True"):
        breccia.run(slow, tmp_path / "run", stop=stop)
    quick = study.replace({"stages.0.cells": 30})
    with pytest.raises(breccia.Interrupted):
        breccia.run(quick, tmp_path / "quick", stop=stop)
    resumed = breccia.run(quick, tmp_path / "quick", resume=True)["box"].test("isotropic").modulus
    assert np.array_equal(resumed, breccia.solve(quick)["box"].test("isotropic").modulus)
    # While another thread calculates, too.
    other = threading.Thread(target=lambda: pytest.raises(breccia.Interrupted, breccia.solve, slow, time_limit="3 s"))
    other.start()
    time.sleep(0.3)
    waited = time.monotonic()
    with pytest.raises(breccia.Interrupted, match="before it began"):
        breccia.solve(quick, stop=stop)
    assert time.monotonic() - waited < 2
    other.join()
    assert time.monotonic() - begun < 60
    for wrong in ("now", True):
        with pytest.raises(breccia.InputError, match="stop: expected what has is_set"):
            breccia.solve(study, stop=wrong)


def test_functions_have_signatures_and_refuse_what_is_no_number():
    assert list(inspect.signature(breccia.fit).parameters) == ["time", "modulus", "ramp", "times_per_decade",
                                                                "law", "keep"]
    made = {"PronySeries": ["terms", "equilibrium"], "Solid": ["name", "density", "bulk", "shear"],
            "CreepCompliance": ["instantaneous", "terms", "fluidity"]}
    for name, parameters in made.items():
        assert list(inspect.signature(getattr(breccia, name)).parameters) == parameters
    data = [1, 2, 4, 8, 16], [5e6, 4e6, 3e6, 2e6, 1.5e6]
    assert breccia.fit(*data, ramp="100 ms").series == breccia.fit(*data, ramp=0.1).series
    with pytest.raises(breccia.InputError, match="ramp: "):
        breccia.fit(*data, ramp="1 m")
    with pytest.raises(breccia.InputError, match="times_per_decade: expected a number, got '10'"):
        breccia.fit(*data, times_per_decade="10")


def test_tests_in_bulk_are_drawn_as_such(study):
    in_bulk = breccia.solve(study.replace({"tests.times": None, "tests.frequencies": ["1 Hz", "100 Hz"],
                                           "tests.loads": ["bulk"], "measurements": None}))
    assert "M\u2032, M\u2033</text>" in in_bulk.svg() and "binder" not in in_bulk.svg()


def test_youngs_modulus_is_drawn_where_it_was_measured(study, tmp_path):
    table = "time_s,youngs_modulus_Pa\n0.001,1e7\n0.1,5e6\n"
    (tmp_path / "tension.csv").write_text(table)
    deck = study.deck
    begin = deck.index("[[measurements]]")
    (tmp_path / "deck.toml").write_text(deck[:begin] + '[[measurements]]\nname = "tension"\nyoung = { curve = "tension.csv" }\n')
    result = breccia.solve(breccia.read_study(tmp_path / "deck.toml"))
    svg = result.svg()
    assert "E(t)</text>" in svg and "tension</text>" in svg and "<polygon" in svg and "binder</text>" not in svg
    in_frequency = breccia.read_study(tmp_path / "deck.toml", {"tests.times": None, "tests.frequencies": ["1 Hz", "100 Hz"]})
    assert "E\u2032, E\u2033</text>" in breccia.solve(in_frequency).svg()
