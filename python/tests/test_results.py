"""Results: the bits of the command line, arrays without copies, pickles, what notebooks show."""

import csv
import pickle
import xml.etree.ElementTree as ET

import numpy as np
import pytest

import breccia
from conftest import MODEL, OVERRIDES


def test_lines_of_the_design():
    study = breccia.read_study(str(MODEL), {"stages.0.cells": 24, "tests.method": "quasistatic"})
    result = breccia.solve(study)
    time, modulus = result["model"].curve(load="shear", boundary="displacement")
    series = result["model"].prony(load="shear", boundary="displacement")
    # Independent numbers: Table of the model composite, 24 cells, standard points (80 steps a decade).
    known = {1e-3: 0.884355e6, 3e-3: 0.744429e6, 1e-2: 0.419205e6, 3e-2: 0.118464e6, 5e-2: 0.0636499e6}
    for at, expected in known.items():
        assert series.at(at) == pytest.approx(expected, rel=2e-4)
    assert np.allclose(series.at(time), modulus, rtol=1e-12)
    assert series.complex_modulus(100.0) == pytest.approx(
        series.equilibrium + sum(m * (1j * 100 * t) / (1 + 1j * 100 * t) for t, m in series.terms))
    assert breccia.fit(time, modulus).worst_error < 0.01
    other = breccia.respond(result, binder=breccia.PronySeries([(0.02, 0.4e6)]), times=("2 ms", "20 ms"))
    assert other["model"].curve()[0][0] == 2e-3


def test_same_bits_as_the_command_line(command, tmp_path):
    overrides = [f'--set={key}={str(value).replace(chr(39), chr(34))}' for key, value in OVERRIDES.items()]
    assert command("run", MODEL, *overrides, "--out", tmp_path / "command", "--quiet").returncode == 0
    study = breccia.read_study(MODEL, OVERRIDES)
    written = breccia.run(study, tmp_path / "module")
    for table in ("curves.csv", "prony.csv", "compliance.csv", "quality.csv"):
        assert (tmp_path / "module" / table).read_bytes() == (tmp_path / "command" / table).read_bytes()
    solved = breccia.solve(study)
    with open(tmp_path / "command" / "curves.csv") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    for boundary in ("displacement", "traction"):
        of_boundary = [float(row["modulus_Pa"]) for row in rows if row["boundary"] == boundary]
        assert solved["model"].curve(boundary=boundary)[1].tolist() == of_boundary
        assert np.array_equal(written["model"].curve(boundary=boundary), solved["model"].curve(boundary=boundary))


def test_curves_are_views_that_keep_their_result_alive():
    time, modulus = breccia.solve(breccia.read_study(MODEL, OVERRIDES))["model"].curve(boundary="traction")
    assert not modulus.flags.owndata and not modulus.flags.writeable
    assert modulus[0] > modulus[-1] > 0.0  # the result itself has no other name
    with pytest.raises(ValueError):
        modulus[0] = 0.0
    assert len(time) == len(modulus)


def test_curves_are_not_copied():
    study = breccia.read_study(MODEL, {**OVERRIDES, "tests.points_per_decade": 1000})
    fine = breccia.solve(study)
    first, second = (fine["model"].curve(boundary="displacement") for _ in range(2))
    assert len(first[0]) > 1000
    address = [array.__array_interface__["data"][0] for array in (*first, *second)]
    assert address[0] == address[2] and address[1] == address[3] == address[0] + 8
    assert len(breccia.fit(first[0][::20], first[1][::20]).fitted) >= 50


def test_pickles_hold_everything(model):
    copy = pickle.loads(pickle.dumps(model))
    for stage, again in zip(model.stages, copy.stages):
        assert again.name == stage.name and again.warnings == stage.warnings and again.points == stage.points
        for test, same in zip(stage.tests, again.tests):
            assert np.array_equal(test.modulus, same.modulus) and np.array_equal(test.compliance, same.compliance)
            assert test.series == same.series and test.seconds == same.seconds and test.grid == same.grid
            assert test.error_estimate == same.error_estimate
            assert len(test.fields) == len(same.fields)
            for field, other in zip(test.fields, same.fields):
                assert all(np.array_equal(field[key], other[key]) for key in field)
        assert np.array_equal(stage.microstructure.centres, again.microstructure.centres)
        assert stage.microstructure.svg() == again.microstructure.svg()
    assert copy._repr_html_() == model._repr_html_()
    softer = breccia.PronySeries([(0.01, 0.4e6)])
    for boundary in ("displacement", "traction"):
        assert np.array_equal(breccia.respond(copy, softer)["model"].curve(boundary=boundary),
                              breccia.respond(model, softer)["model"].curve(boundary=boundary))
    stage = pickle.loads(pickle.dumps(model["model"]))
    test = pickle.loads(pickle.dumps(stage.test(boundary="traction")))
    assert np.array_equal(test.modulus, model["model"].curve(boundary="traction")[1])
    series = model["model"].prony(boundary="traction")
    assert pickle.loads(pickle.dumps(series)) == series
    assert pickle.loads(pickle.dumps(series.creep_compliance())) == series.creep_compliance()
    with pytest.raises(breccia.InputError, match="another version"):
        breccia.Result.__new__(breccia.Result).__setstate__({"format": 0})


def test_the_mean_of_all_shears_is_the_modulus_by_default():
    study = breccia.read_study(MODEL, {**OVERRIDES, "tests.loads": ["isotropic", "bulk"]})
    stage = breccia.solve(study)["model"]
    shears = [stage.curve(load, "displacement")[1] for load in ("shear", "shear-xx-yy")]
    assert np.allclose(stage.curve(boundary="displacement")[1], np.mean(shears, axis=0), rtol=1e-14)
    assert stage.test(boundary="displacement").load == "isotropic"
    assert stage.engineering("displacement").load == "isotropic"
    time, compliance = stage.compliance(boundary="traction")
    series = stage.prony(boundary="traction")
    assert np.allclose(compliance[0] * series.at(time[0]), 1.0, rtol=0.1) and len(time) > 20
    assert "isotropic" in stage._repr_html_()
    assert pickle.loads(pickle.dumps(stage)).curve(boundary="displacement")[1][0] == np.mean(shears, axis=0)[0]


def test_a_test_is_found_by_words(model):
    stage = model["model"]
    with pytest.raises(breccia.InputError, match='expected boundary="displacement" or boundary="traction"'):
        stage.curve()
    with pytest.raises(breccia.InputError, match="load: expected .*got \"sheer\""):
        stage.curve("sheer")
    with pytest.raises(breccia.InputError, match="no such test; it has shear, displacement, 24 cells, quasistatic"):
        stage.curve("bulk", "displacement")
    with pytest.raises(breccia.InputError, match="grid: expected"):
        stage.curve(boundary="traction", grid="fine")
    with pytest.raises(KeyError, match="did you mean"):
        model["modle"]
    with pytest.raises(KeyError) as error:
        model["elsewhere"]
    assert str(error.value).count("model") == 1
    with pytest.raises(breccia.InputError, match=r"expected the name of a stage, got 0; .*result.stages"):
        model[0]
    assert stage.test(boundary="traction", grid=24).grid == 24
    assert "model" in model and len(model) == 1 and [test.load for test in stage.tests] == ["shear", "shear"]


def test_responses_to_other_materials(model, binder, tmp_path):
    again = breccia.respond(model, binder)
    for boundary in ("displacement", "traction"):
        assert again["model"].curve(boundary=boundary)[1] == pytest.approx(
            model["model"].curve(boundary=boundary)[1], rel=1e-9)
    file = tmp_path / "binder.toml"
    file.write_text('density = "1 g/cm^3"\nbulk = "1 MPa"\n'
                    'shear = { terms = [{ time = "10 ms", modulus = "0.5 MPa" }] }\n')
    assert np.array_equal(breccia.respond(model, file)["model"].curve(boundary="traction"),
                          again["model"].curve(boundary="traction"))
    stiff = breccia.PronySeries([(0.01, 5e6)])
    with pytest.raises(breccia.InputError, match="shows a shear modulus"):
        breccia.respond(model, stiff)
    with pytest.raises(breccia.InputError, match="either other materials"):
        breccia.respond(model)
    with pytest.raises(breccia.InputError, match="temperature_shift"):
        breccia.respond(model, temperature="40 degC")
    with pytest.raises(breccia.InputError, match="temperature: expected a temperature"):
        breccia.respond(model, temperature="40 m")
    with pytest.raises(breccia.InputError, match="no_such"):
        breccia.respond(model, materials={"no_such": binder})
    with pytest.raises(breccia.InputError, match="two rising times"):
        breccia.respond(model, binder, times=(1.0, 1e-3))
    with pytest.raises(breccia.InputError, match="particle does not vary: .* built in Python has this table as Tests"):
        breccia.respond(model, materials={"particle": binder})
    with pytest.raises(breccia.InputError, match="binder: expected a Material, .* got 3000000.0"):
        breccia.respond(model, 3e6)
    with pytest.raises(breccia.InputError, match="temperature: expected a temperature, as text .* got .300, 310."):
        breccia.respond(model, temperature=[300, 310])
    with pytest.raises(breccia.InputError, match="materials: expected materials by the names"):
        breccia.respond(model, materials=binder)
    assert again["model"].microstructure is None


def test_responses_answer_again(model, binder):
    softer = breccia.PronySeries([(0.01, 0.4e6)])
    first = breccia.respond(model, softer, times=("2 ms", "20 ms"))
    assert first.binder == model.binder == "binder" and first.materials[0].shear == softer
    back = breccia.respond(first, binder)
    assert back["model"].curve(boundary="traction")[0][[0, -1]] == pytest.approx([2e-3, 20e-3])
    known = breccia.respond(model, binder, times=("2 ms", "20 ms"))
    for boundary in ("displacement", "traction"):
        assert np.array_equal(back["model"].curve(boundary=boundary), known["model"].curve(boundary=boundary))


def test_responses_keep_other_materials(binder, particle):
    """A filler that varies keeps its new moduli where the binder is replaced afterwards."""
    stage = breccia.Stage("model", matrix=binder, box="6 mm", cells=12, fillers=breccia.Filler(particle, diameter=2e-3),
                          packing=breccia.Packing("regular", columns=2, rows=2))
    varied = {"vary": {"particle": {"shear": [10e6, 30e6], "bulk": [20e6, 80e6]}}}
    tests = breccia.Tests(times=("1 ms", "50 ms"), boundaries="traction", quasistatic=varied)
    result = breccia.solve(breccia.Study(stage, tests))
    stiffer = breccia.Material("particle", density="1.5 g/cm^3", bulk=60e6, shear=25e6)
    softer = breccia.PronySeries([(0.01, 0.4e6)])
    both = breccia.respond(result, softer, materials={"particle": stiffer})
    one = breccia.respond(breccia.respond(result, materials={"particle": stiffer}), softer)
    assert one["model"].curve()[1] == pytest.approx(both["model"].curve()[1], rel=1e-12)


def test_engineering_moduli_are_those_of_the_files(binder, particle, tmp_path):
    stage = breccia.Stage("model", matrix=binder, box="6 mm", cells=12, fillers=breccia.Filler(particle, diameter=2e-3),
                          packing=breccia.Packing("regular", columns=2, rows=2))
    tests = breccia.Tests(times=("1 ms", "50 ms"), loads=["shear", "bulk"], boundaries=["displacement", "traction"])
    result = breccia.run(breccia.Study(stage, tests), tmp_path / "run")
    columns = {"time_s": "time", "shear_modulus_Pa": "shear", "bulk_modulus_Pa": "bulk", "youngs_modulus_Pa": "young",
               "poisson_ratio": "poisson", "tensile_compliance_1_per_Pa": "tensile_compliance"}
    errors = {"bulk_modulus_error": "bulk_error", "youngs_modulus_error": "young_error",
              "poisson_ratio_error": "poisson_error"}
    with open(tmp_path / "run" / "engineering.csv") as file:
        in_time = list(csv.DictReader(line for line in file if not line.startswith("#")))
    with open(tmp_path / "run" / "engineering_dynamic.csv") as file:
        in_frequency = list(csv.DictReader(line for line in file if not line.startswith("#")))
    stored = breccia.read_results(tmp_path / "run")["model"]
    for boundary in ("displacement", "traction"):
        rows = [row for row in in_time if row["boundary"] == boundary]
        moduli = result["model"].engineering(boundary)
        for column, name in columns.items():
            written = [float(row[column]) for row in rows]
            assert written == getattr(moduli, name).tolist() == getattr(stored.engineering(boundary), name).tolist()
        for column, name in errors.items():
            written = [float(row[column] or "nan") for row in rows]
            for one in (moduli, stored.engineering(boundary), pickle.loads(pickle.dumps(moduli))):
                assert np.array_equal(written, getattr(one, name), equal_nan=True)
        rows = [row for row in in_frequency if row["boundary"] == boundary]
        assert [float(row["angular_frequency_rad_per_s"]) for row in rows] == moduli.angular_frequency.tolist()
        for column, name in (("shear", "shear"), ("bulk", "bulk"), ("youngs", "young")):
            written = [complex(float(row[f"{column}_storage_modulus_Pa"]), float(row[f"{column}_loss_modulus_Pa"]))
                       for row in rows]
            assert written == getattr(moduli, f"complex_{name}").tolist()
        assert [complex(float(row["poisson_ratio_real"]), float(row["poisson_ratio_imaginary"]))
                for row in rows] == moduli.complex_poisson.tolist()
        # E = 9 K G / (3 K + G) of the complex moduli.
        shear, bulk = moduli.complex_shear, moduli.complex_bulk
        assert moduli.complex_young == pytest.approx(9.0 * bulk * shear / (3.0 * bulk + shear))
        copy = pickle.loads(pickle.dumps(moduli))
        assert np.array_equal(copy.young, moduli.young) and np.array_equal(copy.complex_young, moduli.complex_young)
    assert not moduli.young.flags.writeable and repr(moduli).startswith("<breccia.EngineeringModuli: shear, traction")
    assert "<svg" in moduli._repr_html_() and "Poisson's ratio" in moduli._repr_html_().replace("&#x27;", "'")
    with pytest.raises(breccia.InputError, match='expected boundary="displacement" or boundary="traction"'):
        result["model"].engineering()
    with pytest.raises(breccia.InputError, match="was not tested in shear and in bulk under the boundary condition periodic"):
        result["model"].engineering("periodic")


def test_engineering_moduli_take_tests_in_shear_and_in_bulk(model):
    with pytest.raises(breccia.InputError, match="stage model: it was not tested in bulk under .* traction; .*loads="):
        model["model"].engineering("traction")
    with pytest.raises(breccia.InputError, match="boundary: expected .*got \"upper\""):
        model["model"].engineering("upper")


def test_temperature_shifts_the_curve(binder, composite):
    law = {"law": "wlf", "c1": 6.5, "c2": "120 K", "reference": "20 degC", "temperature": "20 degC"}
    binder.temperature_shift = law
    study = breccia.Study(composite, breccia.Tests(times=(1e-4, 1.0), boundaries="displacement"))
    result = breccia.solve(study)
    warm = breccia.respond(result, temperature="30 degC")
    factor = 10.0 ** (-6.5 * 10.0 / 130.0)
    series = result["model"].prony()
    time = np.array([1e-3, 1e-2, 1e-1])
    assert warm["model"].prony().at(time) == pytest.approx(series.at(time / factor), rel=1e-4)


def test_a_response_warns_as_the_study_and_of_its_temperature(binder, composite):
    """The warnings of the study are carried over, also through a pickle, and those on the materials are made anew."""
    composite.cells = 8
    tests = breccia.Tests(times=(1e-3, 1e-1), boundaries="displacement", fields="none", mixing="series")
    elastic = breccia.Material("binder", density=binder.density, bulk="1 GPa", shear="1 MPa")
    composite.matrix = elastic
    result = breccia.solve(breccia.Study(composite, tests))
    carried = [warning for warning in result.warnings if "smallest gap" in warning]
    assert carried
    for base in (result, pickle.loads(pickle.dumps(result))):
        warm = breccia.respond(base, temperature="40 degC")
        assert carried[0] in warm.warnings
        assert any("binder is elastic: its moduli do not depend on the temperature here" in warning
                   for warning in warm.warnings)
        other = breccia.respond(pickle.loads(pickle.dumps(warm)), breccia.PronySeries(equilibrium=0.97e6))
        assert carried[0] in other.warnings and not any("is elastic" in warning for warning in other.warnings)


def test_what_notebooks_show(model):
    html = model._repr_html_()
    assert "displacement" in html and "traction" in html and "<polygon" in html
    svg = html[html.index("<svg"):html.index("</svg>") + 6]
    assert ET.fromstring(svg).tag.endswith("svg")
    assert "10 ms" in html
    series = model["model"].prony(boundary="traction")
    assert "<svg" in series._repr_html_()
    assert "<svg" not in breccia.PronySeries(equilibrium=1e6)._repr_html_()
    assert "<svg" in model["model"].microstructure._repr_html_()
    assert "traction" in model["model"].test(boundary="traction")._repr_html_()
    # Within one decade the labels are 1, 2 and 5 times its power of ten.
    narrow = breccia.PronySeries([(1.0, 17e6)], equilibrium=2e6)._repr_html_()
    assert all(f">{label} MPa</text>" in narrow for label in (2, 5, 10))
    assert repr(model).startswith("<breccia.Result Model composite: stage model, in ")
    assert repr(model["model"]) == "<breccia.StageResult model: 2 tests>"
    assert repr(model["model"].microstructure) == "<breccia.Microstructure: 4 discs, 34.91 % of a box of 6 mm>"


def test_results_say_how_accurate_they_are(tmp_path):
    rubber = {"materials.binder.shear": breccia.PronySeries([(0.01, 0.5e6)], equilibrium=1e5), "stages.0.packing": {
        "method": "lubachevsky-stillinger", "walls": True, "seed": 1}, "stages.0.filler.fraction": 0.35,
              "tests.mixing": "series", "tests.volumetric": "averaged"}
    one = breccia.solve(breccia.read_study(MODEL, {**OVERRIDES, **rubber, "stages.0.cells": 60}))["model"]
    assert one.grid_error is None and 0.0 < one.expected_grid_error < 0.2
    two = breccia.run(breccia.read_study(MODEL, {**OVERRIDES, **rubber, "stages.0.cells": [30, 60]}), tmp_path)
    stage = two["model"]
    bands = [stage.test(boundary=boundary).half_bands / stage.curve(boundary=boundary)[1]
             for boundary in ("displacement", "traction")]
    assert stage.expected_grid_error is None
    assert 0.0 < stage.grid_error <= np.max(bands) * (1 + 1e-12)
    assert f"grid: error up to {100 * stage.grid_error:.2g} %" in stage.accuracy
    assert "This box: displacement and traction " in stage._repr_html_() and "packing: one seed" in stage._repr_html_()
    for same in (breccia.read_results(tmp_path)["model"], pickle.loads(pickle.dumps(two))["model"]):
        assert (same.accuracy, same.grid_error) == (stage.accuracy, stage.grid_error)
    answer = breccia.respond(two, binder=breccia.PronySeries([(0.02, 0.4e6)], equilibrium=1e5))["model"]
    assert "the whole error is unknown" in answer.accuracy and 0.0 < answer.grid_error < 0.3
    alone = breccia.respond(pickle.loads(pickle.dumps(breccia.solve(breccia.read_study(
        MODEL, {**OVERRIDES, **rubber, "stages.0.cells": 60})))), binder=breccia.PronySeries([(0.02, 0.4e6)], equilibrium=1e5))
    assert "grid: error up to about " in alone["model"].accuracy and "by a rule" in alone["model"].accuracy


def test_moduli_have_errors_by_their_causes(tmp_path):
    def solved(cells, **more):
        return breccia.run(breccia.read_study(MODEL, {
            **OVERRIDES, "materials.binder.shear": breccia.PronySeries([(0.01, 0.5e6)], equilibrium=1e5),
            "stages.0.packing": {"method": "lubachevsky-stillinger", "walls": False, "seed": 1}, "stages.0.box": "12 mm",
            "stages.0.cells": cells, "tests.boundaries": ["periodic"], "stages.0.filler.fraction": 0.35,
            "tests.volumetric": "averaged", "tests.mixing": "flow", **more}), tmp_path / str(cells),
            overwrite=True)

    result = solved([48, 96])
    test = result["model"].test()
    assert len(test.error) == len(test.time) and np.isfinite(test.error).all()
    causes = test.errors
    assert list(causes) == ["grid", "sample", "solver", "matrix"] and not causes["matrix"].any()
    assert np.allclose(causes["grid"], test.half_bands / test.modulus)
    assert np.allclose(test.error**2, sum(share**2 for share in causes.values()))
    assert (causes["sample"] > 0.005).all() and (causes["solver"] < 1e-3).all()
    assert len(result["model"].test(grid=48).error) == 0, "the result of all grids alone has errors"
    assert "\u00b1" in result._repr_html_()
    for same in (breccia.read_results(tmp_path / "[48, 96]"), pickle.loads(pickle.dumps(result))):
        assert np.array_equal(same["model"].test().error, test.error)
        assert f"error up to {100 * test.error.max():.2g} %" in same["model"].accuracy
    answer = breccia.respond(result, breccia.PronySeries([(0.02, 0.4e6)], equilibrium=2e5))["model"]
    assert np.isfinite(answer.test().error).all() and "error up to" in answer.accuracy

    walled = solved([48, 96], **{"stages.0.packing": {"method": "lubachevsky-stillinger", "walls": True, "seed": 1},
                                 "tests.boundaries": ["displacement"]})["model"].test()
    assert np.isnan(walled.error).all() and np.isnan(walled.errors["sample"]).all()
    assert np.isfinite(walled.errors["grid"]).all()


def test_errors_of_a_calculation(binder, particle, tmp_path):
    tests = breccia.Tests(times=(1e-3, 1e-2))
    full = breccia.Stage("full", matrix=binder, box="1 mm", cells=64, packing="lubachevsky-stillinger",
                         fillers=breccia.Filler(particle, diameter="0.1 mm", fraction=0.95, gap="1 um"))
    with pytest.raises(breccia.NumericalError, match="full") as error:
        breccia.pack(breccia.Study(full, tests))
    assert error.value.exit_code == 3
    large = breccia.Stage("large", matrix=binder, box="1 mm", cells=1048576)
    with pytest.raises(breccia.InputError, match="ignore_memory=True"):
        breccia.solve(breccia.Study(large, tests))
    (tmp_path / "file").write_text("")
    small = breccia.Stage("small", matrix=binder, box="1 mm", cells=4)
    with pytest.raises((breccia.FileError, breccia.InputError)):
        breccia.run(breccia.Study(small, tests), tmp_path / "file")
    with pytest.raises(breccia.InputError, match="threads"):
        breccia.solve(breccia.Study(small, tests), threads=-1)


def test_runs_do_not_replace_other_results(binder, tmp_path):
    small = breccia.Stage("small", matrix=binder, box="1 mm", cells=4)
    breccia.run(breccia.Study(small, breccia.Tests(times=(1e-3, 1e-2))), tmp_path)
    other = breccia.Study(small, breccia.Tests(times=(1e-3, 1e-1)))
    with pytest.raises(breccia.InputError, match="overwrite=True"):
        breccia.run(other, tmp_path)
    breccia.run(other, tmp_path, overwrite=True)
    breccia.run(other, tmp_path, resume=True)
    assert (tmp_path / "curves.csv").exists()
    with pytest.raises(breccia.InputError, match="only one of them"):
        breccia.run(other, tmp_path, overwrite=True, resume=True)
    breccia.pack(other, tmp_path / "packed")
    assert (tmp_path / "packed" / "small" / "microstructure.svg").exists()
