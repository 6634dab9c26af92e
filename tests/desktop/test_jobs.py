"""The job manager: started, cancelled, finished in any order."""

from __future__ import annotations

import gc
import threading
import time
from typing import Any

import numpy as np
import pytest
from hypothesis import settings as hypothesis_settings
from hypothesis.stateful import RuleBasedStateMachine, invariant, precondition, rule
from PySide6.QtCore import QEventLoop, QTimer
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from seacruise.desktop import thrift
from seacruise.desktop.jobs import GarbageKeeper, JobRunner
from seacruise.errors import CancelledError, WeatherError
from seacruise.progress import Job


def test_what_breaks_after_it_was_cancelled_is_no_fault(
    qtbot: QtBot, caplog: pytest.LogCaptureFixture
) -> None:
    runner = JobRunner("late")
    begun, gate = threading.Event(), threading.Event()

    def work(_job: Job) -> None:
        begun.set()
        assert gate.wait(10)
        raise RuntimeError("cannot schedule new futures after shutdown")

    runner.run_job(work)
    assert begun.wait(10)
    runner.cancel()
    gate.set()
    runner.shut_down()
    assert not runner.has_workers
    assert not caplog.records


def test_a_result_arrives_on_the_windows_thread(qtbot: QtBot) -> None:
    runner, threads = JobRunner("test"), []
    runner.finished.connect(lambda *_: threads.append(threading.current_thread()))
    with qtbot.waitSignal(runner.finished) as signal:
        generation = runner.run_job(lambda _job: "found")
    assert signal.args == [generation, "found"]
    assert threads == [threading.main_thread()]
    assert not runner.is_running


def test_an_error_is_handed_over_as_it_is(qtbot: QtBot) -> None:
    runner, error = JobRunner("test"), WeatherError("Quota spent.", reason="quota")

    def work(_job: Job) -> None:
        raise error

    with qtbot.waitSignal(runner.failed) as signal:
        runner.run_job(work)
    assert signal.args is not None
    assert signal.args[1] is error


def test_a_mistake_of_the_program_becomes_one_sentence(
    qtbot: QtBot, caplog: pytest.LogCaptureFixture
) -> None:
    runner = JobRunner("test")

    def work(_job: Job) -> None:
        raise ZeroDivisionError("secret detail")

    with qtbot.waitSignal(runner.failed) as signal:
        runner.run_job(work)
    assert signal.args is not None
    assert signal.args[1].reason == "internal"
    assert "ZeroDivisionError" in str(signal.args[1])
    assert "secret detail" not in str(signal.args[1])
    assert "secret detail" in caplog.text


def test_a_storm_of_reports_wakes_the_window_seldom(qtbot: QtBot) -> None:
    runner, seen = JobRunner("test"), []
    runner.progressed.connect(lambda *report: seen.append(report))

    def work(job: Job) -> None:
        for n in range(20_000):
            job.report("search", n / 20_000, str(n))

    with qtbot.waitSignal(runner.finished):
        runner.run_job(work)
    assert 1 <= len(seen) < 2_000
    assert [s[2] for s in seen] == sorted(s[2] for s in seen)


def test_nothing_arrives_after_shut_down(qtbot: QtBot) -> None:
    runner, arrived = JobRunner("test"), []
    for signal in (runner.finished, runner.failed, runner.progressed):
        signal.connect(lambda *_: arrived.append(1))
    gate = threading.Event()

    def work(job: Job) -> None:
        gate.wait(5)
        job.report("sea", None, "")

    runner.run_job(work)
    QTimer.singleShot(20, gate.set)
    gate.set()
    runner.shut_down()
    qtbot.wait(50)
    assert not arrived
    assert not [t for t in threading.enumerate() if t.name.startswith("test-")]


def test_a_worker_that_hangs_does_not_keep_the_window(qtbot: QtBot) -> None:
    runner, gate = JobRunner("stuck"), threading.Event()
    runner.run_job(lambda _job: gate.wait(30))
    begun = time.monotonic()
    runner.shut_down(patience_s=0.05)
    assert time.monotonic() - begun < 5.0
    del runner
    gc.collect()
    gate.set()
    qtbot.wait(50)


def test_garbage_is_collected_by_the_windows_thread_only(qtbot: QtBot) -> None:
    keeper = GarbageKeeper(lambda: False)
    keeper.start()
    try:
        assert not gc.isenabled()
    finally:
        keeper.stop()
    assert gc.isenabled()
    assert gc.get_freeze_count() == 0


class JobManager(RuleBasedStateMachine):
    """Whatever is started, cancelled and finished: only the present job's result arrives, and once."""

    def __init__(self) -> None:
        super().__init__()
        self.app = QApplication.instance() or QApplication([])
        self.runner = JobRunner("machine")
        self.arrived: list[tuple[int, Any]] = []
        self.expected: list[tuple[int, Any]] = []
        self.gates: dict[int, threading.Event] = {}
        self.fails: dict[int, bool] = {}
        self.present: int | None = None
        self.runner.finished.connect(lambda generation, value: self.arrived.append((generation, value)))
        self.runner.failed.connect(lambda generation, error: self.arrived.append((generation, str(error))))

    @rule()
    def start(self) -> None:
        gate = threading.Event()
        number = len(self.gates) + 1

        def work(job: Job) -> str:
            gate.wait(10)
            if self.fails.get(number):
                raise WeatherError(f"failure {number}")
            return f"result {number}"

        generation = self.runner.run_job(work)
        assert generation == number
        self.gates[generation], self.present = gate, generation

    @precondition(lambda self: self.present is not None)
    @rule()
    def cancel(self) -> None:
        assert self.runner.cancel()
        self.present = None

    @precondition(lambda self: self.present is None)
    @rule()
    def cancel_nothing(self) -> None:
        assert not self.runner.cancel()

    @precondition(lambda self: self.present is not None)
    @rule()
    def finish(self) -> None:
        self._let_go(self.present, fails=False)

    @precondition(lambda self: self.present is not None)
    @rule()
    def fail(self) -> None:
        self._let_go(self.present, fails=True)

    @precondition(lambda self: bool(self.gates))
    @rule()
    def finish_those_dropped(self) -> None:
        for generation, gate in self.gates.items():
            if generation != self.present:
                gate.set()
        self._run_events(0.005)

    def _let_go(self, generation: int | None, *, fails: bool) -> None:
        assert generation is not None
        self.fails[generation] = fails
        self.expected.append((generation, f"{'failure' if fails else 'result'} {generation}"))
        self.gates[generation].set()
        self.present = None
        deadline = time.monotonic() + 10
        while len(self.arrived) < len(self.expected) and time.monotonic() < deadline:
            self._run_events(0.002)

    def _run_events(self, seconds: float) -> None:
        loop = QEventLoop()
        QTimer.singleShot(round(seconds * 1000), loop.quit)
        loop.exec()

    @invariant()
    def only_what_was_awaited_arrived(self) -> None:
        assert self.arrived == self.expected

    @invariant()
    def it_knows_whether_it_runs(self) -> None:
        assert self.runner.is_running == (self.present is not None)

    def teardown(self) -> None:
        for gate in self.gates.values():
            gate.set()
        self.runner.shut_down()


TestJobManager = JobManager.TestCase
TestJobManager.settings = hypothesis_settings(max_examples=25, stateful_step_count=12, deadline=None)


def test_a_cancelled_job_is_no_failure(qtbot: QtBot) -> None:
    runner, failures = JobRunner("test"), []
    runner.failed.connect(lambda *_: failures.append(1))

    def work(_job: Job) -> None:
        raise CancelledError

    runner.run_job(work)
    qtbot.waitUntil(lambda: not runner.is_running)
    assert not failures


def test_memory_is_given_back_on_any_system() -> None:
    numbers = np.arange(1_000_000, dtype=np.float64)
    thrift.share_arenas()
    thrift.give_back()
    assert numbers.sum() == 999_999 * 500_000
