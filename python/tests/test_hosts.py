"""The module as a guest: signals, threads, progress, MPI that a host has started."""

import io
import os
import signal
import subprocess
import sys
import textwrap
import threading
import types

import numpy as np
import pytest

import breccia
from breccia import _progress
from conftest import MODEL, OVERRIDES

LONG = {"stages.0.cells": 500, "tests.method": "dynamic"}


def ctrl_c_when_working(study, calculate):
    """Sends Ctrl-C to this process, from another thread, soon after the first sign of progress."""
    # A process that was started in the background of a shell ignores the signal, and so does Python then.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    is_working = threading.Event()

    def interrupt():
        if is_working.wait(60):
            os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=interrupt)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        calculate(study, lambda *_: is_working.set())
    thread.join()
    signal.signal(signal.SIGINT, before)


def test_ctrl_c_ends_a_solution():
    ctrl_c_when_working(breccia.read_study(MODEL, LONG), lambda study, show: breccia.solve(study, progress=show))


def test_ctrl_c_ends_a_run_with_a_checkpoint(tmp_path):
    study = breccia.read_study(MODEL, LONG)
    ctrl_c_when_working(study, lambda study, show: breccia.run(study, tmp_path, progress=show))
    assert list(tmp_path.rglob("*checkpoint*"))


def test_a_limit_of_time_ends_a_run(tmp_path):
    with pytest.raises(breccia.Interrupted, match="resume=True"):
        breccia.run(breccia.read_study(MODEL, LONG), tmp_path, time_limit="0.2 s")


def test_an_error_of_the_progress_function_ends_a_solution():
    def fail(what, share, details):
        raise RuntimeError(what)

    with pytest.raises(RuntimeError, match="model shear, displacement, 500 cells, dynamic"):
        breccia.solve(breccia.read_study(MODEL, LONG), progress=fail)


def test_threads_of_python_wait_for_each_other(model):
    study = breccia.read_study(MODEL, OVERRIDES)
    results = {}
    threads = [threading.Thread(target=lambda n=n: results.update({n: breccia.solve(study)})) for n in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for result in results.values():
        assert np.array_equal(result["model"].curve(boundary="traction"), model["model"].curve(boundary="traction"))
    assert len(results) == 3


def test_threads_of_different_calculations_wait_for_each_other(tmp_path):
    study = breccia.read_study(MODEL, OVERRIDES)
    results = []
    threads = [threading.Thread(target=lambda: results.append(breccia.solve(study))),
               threading.Thread(target=lambda: results.append(breccia.run(study, tmp_path / "one"))),
               threading.Thread(target=lambda: results.append(breccia.run(study, tmp_path / "other")))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(results) == 3
    assert (tmp_path / "one" / "curves.csv").read_bytes() == (tmp_path / "other" / "curves.csv").read_bytes()


def test_a_calculation_cannot_start_another_from_its_progress():
    study = breccia.read_study(MODEL, LONG)
    with pytest.raises(breccia.InputError, match="by a function that another one calls"):
        breccia.solve(study, progress=lambda *of: breccia.solve(study, progress=False))


class Terminal(io.StringIO):
    def isatty(self):
        return True


def test_a_thread_that_still_calculates_at_the_end_does_no_harm():
    ended = run_python("""
        import threading, time, breccia
        study = breccia.read_study(MODEL, {**OVERRIDES, "stages.0.cells": 300, "tests.method": "quasistatic"})
        working = threading.Event()
        threading.Thread(target=lambda: breccia.solve(study, progress=lambda *_: working.set()), daemon=True).start()
        assert working.wait(60)
    """)
    assert ended.returncode == 0, ended.stderr
    assert "MPI_ABORT" not in ended.stderr and "PETSC" not in ended.stderr


def test_terminals_show_a_line_that_goes(monkeypatch):
    terminal = Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    monkeypatch.setattr(_progress, "_PATIENCE", 0.0)
    with _progress.shown(None) as show:
        show("model: packing", 0.25, "100 events")
    assert "model: packing [#####...............] 25 %, 100 events" in terminal.getvalue()
    assert terminal.getvalue().endswith("\r\x1b[K")


def test_files_and_pipes_show_nothing(monkeypatch):
    monkeypatch.setattr(sys, "stderr", io.StringIO())
    with _progress.shown(None) as show:
        assert show is None
    with _progress.shown(False) as show:
        assert show is None


def test_notebooks_show_a_bar_that_goes(monkeypatch):
    shown = []
    handle = types.SimpleNamespace(update=shown.append)
    display = types.ModuleType("IPython.display")
    display.HTML = str
    display.display = lambda text, display_id: shown.append(text) or handle
    ipython = types.ModuleType("IPython")
    ipython.get_ipython = lambda: types.SimpleNamespace(kernel=object())
    monkeypatch.setitem(sys.modules, "IPython", ipython)
    monkeypatch.setitem(sys.modules, "IPython.display", display)
    monkeypatch.setattr(_progress, "_PATIENCE", 0.0)
    with _progress.shown(None) as show:
        show("model: packing", 0.25, "100 <events>")
        show("model: packing", 0.5, "200 events")
    assert 'value="0.250"' in shown[0] and "100 &lt;events&gt;" in shown[0]
    assert "50 %" in shown[1] and shown[-1] == ""


def run_python(code):
    environment = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    code = f"MODEL = {str(MODEL)!r}\nOVERRIDES = {OVERRIDES!r}\n" + textwrap.dedent(code)
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=environment, timeout=120,
                          check=False)


@pytest.mark.parametrize("code", [
    # MPI of the host first, which it ends itself, by mpi4py after the interpreter
    """
    from mpi4py import MPI
    import breccia
    breccia.solve(breccia.read_study(MODEL, OVERRIDES))
    assert MPI.Is_initialized() and not MPI.Is_finalized()
    assert MPI.COMM_WORLD.allreduce(2) == 2
    print("done")
    """,
    # Breccia first
    """
    import breccia
    breccia.solve(breccia.read_study(MODEL, OVERRIDES))
    from mpi4py import MPI
    assert MPI.COMM_WORLD.allreduce(2) == 2
    print("done")
    """,
    # A host that ends MPI by itself, early
    """
    from mpi4py import MPI
    import breccia
    breccia.solve(breccia.read_study(MODEL, OVERRIDES))
    MPI.Finalize()
    print("done")
    """,
])
def test_beside_mpi_of_a_host(code):
    pytest.importorskip("mpi4py")
    finished = run_python(code)
    assert finished.stdout == "done\n" and finished.returncode == 0, finished.stderr
    assert "MPI" not in finished.stderr


def test_numpy_keeps_the_threads_of_its_blas():
    finished = run_python("""
    import ctypes, numpy
    library = ctypes.CDLL(next(line.split()[-1] for line in open("/proc/self/maps") if "openblas" in line or "blas.so" in line))
    try:
        library.openblas_set_num_threads(2)
    except AttributeError:
        print(2)
        raise SystemExit
    import breccia
    breccia.solve(breccia.read_study(MODEL, OVERRIDES))
    print(library.openblas_get_num_threads())
    """)
    assert finished.stdout == "2\n", finished.stderr
