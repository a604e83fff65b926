"""Studies from decks and from Python."""

import math
import pickle
import re

import numpy as np
import pytest

import breccia
from conftest import MODEL, OVERRIDES, ROOT


def test_study_built_in_python_has_the_bits_of_its_deck(model, composite):
    tests = breccia.Tests(times=(1e-3, "50 ms"), loads=["shear"], boundaries=["displacement", "traction"],
                          volumetric="standard")
    result = breccia.solve(breccia.Study(composite, tests, title="built"))
    for boundary in ("displacement", "traction"):
        assert np.array_equal(result["model"].curve(boundary=boundary), model["model"].curve(boundary=boundary))
    assert result.title == "built"


def test_overrides_are_those_of_the_command_line():
    as_values = breccia.read_study(MODEL, OVERRIDES)
    as_lines = breccia.read_study(MODEL, ["stages.0.cells=24", 'tests.method="quasistatic"',
                                          'tests.boundaries=["displacement", "traction"]'])
    assert as_values._checked.hash == as_lines._checked.hash


def test_all_mistakes_of_a_study_are_reported_at_once(particle):
    soft = breccia.Material("binder", density="1 g/cm^3", bulk="3.6 um", shear="1 MPa", colour="red")
    stage = breccia.Stage("box", matrix=soft, box="1 mm", cells=1, fillers=breccia.Filler(particle, diameter="2 mm"),
                          packing="regular")
    with pytest.raises(breccia.InputError) as error:
        breccia.Study(stage, breccia.Tests(times=("1 s", "1 ms"), boundaries="top"))
    text = str(error.value)
    assert 'study: materials.binder.bulk: expected a pressure, got "3.6 um"' in error.value.mistakes
    for part in ('unknown key "colour"', "stages.box.cells", "tests.boundaries", "tests.times", "columns"):
        assert part in text
    assert error.value.exit_code == 2 and isinstance(error.value, ValueError)


def test_mistakes_of_a_deck_are_those_of_the_command_line(command, tmp_path):
    deck = tmp_path / "bad.toml"
    deck.write_text(MODEL.read_text().replace('"1.0 MPa"', '"1.0 um"').replace("cells   = 48", "cels = 48"))
    with pytest.raises(breccia.InputError) as error:
        breccia.read_study(deck)
    printed = command("check", deck)
    assert printed.returncode == 2
    assert str(error.value) == printed.stderr.strip()


def test_two_materials_of_one_name_are_refused(composite, particle):
    other = breccia.Material("particle", density="1 g/cm^3", bulk="1 GPa", shear="1 GPa")
    both = breccia.Stage("both", matrix=other, box="6 mm", cells=8)
    with pytest.raises(breccia.InputError, match="materials.particle: two different materials have this name"):
        breccia.Study([composite, both], breccia.Tests(times=(1e-3, 1e-2)))


@pytest.mark.parametrize("make", [
    lambda: breccia.Filler("a", diameter=1e-3, sizes=[1e-3]),
    lambda: breccia.read_study("no-such-deck.toml"),
    lambda: breccia.read_study(MODEL, {"stages.modle.cells": 3}),
    lambda: breccia.PronySeries([(1.0, -2.0)]),
    lambda: breccia.PronySeries([1.0, 2.0, 3.0]),
    lambda: breccia.quantity("3 apples", "length"),
])
def test_mistakes_of_arguments_are_input_errors(make):
    with pytest.raises(breccia.InputError):
        make()


def test_a_missing_data_file_is_named(binder, tmp_path):
    aged = breccia.Material("aged", density="1 g/cm^3", bulk="1 GPa", shear={"prony": "aged.csv"})
    with pytest.raises(breccia.InputError, match=re.escape("aged.csv")):
        breccia.Study(breccia.Stage("box", matrix=aged, box=1e-3, cells=4), breccia.Tests(times=(1e-3, 1.0)),
                      directory=tmp_path)
    with pytest.raises(breccia.InputError, match=re.escape("aged.csv")):
        aged.solid()


def test_prony_series_pass_through_a_deck_with_its_fifteen_digits():
    series = breccia.PronySeries(np.array([[1.0 / 3.0, np.pi], [1e-9, 2.0 / 7.0]]), equilibrium=0.1)
    solid = breccia.Material("m", density=1100.0, bulk=3.6e9, shear=series).solid()
    assert solid.shear.terms == pytest.approx(series.terms, rel=1e-14)
    assert solid.shear.equilibrium == 0.1
    assert solid.bulk.equilibrium == 3.6e9 and solid.density == 1100.0


def test_particles_and_images_are_given_as_arrays(binder, particle):
    places = np.array([[1.5e-3, 1.5e-3, 2e-3], [4.5e-3, 4.5e-3, 1.0e-3]])
    tests = breccia.Tests(times=(1e-3, 1e-2), boundaries="displacement")
    listed = breccia.Stage("listed", matrix=binder, box=6e-3, cells=12, fillers=breccia.Filler(particle),
                           packing=breccia.Packing(particles=places))
    box = breccia.pack(breccia.Study(listed, tests))["listed"].microstructure
    assert np.array_equal(np.column_stack([box.centres, box.diameters]), places)
    labels, particles, names = box.labels(12)
    assert labels.shape == (24, 24) and names == ["matrix", "filler"]
    assert set(np.unique(particles)) == {-1, 0, 1}

    # The top row of an image is the last one of the labels, whose y rises.
    pixels = labels[::-1] > 0
    scan = breccia.Stage("scan", matrix=binder,
                         packing=breccia.Image(pixels, pixel=0.25e-3, materials={0: binder, 1: particle}))
    box = breccia.pack(breccia.Study(scan, tests))["scan"].microstructure
    assert box.kind == "image" and box.fraction == pytest.approx(pixels.mean())
    assert np.array_equal(box.labels()[0], labels)


def test_a_grey_picture_is_divided_at_a_threshold(binder, particle):
    """A part of a noisy picture with a bar of 3 rows below it has the labels that it was made from."""
    random = np.random.default_rng(2)
    bright = np.zeros((16, 16), bool)
    bright[3:12, 4:13] = True
    picture = np.where(bright, 180, 60) + random.integers(-40, 41, bright.shape)
    picture[7, 7] = 20
    picture = np.vstack([picture, np.zeros((3, 16), int)])
    sides = {"dark": binder, "bright": particle}
    crop = {"left": 0, "top": 0, "width": 16, "height": 16}

    def pixels_of(**keys):
        scan = breccia.Stage("scan", matrix=binder,
                             packing=breccia.Image(picture, pixel=1e-6, materials=sides, crop=crop, **keys))
        return breccia.pack(breccia.Study(scan, breccia.Tests(times=(1e-3, 1e-2))))["scan"].microstructure.labels()[0]

    raw = pixels_of(threshold=120)[::-1] > 0
    assert np.array_equal(raw, picture[:16] > 120)
    assert not raw[7, 7]
    assert (pixels_of(threshold="otsu", smooth=3)[::-1] > 0)[7, 7]
    with pytest.raises(breccia.InputError, match="expected an odd number"):
        pixels_of(threshold="otsu", smooth=4)


def test_images_and_labels_of_a_cube(binder, particle):
    """The planes of an image have their top rows first, those of labels their bottom rows; z rises in both."""
    voxels = np.zeros((4, 4, 4), int)
    voxels[0, 1, 3] = voxels[2, 3, 0] = 1
    scan = breccia.Stage("scan", matrix=binder, packing=breccia.Image(voxels, pixel=1e-4, materials=[binder, particle]))
    box = breccia.pack(breccia.Study(scan, breccia.Tests(times=(1e-3, 1e-2)), dimensions=3))["scan"].microstructure
    labels = box.labels()[0]
    assert np.array_equal(labels[..., ::-1, :], voxels)
    again = breccia.Stage("scan", matrix=binder, packing=breccia.Image(
        labels[..., ::-1, :], pixel=1e-4, materials={0: binder, 1: particle}))
    box = breccia.pack(breccia.Study(again, breccia.Tests(times=(1e-3, 1e-2)), dimensions=3))["scan"].microstructure
    assert np.array_equal(box.labels()[0], labels)


def test_a_chain_of_stages(binder, particle):
    filler = breccia.Filler(particle, diameter="20 um")
    array = breccia.Packing("regular", columns=1, rows=1)
    fine = breccia.Stage("fine", matrix=binder, box="40 um", cells=8, fillers=filler, packing=array)
    coarse = breccia.Stage("coarse", matrix=fine, box="4 mm", cells=8,
                           fillers=breccia.Filler(particle, diameter="2 mm"), packing=array)
    study = breccia.Study([fine, coarse], breccia.Tests(times=(1e-3, 1e-1), boundaries="displacement"))
    result = breccia.solve(study)
    assert list(result) == ["fine", "coarse"]
    # Scaling a box changes nothing, and filler in a stiffer matrix makes a stiffer composite.
    assert np.all(result["coarse"].curve()[1] > result["fine"].curve()[1])
    assert result["fine"].solids[0].name.startswith("fine")


def test_a_study_describes_itself(composite):
    study = breccia.Study(composite, breccia.Tests(times=(1e-3, 1e-2)), title="model")
    assert repr(study) == "<breccia.Study model: stage model, 1 ms to 10 ms>"
    assert study.stages == ["model"] and study.times == (1e-3, 1e-2)
    assert [solid.name for solid in study.materials] == ["binder", "particle"]
    assert "[materials.binder]" in study.deck
    assert "matrix=" in repr(composite) and "breccia.Filler" in repr(composite.fillers)


def test_the_study_of_the_documentation_has_no_warnings():
    text = (ROOT / "docs" / "python.md").read_text()
    code = next(part for part in text.split("```python\n")[1:] if part.startswith("rubber = "))
    names = {"breccia": breccia}
    exec(code.partition("```")[0], names)  # pylint: disable=exec-used
    assert breccia.solve(names["study"]).warnings == []


def test_studies_can_be_pickled(binder, particle, tmp_path):
    read = breccia.read_study(MODEL, OVERRIDES)
    again = pickle.loads(pickle.dumps(read))
    assert again._checked.hash == read._checked.hash and again.deck == read.deck
    pixels = np.zeros((8, 8), dtype=np.uint8)
    pixels[2:6, 2:6] = 1
    scan = breccia.Stage("scan", matrix=binder,
                         packing=breccia.Image(pixels, pixel="0.1 mm", materials={0: binder, 1: particle}))
    built = breccia.Study(scan, breccia.Tests(times=(1e-3, 1e-2), boundaries="displacement"), title="built")
    state = pickle.dumps(built)
    curve = breccia.solve(built)["scan"].curve()
    del built, scan
    copied = pickle.loads(state)
    assert np.array_equal(breccia.solve(copied)["scan"].curve(), curve) and copied.title == "built"
    assert np.array_equal(breccia.solve(pickle.loads(pickle.dumps(copied)))["scan"].curve(), curve)
    deck = tmp_path / "deck.toml"
    deck.write_text(copied.deck)
    state = pickle.dumps(breccia.read_study(deck))
    deck.write_text(deck.read_text().replace('"built"', '"other"').replace("0.01 s", "0.02 s"))
    with pytest.raises(breccia.InputError, match="has changed since the study was pickled"):
        pickle.loads(state)


def test_overrides_are_named_as_arguments():
    with pytest.raises(breccia.InputError) as error:
        breccia.read_study(MODEL, {"stages.modle.cells": 3, "tests.method": "slow"})
    assert any(line.startswith("overrides stages.modle.cells=3: ") for line in error.value.mistakes)
    assert any(line.startswith("overrides tests.method=\"slow\": ") for line in error.value.mistakes)
    assert "--set" not in str(error.value)


def test_a_plan_has_time_memory_and_the_error_of_the_grid(command):
    # A binder that falls to nothing, as that of the deck, has no rule for the error.
    keys = {"tests.method": "quasistatic", "materials.binder.shear.equilibrium": "0.1 MPa"}
    study = breccia.read_study(MODEL, keys)
    plan = breccia.plan(study)
    (stage,) = plan.stages
    assert plan.seconds == pytest.approx(sum(test.seconds for test in stage.tests))
    assert plan.memory == max(test.memory for test in stage.tests)
    assert plan["model"].cells_for(0.01) > plan["model"].cells_for(0.05)
    finer = breccia.plan(breccia.read_study(MODEL, keys | {"stages.model.cells": 96}))
    assert finer.seconds > plan.seconds and finer.memory > plan.memory
    resolved = keys | {"stages.model.cells": math.ceil(plan["model"].cells_for(0.05))}
    assert breccia.plan(breccia.read_study(MODEL, resolved))["model"].grid_error <= 0.05
    assert breccia.plan(breccia.read_study(MODEL, {"tests.method": "quasistatic"}))["model"].grid_error is None
    with pytest.raises(KeyError):
        plan["another"]
    with pytest.raises(breccia.InputError, match="between 0 and 1"):
        plan["model"].cells_for(2.0)
    with pytest.raises(breccia.InputError, match="expected a Study"):
        breccia.plan(str(MODEL))
