"""What becomes of a report that a signal ends, and of its worker processes."""

import ctypes
import multiprocessing
import os
import shutil
import signal

_ENDING = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)

_removed = []  # folders


def watch():
    """From here on a signal that would end the program, unless it is ignored, removes what
    is unfinished first, and says so. It ends the program where it comes: an exception could
    be lost where a library calls back from C."""
    for number in _ENDING:
        if signal.getsignal(number) != signal.SIG_IGN:
            signal.signal(number, _end)


def remove_when_interrupted(folder):
    _removed.append(folder)


def ignore():
    """What began will be done, in a moment."""
    for number in _ENDING:
        signal.signal(number, signal.SIG_IGN)


def leave_to_parent(parent):
    """For a worker of that process, which ends it; so does Linux where the parent is
    killed, since its workers would keep the folder's lock."""
    ctypes.CDLL(None).prctl(1, signal.SIGKILL)  # PR_SET_PDEATHSIG
    if os.getppid() != parent:
        os._exit(1)
    for number in (signal.SIGINT, signal.SIGHUP):
        signal.signal(number, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)


def _end(number, frame):
    ignore()  # a terminal and the program above may both ask for it
    for worker in multiprocessing.active_children():
        worker.kill()
    for folder in _removed:
        shutil.rmtree(folder, ignore_errors=True)
    os.write(2, b"springcheck: interrupted; an earlier report is as it was\n")
    os._exit(130)
