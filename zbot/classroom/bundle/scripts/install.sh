#!/usr/bin/env bash
# Installs zbot from this folder. `bash install.sh --to FOLDER` chooses the folder of the environment.
here=$(dirname "$0")
for python in python3 python python3.14 python3.13 python3.12 python3.11 python3.10; do
    if "$python" -c "import sys; sys.exit(sys.version_info < (3, 10))" 2>/dev/null; then
        exec "$python" "$here/install.py" "$@"
    fi
done
echo "error: there is no Python 3.10 or newer: install it from python.org, or with the packages of your system" >&2
exit 1
