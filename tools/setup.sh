#!/bin/sh
# Finds a Python from 3.11 on and makes .venv ready with it: tools/setup.sh [dev] [bench]
cd "$(dirname "$0")/.." || exit 1

# The usual case, instantly: everything is there and up to date.
if [ -x .venv/bin/python ] && .venv/bin/python tools/setup_venv.py --check "$@" 2>/dev/null; then
    exit 0
fi

new_enough='import sys; sys.exit(sys.version_info < (3, 11))'
complete='import sys, venv, ensurepip; sys.exit(sys.version_info < (3, 11))'
# First one that can make environments; failing that one that can at least say what it lacks.
for probe in "$complete" "$new_enough"; do
    for python in ${PYTHON:-} python3.14 python3.13 python3.12 python3.11 python3 python; do
        if "$python" -c "$probe" >/dev/null 2>&1; then
            exec "$python" tools/setup_venv.py "$@"
        fi
    done
done
echo "SeaCruise needs Python 3.11 or newer and found none on the PATH; install one (python.org, or" >&2
echo "'apt-get install python3 python3-venv' on Debian or Ubuntu), or name it: make PYTHON=/path/to/python" >&2
exit 1
